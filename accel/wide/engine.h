// SPDX-License-Identifier: Apache-2.0
// Private: the hand-written eight-wide BVHs as accelerators.
#pragma once
#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <utility>

#include "accel/accelerator.h"
#include "accel/wide/kernel.h"
#include "accel/wide/scalar.h"
#include "accel/wide/statistics.h"

namespace twinray {

/// A larger tree does not stay in the caches next to a core, and single rays wait for it. Whole pictures take
/// 1.04 times as long in batches with a tree of 0.4 MB, but 0.97 times with one of 1.9 MB, 0.88 with one of
/// 6.7 MB, 0.75 with one of 58 MB.
inline constexpr std::size_t cached_bytes = 1u << 20;

/// A tree with one of its kernels. Tree: WideBvh or CompactBvh.
template <typename Tree>
class WideAccelerator final : public Accelerator {
 public:
  WideAccelerator(std::shared_ptr<const Geometry> geometry, Tree bvh, const BasicWideKernel<Tree>& kernel,
                  AccelStats stats)
      : Accelerator(std::move(geometry), std::move(stats)), kernel_(kernel), bvh_(std::move(bvh)) {}

 private:
  Hit closest(Query query) const noexcept override {
    return query.counts ? scalar_closest(bvh_, geometry(), query.ray, *query.counts)
                        : kernel_.closest(bvh_, geometry(), query.ray);
  }
  bool any(Query query) const noexcept override {
    return query.counts ? scalar_any(bvh_, geometry(), query.ray, *query.counts)
                        : kernel_.any(bvh_, geometry(), query.ray);
  }
  void closest_batch(std::span<const Ray> rays, Hit* answers) const noexcept override {
    const bool is_cached = bvh_.bytes() <= cached_bytes;
    const auto singly = is_cached ? kernel_.closest_in_turn : kernel_.closest_batch;
    for (std::size_t apart = least_apart; !rays.empty(); apart *= 2) {
      const std::size_t together = kernel_.closest_in_packets(bvh_, geometry(), rays, answers);
      if (together > 0) apart = least_apart;
      const std::size_t count = std::min(apart, rays.size() - together);
      if (count > 0) singly(bvh_, geometry(), rays.subspan(together, count), answers + together);
      rays = rays.subspan(together + count);
      answers += together + count;
    }
  }
  void any_batch(std::span<const Ray> rays, std::uint8_t* answers) const noexcept override {
    const bool is_cached = bvh_.bytes() <= cached_bytes;
    (is_cached ? kernel_.any_in_turn : kernel_.any_batch)(bvh_, geometry(), rays, answers);
  }

  /// So many rays are traced singly behind the packets before the next one is looked for, and twice as many
  /// each time that none was found.
  static constexpr std::size_t least_apart = 32;

  BasicWideKernel<Tree> kernel_;  ///< Chosen once, not for each ray.
  Tree bvh_;
};

/// `stats` has the phases of the build.
template <typename Tree>
std::unique_ptr<Accelerator> make_wide_accelerator(std::shared_ptr<const Geometry> geometry, Tree bvh,
                                                   const BasicWideKernel<Tree>& kernel,
                                                   const BuildOptions& options, AccelStats stats) {
  stats.bytes = bvh.bytes();
  stats.tree = statistics_of(bvh, *geometry, options);
  return std::make_unique<WideAccelerator<Tree>>(std::move(geometry), std::move(bvh), kernel,
                                                 std::move(stats));
}

}  // namespace twinray
