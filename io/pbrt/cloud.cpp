// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/cloud.h"

#include <algorithm>
#include <vector>

#include "core/noise.h"
#include "core/parallel.h"

namespace twinray {
namespace {

/// The gradient of noise, by differences as pbrt takes them.
Vec3 noise_slope(const Vec3& p) {
  constexpr float step = 0.01f;
  const float here = noise(p);
  return Vec3{noise(p + Vec3{step, 0, 0}) - here, noise(p + Vec3{0, step, 0}) - here,
              noise(p + Vec3{0, 0, step}) - here} /
         step;
}

constexpr int octaves = 5;
constexpr float finer = 1.99f;

}  // namespace

float PbrtCloud::at(const Vec3& p) const {
  if (p.y <= 0) return 1;
  if (p.y >= 1) return 0;
  Vec3 place = p * frequency;
  if (wispiness > 0) {
    float strength = 0.05f * wispiness, fineness = 10;
    for (int i = 0; i < 2; ++i) {
      place = place + noise_slope(place * fineness) * strength;
      strength *= 0.5f;
      fineness *= finer;
    }
  }
  float sum = 0, strength = 0.5f, fineness = 1;
  for (int i = 0; i < octaves; ++i) {
    sum += strength * noise(place * fineness);
    strength *= 0.5f;
    fineness *= finer;
  }
  const float thinned = std::clamp((1 - p.y) * 4.5f * density * sum, 0.0f, 1.0f);
  return std::clamp(thinned + 2 * std::max(0.0f, 0.5f - p.y), 0.0f, 1.0f);
}

DensityGrid cloud_grid(const PbrtCloud& cloud, const Aabb& box, const Transform& to_unit) {
  constexpr float most = 192, cells_a_wave = 2.5f, finest = 15.7f;  // As the last octave is.
  const Vec3 extent = box.extent();
  const auto cells = [&](float edge) {
    return int(std::clamp(edge * cloud.frequency * finest * cells_a_wave, 8.0f, most));
  };
  const DensityGrid::Size size{cells(extent.x), cells(extent.y), cells(extent.z)};
  const auto at = [](float low, float edge, int cell, int number) {
    return low + edge * (float(cell) + 0.5f) / float(number);
  };
  const std::size_t row = std::size_t(size[0]), slice = row * std::size_t(size[1]);
  std::vector<float> values(slice * std::size_t(size[2]));
  parallel_for(std::size_t(size[2]), 1, 0, [&](std::size_t first, std::size_t last) {
    for (std::size_t z = first; z < last; ++z)
      for (int y = 0; y < size[1]; ++y)
        for (int x = 0; x < size[0]; ++x)
          values[z * slice + std::size_t(y) * row + std::size_t(x)] =
              cloud.at({at(box.lower.x, extent.x, x, size[0]), at(box.lower.y, extent.y, y, size[1]),
                        at(box.lower.z, extent.z, int(z), size[2])});
  });
  return DensityGrid(size, values, to_unit);
}

}  // namespace twinray
