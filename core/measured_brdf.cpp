// SPDX-License-Identifier: Apache-2.0
#include "core/measured_brdf.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/angle.h"
#include "core/elementary.h"
#include "core/microfacet.h"

namespace twinray {
namespace {

/// Azimuth in turns from -x, in [0, 1).
double azimuth_turns(const Vec3& w) {
  const double turns = atan2_turns(double(w.y), double(w.x)) + 0.5;
  return turns - std::floor(turns);
}

/// Angle from +z in turns; w.z >= 0.
double polar_turns(const Vec3& w) {
  return atan2_turns(std::sqrt(double(w.x) * double(w.x) + double(w.y) * double(w.y)), double(w.z));
}

/// A direction's place in the square, with the azimuth relative to one of so many turns; w.z >= 0. Squared,
/// x is the angle from the normal in quarters of a turn: there is more room for small angles.
Vec2 square_of(const Vec3& w, double turns) {
  const double y = azimuth_turns(w) - turns;
  return {float(std::min(std::sqrt(4 * polar_turns(w)), 1.0)), float(std::min(y - std::floor(y), 1.0))};
}

Vec3 direction_of(Vec2 place, double turns) {
  const double y = double(place.y) - 0.5 + turns;
  const SinCos polar = sincos_turns(0.25f * place.x * place.x);
  const SinCos azimuth = sincos_turns(float(y - std::floor(y)));
  return {polar.sin * azimuth.cos, polar.sin * azimuth.sin, polar.cos};
}

/// Solid angle per area of the square at the place of a direction: theta is pi/2 x^2, phi 2 pi y.
double solid_angle(Vec2 place, const Vec3& w) {
  const double sine = std::sqrt(double(w.x) * double(w.x) + double(w.y) * double(w.y));
  return 2 * pi_double * pi_double * double(place.x) * sine;
}

/// Between which of some increasing values one lies, and how far from the lower one to the next; the first
/// or the last beyond them.
struct Interval {
  std::size_t lower;
  double part;
};
Interval interval(const std::vector<float>& values, double value) {
  if (values.size() == 1 || value <= double(values.front())) return {0, 0};
  const auto upper = std::upper_bound(values.begin(), values.end() - 1, value,
                                      [](double v, float each) { return v < double(each); });
  const double high = double(*upper), low = double(*(upper - 1));
  return {std::size_t(upper - 1 - values.begin()), std::min((value - low) / (high - low), 1.0)};
}

void check_increasing(const std::vector<float>& angles, float least, float most, const char* name) {
  if (angles.empty()) throw Error(std::string("a measurement without ") + name);
  for (std::size_t i = 0; i < angles.size(); ++i)
    if (!(angles[i] >= least && angles[i] <= most) || (i > 0 && !(angles[i - 1] < angles[i])))
      throw Error(std::string("the angles of a measurement's ") + name +
                  " do not increase within their range");
}

void check_slices(std::size_t found, std::size_t needed, const char* name) {
  if (found != needed)
    throw Error("the number of slices in the table " + std::string(name) + " of a measurement is " +
                std::to_string(found) + "; it must be " + std::to_string(needed));
}

void check_numbers(const std::vector<float>& numbers, const char* name) {
  if (std::any_of(numbers.begin(), numbers.end(), [](float x) { return !(x >= 0) || !std::isfinite(x); }))
    throw Error(std::string("the table ") + name +
                " of a measurement has a number that is negative or not "
                "finite");
}

/// How often azimuths fit into the circle.
int folds_of(const std::vector<float>& phi) {
  if (phi.size() <= 2) return 1;
  const double times = std::round(2 * pi_double / double(phi.back() - phi.front()));
  if (times != 1 && times != 2 && times != 4)
    throw Error("the azimuths of a measurement must go around the circle, a half or a quarter of it");
  return int(times);
}

/// Around the circle, with room for rounding.
constexpr float most_phi = 6.2832f, most_theta = 1.5709f;

}  // namespace

MeasuredBrdf::MeasuredBrdf(BrdfMeasurement m)
    : phi_(std::move(m.phi)),
      theta_(std::move(m.theta)),
      ndf_(std::move(m.ndf)),
      sigma_(std::move(m.sigma)),
      vndf_(m.vndf),
      luminance_(m.luminance),
      reflected_(std::move(m.reflected)),
      is_relative_to_facets_(m.is_relative_to_facets) {
  check_increasing(phi_, -most_phi, most_phi, "phi");
  check_increasing(theta_, 0, most_theta, "theta");
  folds_ = folds_of(phi_);
  check_slices(ndf_.slices(), 1, "ndf");
  check_slices(sigma_.slices(), 1, "sigma");
  const std::size_t directions = phi_.size() * theta_.size();
  check_slices(vndf().slices(), directions, "vndf");
  check_slices(luminance().slices(), directions, "luminance");
  check_slices(reflected_.slices(), directions, "reflected");
  check_numbers(ndf_.values(), "ndf");
  check_numbers(sigma_.values(), "sigma");
  for (const Rgb& value : reflected_.values())
    if (!is_finite(value) || value.r < 0 || value.g < 0 || value.b < 0)
      throw Error("what a measured material reflects is negative or not finite");
  albedo_ = mean_albedo();
}

std::size_t MeasuredBrdf::bytes() const {
  const std::size_t densities = vndf().values().size() + luminance().values().size();
  return sizeof(float) *
             (phi_.size() + theta_.size() + ndf_.values().size() + sigma_.values().size() + 2 * densities) +
         sizeof(Rgb) * reflected_.values().size();
}

MeasuredBrdf::Seen MeasuredBrdf::seen(const Vec3& wo) const {
  Seen from{wo, 1, 1, {}, 0};
  if (folds_ > 1) {  // The azimuths that were measured begin at -x.
    from.sign_y = wo.y > 0 ? -1 : 1;
    from.sign_x = folds_ == 4 ? (wo.x > 0 ? -1.0f : 1.0f) : from.sign_y;
    from.wo = {wo.x * from.sign_x, wo.y * from.sign_y, wo.z};
  }
  const double azimuth = azimuth_turns(from.wo);
  if (!is_anisotropic()) from.turns = azimuth - 0.5;
  const Interval phi = interval(phi_, (azimuth - 0.5) * 2 * pi_double);
  const Interval theta = interval(theta_, polar_turns(from.wo) * 2 * pi_double);
  from.blend.count = 0;
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j) {
      const double weight = (i ? phi.part : 1 - phi.part) * (j ? theta.part : 1 - theta.part);
      if (!(weight > 0)) continue;
      from.blend.slices[from.blend.count] = std::uint32_t((phi.lower + i) * theta_.size() + theta.lower + j);
      from.blend.weights[from.blend.count++] = weight;
    }
  return from;
}

