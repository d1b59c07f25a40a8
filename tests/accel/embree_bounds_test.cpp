// SPDX-License-Identifier: Apache-2.0
// The boxes that Embree is given. The file is compiled where Embree is part of the build.
#include "accel/embree/bounds.h"

#include <vector>

#include "core/geometry.h"
#include "tests/support/catch.h"
#include "tests/support/meshes.h"

using namespace twinray;
using namespace twinray::test;

TEST_CASE("Embree's boxes of instances hold what the farthest of its rays may hit") {
  std::vector<Instance> instances{{0, Transform::scaling(1, 1, 1e-3)},
                                  {0, Transform::translation(30, 0, 0) * Transform::scaling(1e4, 1, 1)}};
  const Geometry geometry({icosphere_mesh(1)}, nullptr, {{{0, 1}}, instances});
  const PlacedInstances& placed = geometry.placed();
  const float size = embree::scene_size(geometry);
  const float pad = placed.far_margin() * size * embree::reach;
  REQUIRE(pad > size * 0x1p-20f * (1 + embree::reach));  // So that the padding of all boxes is not enough.
  for (std::uint32_t i = 0; i < instances.size(); ++i) {
    const RTCBounds bounds = embree::instance_bounds(placed, i, size, 1);
    const Aabb box{{bounds.lower_x, bounds.lower_y, bounds.lower_z},
                   {bounds.upper_x, bounds.upper_y, bounds.upper_z}};
    const Aabb seen{placed[i].box.lower - Vec3{pad, pad, pad}, placed[i].box.upper + Vec3{pad, pad, pad}};
    const auto [lower, upper] = embree::padded_for_embree(seen, size);
    CHECK(box.contains({lower, upper}));
  }
}
