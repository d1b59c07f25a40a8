// SPDX-License-Identifier: Apache-2.0
// Every ray against every primitive, once for each instance of it: slow, obvious, and the oracle of all other
// backends.
#include "accel/backends.h"
#include "accel/canonical/instance_ray.h"
#include "accel/canonical/shape_test.h"

namespace twinray {
namespace {

class BruteForce final : public Accelerator {
 public:
  explicit BruteForce(std::shared_ptr<const Geometry> geometry) : Accelerator(std::move(geometry)) {}

 private:
  Hit closest(Query query) const noexcept override {
    return closest_of(geometry(), query.ray, [&](const CheckedRay& ray) {
      Hit best;
      visit(query.counts, ray, best, [&](const CheckedRay& own, PrimitiveId id) {
        test_primitive(geometry(), own, id, best);
        return false;
      });
      return best;
    });
  }
  bool any(Query query) const noexcept override {
    return any_of(geometry(), query.ray, [&](const CheckedRay& ray) {
      Hit found;
      return visit(query.counts, ray, found, [&](const CheckedRay& own, PrimitiveId id) {
        test_primitive(geometry(), own, id, found);
        return !found.is_miss();
      });
    });
  }

  /// Calls `test` for each primitive, with the ray in its space, until it returns true; whether it did.
  template <typename Test>
  bool visit(QueryCounts* counts, const CheckedRay& ray, const Hit& best, const Test& test) const {
    if (visit(geometry().direct_shapes(), counts, ray, test)) return true;
    for (std::uint32_t i = 0; i < geometry().instances().size(); ++i) {
      CheckedRay own;
      if (!enter_instance(geometry().placed(), i, ray, std::min(ray.t_max, best.t), own)) continue;
      if (counts) ++counts->instances;
      if (visit(geometry().prototypes()[geometry().instances()[i].prototype], counts, own, test)) return true;
    }
    return false;
  }
  template <typename Test>
  bool visit(ShapeRange shapes, QueryCounts* counts, const CheckedRay& ray, const Test& test) const {
    for (std::uint32_t mesh = shapes.first; mesh < shapes.end(); ++mesh) {
      const Mesh* triangles = geometry().mesh(mesh);
      const std::size_t count =
          triangles ? triangles->triangles.size() : geometry().sphere_set(mesh)->spheres.size();
      for (std::uint32_t primitive = 0; primitive < count; ++primitive) {
        if (counts) ++counts->primitives;
        if (test(ray, {mesh, primitive})) return true;
      }
    }
    return false;
  }
};

}  // namespace

std::unique_ptr<Accelerator> build_brute_force(std::shared_ptr<const Geometry> geometry,
                                               const BuildOptions&) {
  return std::make_unique<BruteForce>(std::move(geometry));
}

}  // namespace twinray
