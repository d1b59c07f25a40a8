// SPDX-License-Identifier: Apache-2.0
// The eight-wide BVH with a kernel of the test's choice, as an accelerator.
#pragma once
#include <memory>
#include <utility>
#include <vector>

#include "accel/accelerator.h"
#include "accel/wide/build.h"
#include "accel/wide/kernel.h"

namespace twinray::test {

inline WideBvh build_wide(const Geometry& geometry, const BuildOptions& options = {}) {
  std::vector<BuildPhase> phases;
  return make_wide_bvh(geometry, options, phases);
}

class WideEngine final : public Accelerator {
 public:
  WideEngine(std::shared_ptr<const Geometry> geometry, WideKernel kernel)
      : geometry_(std::move(geometry)), kernel_(std::move(kernel)), bvh_(build_wide(*geometry_)) {}

  Aabb bounds() const noexcept override { return geometry_->bounds(); }
  AccelStats stats() const override { return {}; }

 private:
  Hit find_closest(const Ray& ray) const noexcept override { return kernel_.closest(bvh_, *geometry_, ray); }
  bool find_any(const Ray& ray) const noexcept override { return kernel_.any(bvh_, *geometry_, ray); }
  Hit find_closest(const Ray& ray, QueryCounts&) const noexcept override { return find_closest(ray); }
  bool find_any(const Ray& ray, QueryCounts&) const noexcept override { return find_any(ray); }

  std::shared_ptr<const Geometry> geometry_;
  WideKernel kernel_;
  WideBvh bvh_;
};

}  // namespace twinray::test
