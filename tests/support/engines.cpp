// SPDX-License-Identifier: Apache-2.0
#include "tests/support/engines.h"

#include <string>
#include <vector>

#include "core/instruction_sets.h"
#include "integrators/path.h"
#include "integrators/path_reference.h"
#include "tests/support/catch.h"
#include "tests/support/estimate.h"

namespace twinray::test {
namespace {

RenderOptions picture_of(std::uint32_t samples, int threads) {
  RenderOptions options;
  options.width = 24;
  options.height = 18;
  options.samples = samples;
  options.threads = threads;
  return options;
}

/// All but embree_native, which answers with other bits.
std::vector<Backend> engines_of_one_answer() {
  std::vector<Backend> engines = available_backends();
  std::erase(engines, Backend::embree_native);
  return engines;
}

}  // namespace

void check_engines(const Scene& scene, const Integrator& integrator) {
  const Film expected = render_with(scene, integrator, picture_of(4, 1), Backend::brute_force).film;
  for (const Backend engine : engines_of_one_answer()) {
    CAPTURE(backend_name(engine));
    CHECK(same_bits(render_with(scene, integrator, picture_of(4, 3), engine).film, expected));
  }
}

void check_waves(const Scene& scene) {
  for (const PathOptions& path : {PathOptions{},
                                  {.max_depth = 3, .direct = DirectMethod::lights, .samples_per_light = 3},
                                  {.max_depth = 2, .direct = DirectMethod::hemisphere}}) {
    const RenderResult expected =
        render_with(scene, PathReference(scene, path), picture_of(16, 1), Backend::brute_force);
    for (const Backend engine : engines_of_one_answer())
      for (const std::string& simd : available_instruction_sets()) {
        CAPTURE(backend_name(engine), simd, path.max_depth);
        const RenderResult found =
            render_with(scene, PathIntegrator(scene, path, simd), picture_of(16, 1), engine);
        CHECK(same_bits(found.film, expected.film));
        CHECK(found.rays.total() == expected.rays.total());
      }
  }
}

}  // namespace twinray::test
