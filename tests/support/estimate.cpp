// SPDX-License-Identifier: Apache-2.0
#include "tests/support/estimate.h"

#include <algorithm>
#include <cmath>

#include "check/difference.h"
#include "tests/support/catch.h"

namespace twinray::test {
namespace {}  // namespace

RenderOptions small_picture(std::uint32_t samples) {
  return {.width = 4,
          .height = 4,
          .samples = samples,
          .sampler = SamplerKind::independent,
          .seed = 7,
          .threads = 1};
}

RenderResult render_with(const Scene& scene, const Integrator& integrator, const RenderOptions& options,
                         Backend backend) {
  const auto accelerator = build_accelerator(backend, scene.geometry);
  return render(scene, *accelerator, integrator, options);
}

Estimate estimate_of(const Film& film) {
  double sum = 0, variance = 0, pixels = 0;
  for (int y = film.window().y0; y < film.window().y1; ++y)
    for (int x = film.window().x0; x < film.window().x1; ++x) {
      const PixelSums& pixel = film.pixel(x, y);
      sum += pixel.luminance_mean();
      variance += pixel.luminance_variance() / pixel.count;
      ++pixels;
    }
  return {sum / pixels, std::sqrt(variance) / pixels};
}

Estimate estimate(const Scene& scene, const PathOptions& path, const RenderOptions& options,
                  Backend backend) {
  return estimate_of(render_with(scene, PathIntegrator(scene, path), options, backend).film);
}

void check_mean(const Estimate& found, double expected, double sees) {
  const double seen = render_rounding * expected + seen_error(found.standard_error, mean_level);
  INFO("mean " << found.mean << " +- " << found.standard_error << ", expected " << expected
               << "; sees a relative error of " << seen / expected);
  CHECK(std::fabs(found.mean - expected) <=
        std::max(render_rounding * expected, z_limit(mean_level) * found.standard_error));
  CHECK(seen <= sees * expected);
}

void check_same_mean(const Estimate& a, const Estimate& b, double sees) {
  check_mean({a.mean, std::hypot(a.standard_error, b.standard_error)}, b.mean, sees);
}

std::uint64_t sample_count(const Film& film) {
  std::uint64_t count = 0;
  const PixelRect& window = film.window();
  for (int y = window.y0; y < window.y1; ++y)
    for (int x = window.x0; x < window.x1; ++x) count += film.pixel(x, y).count;
  return count;
}

bool same_bits(const Film& a, const Film& b) { return a.window() == b.window() && !first_difference(a, b); }

}  // namespace twinray::test