BsdfValue MeasuredBrdf::evaluate(const Seen& from, const Vec3& wi) const {
  const Vec3 m = normalize(from.wo + wi);
  const Vec2 place = square_of(m, from.turns);
  const auto [u, visible] = vndf_.invert(place, from.blend);
  Rgb value = reflected_.at(u, from.blend);
  if (is_relative_to_facets_) {
    const float area = sigma_.at(square_of(from.wo, 0));
    if (!(area > 0)) return {};
    value = value * (ndf_.at(place) / (4 * area));
  }
  const double per_direction = solid_angle(place, m) * 4 * double(dot(from.wo, m));
  const double pdf = double(visible) * double(luminance_.pdf(u, from.blend)) / per_direction;
  value = value / wi.z;
  if (!(pdf > 0) || !(pdf < 1e30) || !is_finite(value)) return {};
  return {value, float(pdf)};
}

BsdfValue MeasuredBrdf::evaluate(const Vec3& wo, const Vec3& wi) const {
  if (!(wo.z > 0 && wi.z > 0)) return {};
  const Seen from = seen(wo);
  return evaluate(from, {wi.x * from.sign_x, wi.y * from.sign_y, wi.z});
}

BsdfSample MeasuredBrdf::sample(const Vec3& wo, Vec2 u) const {
  if (!(wo.z > 0)) return {};
  const Seen from = seen(wo);
  const Vec2 bright = luminance_.sample(u, from.blend).point;
  const Vec3 m = direction_of(vndf_.sample(bright, from.blend).point, from.turns);
  const Vec3 wi = twinray::reflected(from.wo, m);
  if (!(wi.z > 0)) return {};
  const auto [value, pdf] = evaluate(from, wi);
  return {.wi = {wi.x * from.sign_x, wi.y * from.sign_y, wi.z}, .value = value, .pdf = pdf};
}

Rgb MeasuredBrdf::mean_albedo() const {
  constexpr int steps = 16;
  const Vec3 wo{std::sqrt(0.5f), 0, std::sqrt(0.5f)};
  Rgb sum;
  for (int y = 0; y < steps; ++y)
    for (int x = 0; x < steps; ++x) {
      const BsdfSample s = sample(wo, {(float(x) + 0.5f) / steps, (float(y) + 0.5f) / steps});
      if (s.pdf > 0) sum += s.value * (s.wi.z / s.pdf);
    }
  const Rgb mean = sum / float(steps * steps);
  return {std::min(mean.r, 1.0f), std::min(mean.g, 1.0f), std::min(mean.b, 1.0f)};
}

}  // namespace twinray
