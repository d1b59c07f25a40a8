// SPDX-License-Identifier: Apache-2.0
// Every ray against every primitive: slow, obvious, and the oracle of all other backends.
#include "accel/backends.h"
#include "accel/canonical/shape_test.h"
#include "accel/checked_accelerator.h"

namespace twinray {
namespace {

template <TriangleTest triangle_test>
class BruteForce final : public CheckedAccelerator {
 public:
  explicit BruteForce(std::shared_ptr<const Geometry> geometry) : geometry_(std::move(geometry)) {}

  Aabb bounds() const noexcept override { return geometry_->bounds(); }
  AccelStats stats() const override { return {.phases = {}, .primitives = geometry_->primitive_count()}; }

 private:
  Hit trace_closest(const CheckedRay& ray) const noexcept override {
    QueryCounts counts;
    return count_closest(ray, counts);
  }
  bool trace_any(const CheckedRay& ray) const noexcept override {
    QueryCounts counts;
    return count_any(ray, counts);
  }
  Hit count_closest(const CheckedRay& ray, QueryCounts& counts) const noexcept override {
    Hit best;
    visit(counts, [&](PrimitiveId id) {
      test_primitive<triangle_test>(*geometry_, ray, id, best);
      return false;
    });
    return best;
  }
  bool count_any(const CheckedRay& ray, QueryCounts& counts) const noexcept override {
    Hit found;
    return visit(counts, [&](PrimitiveId id) {
      test_primitive<triangle_test>(*geometry_, ray, id, found);
      return !found.is_miss();
    });
  }

  /// Calls `test` for each primitive until it returns true; whether it did.
  template <typename Test>
  bool visit(QueryCounts& counts, Test test) const {
    for (std::uint32_t mesh = 0; mesh < geometry_->shapes().size(); ++mesh) {
      const Mesh* triangles = geometry_->mesh(mesh);
      const std::size_t count =
          triangles ? triangles->triangles.size() : geometry_->sphere_set(mesh)->spheres.size();
      for (std::uint32_t primitive = 0; primitive < count; ++primitive) {
        ++counts.primitives;
        if (test({mesh, primitive})) return true;
      }
    }
    return false;
  }

  std::shared_ptr<const Geometry> geometry_;
};

}  // namespace

std::unique_ptr<Accelerator> build_brute_force(std::shared_ptr<const Geometry> geometry,
                                               const BuildOptions& options) {
  if (options.triangle_test == TriangleTest::moller_trumbore)
    return std::make_unique<BruteForce<TriangleTest::moller_trumbore>>(std::move(geometry));
  return std::make_unique<BruteForce<TriangleTest::woop>>(std::move(geometry));
}

}  // namespace twinray
