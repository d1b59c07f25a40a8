// SPDX-License-Identifier: Apache-2.0
// Every ray against every primitive: slow, obvious, and the oracle of all other backends.
#include "accel/backends.h"
#include "accel/canonical/shape_test.h"

namespace twinray {
namespace {

class BruteForce final : public Accelerator {
 public:
  explicit BruteForce(std::shared_ptr<const Geometry> geometry) : Accelerator(std::move(geometry)) {}

 private:
  Hit closest(Query query) const noexcept override {
    return closest_of(query.ray, [&](const CheckedRay& ray) {
      Hit best;
      visit(query, [&](PrimitiveId id) {
        test_primitive(geometry(), ray, id, best);
        return false;
      });
      return best;
    });
  }
  bool any(Query query) const noexcept override {
    return any_of(query.ray, [&](const CheckedRay& ray) {
      Hit found;
      return visit(query, [&](PrimitiveId id) {
        test_primitive(geometry(), ray, id, found);
        return !found.is_miss();
      });
    });
  }

  /// Calls `test` for each primitive until it returns true; whether it did.
  template <typename Test>
  bool visit(Query query, const Test& test) const {
    for (std::uint32_t mesh = 0; mesh < geometry().shapes().size(); ++mesh) {
      const Mesh* triangles = geometry().mesh(mesh);
      const std::size_t count =
          triangles ? triangles->triangles.size() : geometry().sphere_set(mesh)->spheres.size();
      for (std::uint32_t primitive = 0; primitive < count; ++primitive) {
        if (query.counts) ++query.counts->primitives;
        if (test({mesh, primitive})) return true;
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
