// SPDX-License-Identifier: Apache-2.0
#include "integrators/medium_glow.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/blackbody.h"
#include "core/elementary.h"
#include "core/interiors.h"
#include "integrators/channels.h"
#include "integrators/medium_column.h"

namespace twinray {
namespace {

/// By so many points of a way its uneven light is estimated.
constexpr int points_seen = 8;

/// Below it, what an exponential function loses to rounding is more than what its series leaves out.
constexpr float thin = 0.1f;

/// The integral of e^(-extinction a) over a from 0 to `amount`, which may be infinite. Nothing is emitted
/// where nothing is absorbed.
float dimmed_amount(float extinction, float amount) {
  if (!(extinction >= least_extinction)) return 0;
  const float x = extinction * amount;
  if (!(x < thin)) return (1 - exp_of(-x)) / extinction;
  return amount * (1 - x / 2 * (1 - x / 3 * (1 - x / 4 * (1 - x / 5))));
}

/// The amount up to which the part u of that integral lies.
float amount_at(float extinction, float amount, float u) {
  const float x = extinction * amount;
  if (x < 0.01f * thin) return amount * u * (1 - (1 - u) * x / 2);
  return std::min(-log_of(1 - u * (1 - exp_of(-x))) / extinction, amount);
}

/// What the glow at a point is times that of an even one.
Rgb glow_at(const Scene& scene, const Glow& glow, const Vec3& point) {
  Rgb factor{1, 1, 1};
  if (glow.factor != no_density) factor = factor * float(scene.densities[glow.factor]->at(point));
  if (glow.temperature == no_density || is_black(factor)) return factor;
  const double number = scene.densities[glow.temperature]->at(point);
  return factor * blackbody_glow((number - double(glow.temperature_offset)) * double(glow.temperature_scale));
}

}  // namespace

Rgb medium_glow(const Scene& scene, const Interior& medium, const Ray& ray, float t, float u) {
  const Rgb extinction = medium.extinction(), emission = medium.emission();
  const MediumColumn column(scene, medium, ray, t);
  const float amount = column.amount();
  if (!(amount > 0)) return {};
  const Rgb even = emission * Rgb{dimmed_amount(extinction.r, amount), dimmed_amount(extinction.g, amount),
                                  dimmed_amount(extinction.b, amount)};
  const float sum = sum_of(even);
  if (!medium.glow.is_uneven() || !(sum > 0)) return even;

  float amounts[points_seen];
  for (int i = 0; i < points_seen; ++i) {
    const auto [channel, rest] = choose_channel(even / sum, (float(i) + u) / points_seen);
    amounts[i] = amount_at(channel_of(extinction, channel), amount, rest);
  }
  std::sort(std::begin(amounts), std::end(amounts));
  Rgb glow;
  Ray on = ray;  // From the last point.
  float before = 0;
  for (const float at : amounts) {
    const Rgb there = emission * transmittance(extinction, at);
    if (!(sum_of(there) > 0)) break;  // Nor is anything seen of what lies behind.
    const float distance = MediumColumn(scene, medium, on, t).reach(at - before).distance;
    // Where rounding has it beyond the end, the last point stands for this one.
    if (std::isfinite(distance)) on.t_min = std::min(on.t_min + distance / length(ray.direction), t);
    before = at;
    glow += there * (sum / sum_of(there)) * glow_at(scene, medium.glow, on.origin + on.direction * on.t_min);
  }
  return glow / points_seen;
}

}  // namespace twinray
