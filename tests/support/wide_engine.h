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

/// Always in batches where it is asked for many rays, however small the tree; counts nothing.
class WideEngine final : public Accelerator {
 public:
  WideEngine(std::shared_ptr<const Geometry> geometry, WideKernel kernel)
      : Accelerator(std::move(geometry)), kernel_(std::move(kernel)), bvh_(build_wide(this->geometry())) {}

 private:
  Hit closest(Query query) const noexcept override { return kernel_.closest(bvh_, geometry(), query.ray); }
  bool any(Query query) const noexcept override { return kernel_.any(bvh_, geometry(), query.ray); }
  void closest_batch(std::span<const Ray> rays, Hit* answers) const noexcept override {
    kernel_.closest_batch(bvh_, geometry(), rays, answers);
  }
  void any_batch(std::span<const Ray> rays, std::uint8_t* answers) const noexcept override {
    kernel_.any_batch(bvh_, geometry(), rays, answers);
  }

  WideKernel kernel_;
  WideBvh bvh_;
};

}  // namespace twinray::test
