// SPDX-License-Identifier: Apache-2.0
#include "integrators/cost.h"

#include "integrators/render.h"
#include "tests/support/catch.h"
#include "tests/support/scenes.h"

using namespace twinray;
using namespace twinray::test;

namespace {

RenderResult render_cost(const Scene& scene, Backend backend, CostKind kind, bool counting = true,
                         int bvh_width = 2) {
  const auto accelerator = build_accelerator(backend, scene.geometry, {.bvh_width = bvh_width});
  return render(scene, *accelerator, CostIntegrator(kind),
                {.width = 9, .height = 7, .samples = 2, .threads = 2, .counting = counting});
}

/// The sum of all samples.
double sum_of(const Film& film) {
  double sum = 0;
  for (int y = 0; y < 7; ++y)
    for (int x = 0; x < 9; ++x) sum += film.pixel(x, y).g.value();
  return sum;
}

}  // namespace

TEST_CASE("the cost by brute force is the number of primitives, everywhere") {
  const Scene scene = small_room();
  const RenderResult result = render_cost(scene, Backend::brute_force, CostKind::primitives);
  const float all = float(scene.geometry->primitive_count());
  for (const Rgb& pixel : mean_image(result.film).pixels) CHECK(pixel == Rgb{all, all, all});
}

TEST_CASE("the costs of all pixels add up to the counts of the render") {
  const Scene scene = small_room();
  for (const int width : {2, 8}) {
    CAPTURE(width);
    const RenderResult nodes = render_cost(scene, Backend::bvh, CostKind::nodes, true, width);
    CHECK(nodes.rays.camera == 9 * 7 * 2);
    CHECK(nodes.rays.total() == nodes.rays.camera);
    CHECK(nodes.rays.queries.nodes > nodes.rays.camera);
    CHECK(sum_of(nodes.film) == double(nodes.rays.queries.nodes));
    const RenderResult primitives = render_cost(scene, Backend::bvh, CostKind::primitives, true, width);
    CHECK(primitives.rays.queries == nodes.rays.queries);
    CHECK(sum_of(primitives.film) == double(primitives.rays.queries.primitives));
  }
}

TEST_CASE("without counting every cost is 0") {
  CHECK(sum_of(render_cost(small_room(), Backend::bvh, CostKind::nodes, false).film) == 0);
}
