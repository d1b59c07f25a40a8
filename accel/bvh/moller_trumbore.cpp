// SPDX-License-Identifier: Apache-2.0
// The binary BVH with Möller and Trumbore's triangle test in its leaves, one triangle after the other: an
// engine to compare with, outside of the promise of equal bits.
#include "accel/canonical/moller_trumbore.h"
#include "accel/backends.h"
#include "accel/bvh/engine.h"

namespace twinray {
namespace {

/// As test_primitive() of accel/canonical/shape_test.h.
void test_triangle(const Geometry& geometry, const Mesh& mesh, const CheckedRay& ray, PrimitiveId id,
                   Hit& best) {
  const auto [a, b, c] = mesh.triangles[id.primitive];
  const float t_max = std::min(ray.t_max, best.t);
  ShapeHit found;
  if (!intersect_moller_trumbore(ray, mesh.positions[a], mesh.positions[b], mesh.positions[c], t_max, found))
    return;
  if (!mesh.is_opaque && !accepts(geometry, ray, id, found)) return;
  const Hit hit{found.t, found.u, found.v, id.primitive, id.mesh, ray.instance};
  if (precedes(hit, best)) best = hit;
}

struct MollerTrumboreLeaf {
  template <QueryKind>
  static void test(const Geometry& geometry, const CheckedRay& ray, const PrimitiveBlock& block, Hit& best) {
    for (std::uint32_t lane = 0; lane < block.count; ++lane) {
      const PrimitiveId id = block.ids[lane];
      if (const Mesh* mesh = geometry.mesh(id.mesh))
        test_triangle(geometry, *mesh, ray, id, best);
      else
        test_primitive(geometry, ray, id, best);
    }
  }
};

}  // namespace

std::unique_ptr<Accelerator> build_moller_trumbore(std::shared_ptr<const Geometry> geometry,
                                                   const BuildOptions& options) {
  return build_bvh_engine<MollerTrumboreLeaf>(std::move(geometry), options);
}

}  // namespace twinray
