// SPDX-License-Identifier: Apache-2.0
// The eight-wide BVHs with a kernel of the test's choice, as accelerators.
#pragma once
#include <memory>
#include <utility>
#include <vector>

#include "accel/accelerator.h"
#include "accel/compact/build.h"
#include "accel/compact/kernel.h"
#include "accel/wide/build.h"
#include "accel/wide/kernel.h"

namespace twinray::test {

inline WideBvh build_wide(const Geometry& geometry, const BuildOptions& options = {}) {
  std::vector<BuildPhase> phases;
  return make_wide_bvh(geometry, options, phases);
}

/// In parts of a few primitives, so that small scenes have some.
inline CompactBvh build_compact(const Geometry& geometry, const BuildOptions& options = {},
                                std::size_t least_part = 16) {
  std::vector<BuildPhase> phases;
  return make_compact_bvh(geometry, options, phases, least_part);
}

/// Always in batches where it is asked for many rays, however small the tree; counts nothing. Tree: WideBvh
/// or CompactBvh.
template <typename Tree>
class TreeEngine final : public Accelerator {
 public:
  TreeEngine(std::shared_ptr<const Geometry> geometry, BasicWideKernel<Tree> kernel, Tree bvh)
      : Accelerator(std::move(geometry)), kernel_(std::move(kernel)), bvh_(std::move(bvh)) {}

 private:
  Hit closest(Query query) const noexcept override { return kernel_.closest(bvh_, geometry(), query.ray); }
  bool any(Query query) const noexcept override { return kernel_.any(bvh_, geometry(), query.ray); }
  void closest_batch(std::span<const Ray> rays, Hit* answers) const noexcept override {
    kernel_.closest_batch(bvh_, geometry(), rays, answers);
  }
  void any_batch(std::span<const Ray> rays, std::uint8_t* answers) const noexcept override {
    kernel_.any_batch(bvh_, geometry(), rays, answers);
  }

  BasicWideKernel<Tree> kernel_;
  Tree bvh_;
};

inline std::unique_ptr<Accelerator> wide_engine(const std::shared_ptr<const Geometry>& geometry,
                                                const WideKernel& kernel) {
  return std::make_unique<TreeEngine<WideBvh>>(geometry, kernel, build_wide(*geometry));
}
inline std::unique_ptr<Accelerator> compact_engine(const std::shared_ptr<const Geometry>& geometry,
                                                   const CompactKernel& kernel) {
  return std::make_unique<TreeEngine<CompactBvh>>(geometry, kernel, build_compact(*geometry));
}

}  // namespace twinray::test
