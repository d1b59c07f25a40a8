// SPDX-License-Identifier: Apache-2.0
#include "integrators/medium_glow.h"

#include <cmath>
#include <limits>

#include "core/blackbody.h"
#include "tests/support/catch.h"
#include "tests/support/random.h"

namespace twinray::test {
namespace {

constexpr Ray along_z{.origin = {0.4f, 0.6f, -1}, .direction = {0, 0, 2}};

std::shared_ptr<const DensityGrid> grid_of(const std::vector<float>& values) {
  return std::make_shared<const DensityGrid>(DensityGrid::Size{1, 1, int(values.size())}, values,
                                             Transform{});
}

/// By many small steps along the ray, up to its parameter t.
Rgb by_steps(const Scene& scene, const Interior& medium, float t) {
  constexpr int steps = 20000;
  double depth[3] = {}, sum[3] = {};
  const double step = double(t) / steps, length = 2 * step;
  for (int i = 0; i < steps; ++i) {
    const Vec3 point = along_z.origin + along_z.direction * float((i + 0.5) * step);
    const double density = medium.density == no_density ? 1 : scene.densities[medium.density]->at(point);
    const Glow& glow = medium.glow;
    const double factor = glow.factor == no_density ? 1 : scene.densities[glow.factor]->at(point);
    Rgb color{1, 1, 1};
    if (glow.temperature != no_density)
      color =
          blackbody_glow((scene.densities[glow.temperature]->at(point) - double(glow.temperature_offset)) *
                         double(glow.temperature_scale));
    const Rgb source = medium.emission() * color, extinction = medium.extinction();
    const float sources[3] = {source.r, source.g, source.b};
    const float extinctions[3] = {extinction.r, extinction.g, extinction.b};
    for (int k = 0; k < 3; ++k) {
      const double own = double(extinctions[k]) * density * length;
      sum[k] += double(sources[k]) * density * factor * length * std::exp(-depth[k] - own / 2);
      depth[k] += own;
    }
  }
  return {float(sum[0]), float(sum[1]), float(sum[2])};
}

/// Of many even draws.
Rgb mean_of(const Scene& scene, const Interior& medium, float t) {
  constexpr int draws = 40000;
  double sum[3] = {};
  for (int i = 0; i < draws; ++i) {
    const Rgb glow = medium_glow(scene, medium, along_z, t, (float(i) + 0.5f) / draws);
    sum[0] += double(glow.r), sum[1] += double(glow.g), sum[2] += double(glow.b);
  }
  return {float(sum[0] / draws), float(sum[1] / draws), float(sum[2] / draws)};
}

void check_close(const Rgb& a, const Rgb& b, double epsilon) {
  CHECK(a.r == Approx(b.r).epsilon(epsilon).margin(1e-15));
  CHECK(a.g == Approx(b.g).epsilon(epsilon).margin(1e-15));
  CHECK(a.b == Approx(b.b).epsilon(epsilon).margin(1e-15));
}

}  // namespace

TEST_CASE("an even medium glows by what a ray absorbs of it, however thin or long that is") {
  const Scene scene;
  Interior medium{.absorption = {0.5f, 2, 0}, .scattering = {1.5f, 0, 1}, .glow = {.radiance = {3, 2, 1}}};
  const auto expected = [&](double length) {
    return Rgb{float(3 * 0.5 / 2 * -std::expm1(-2 * length)), float(2 * -std::expm1(-2 * length)), 0};
  };
  for (const float t : {1e-9f, 1e-6f, 1e-3f, 0.02f, 0.03f, 0.5f, 3.0f, 40.0f})
    check_close(medium_glow(scene, medium, along_z, t, 0.5f), expected(2 * double(t)), 1e-5);
  constexpr float endless = std::numeric_limits<float>::infinity();
  check_close(medium_glow(scene, medium, along_z, endless, 0.5f), {0.75f, 2, 0}, 1e-6);
  // Nothing that is not absorbed is emitted.
  medium.absorption = {};
  CHECK(medium_glow(scene, medium, along_z, endless, 0.5f) == Rgb{});
}

TEST_CASE("light of media in grids far from where a ray begins is finite, though rounding is large there") {
  Scene scene;
  scene.densities = {grid_of({1, 4, 0, 2}), grid_of({0, 5, 1})};
  Interior medium{.absorption = {0.5f, 2, 0.1f}, .density = 0};
  medium.glow = {.radiance = {3, 2, 1}, .factor = 1};
  constexpr float endless = std::numeric_limits<float>::infinity();
  Random random(6);
  for (int i = 0; i < 20000; ++i) {
    const Vec3 origin{random.unit(), random.unit(), -1e5f * random.unit()};
    const Ray ray{.origin = origin, .direction = normalize(Vec3{0.5f, 0.5f, 0.5f} - origin)};
    const Rgb glow = medium_glow(scene, medium, ray, endless, i % 2 == 0 ? random.unit() : 0x1.fffffep-1f);
    CHECK(is_finite(glow));
  }
}

TEST_CASE("light of media in grids is the integral along the ray") {
  Scene scene;
  scene.densities = {grid_of({1, 4, 0, 2}), grid_of({0, 5, 1}), grid_of({900, 2000, 4000, 3000})};
  Interior medium{.absorption = {0.5f, 2, 0.1f}, .scattering = {1, 0, 0.2f}, .density = 0};
  medium.glow.radiance = {3, 2, 1};
  SECTION("exactly, where the light is even") {
    const Rgb glow = medium_glow(scene, medium, along_z, 3, 0.3f);
    check_close(glow, by_steps(scene, medium, 3), 1e-3);
    CHECK(glow == medium_glow(scene, medium, along_z, 3, 0.9f));
  }
  SECTION("by a factor from point to point") { medium.glow.factor = 1; }
  SECTION("by the factor in an even medium") {
    medium.glow.factor = 1;
    medium.density = no_density;
  }
  SECTION("by a temperature") { medium.glow.temperature = 2; }
  SECTION("by both") {
    medium.glow.factor = 1;
    medium.glow.temperature = 2;
    medium.glow.temperature_offset = 500;
    medium.glow.temperature_scale = 2;
  }
  SECTION("where it is thin") {
    medium.glow.factor = 1;
    medium.absorption = medium.absorption * 1e-4f;
    medium.scattering = medium.scattering * 1e-4f;
  }
  SECTION("where it is thick") {
    medium.glow.factor = 1;
    medium.absorption = medium.absorption * 20;
  }
  for (const float t : {0.8f, 3.0f}) check_close(mean_of(scene, medium, t), by_steps(scene, medium, t), 4e-3);
  // Before the grids begin.
  if (medium.density != no_density || medium.glow.is_uneven())
    CHECK(medium_glow(scene, medium, along_z, 0.4f, 0.5f) == Rgb{});
}

}  // namespace twinray::test
