// SPDX-License-Identifier: Apache-2.0
#include "tests/support/estimate.h"

#include <cmath>

namespace twinray::test {

RenderResult render_with(const Scene& scene, const Integrator& integrator, const RenderOptions& options,
                         Backend backend) {
  const auto accelerator = build_accelerator(backend, scene.geometry);
  return render(scene, *accelerator, integrator, options);
}

Estimate estimate_of(const Film& film) {
  double sum = 0, variance = 0, pixels = 0;
  for (int y = film.window().y0; y < film.window().y1; ++y)
    for (int x = film.window().x0; x < film.window().x1; ++x) {
      const PixelSums& pixel = film.pixel(0, x, y);
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

double z_score(const Estimate& a, const Estimate& b) {
  return std::fabs(a.mean - b.mean) / std::hypot(a.standard_error, b.standard_error);
}

double z_score(const Estimate& a, double exact) { return std::fabs(a.mean - exact) / a.standard_error; }

bool same_bits(const Film& a, const Film& b) {
  if (a.window() != b.window() || a.layers() != b.layers()) return false;
  for (std::size_t layer = 0; layer < a.layers().size(); ++layer)
    for (int y = a.window().y0; y < a.window().y1; ++y)
      for (int x = a.window().x0; x < a.window().x1; ++x)
        if (!(a.pixel(layer, x, y) == b.pixel(layer, x, y))) return false;
  return true;
}

}  // namespace twinray::test
