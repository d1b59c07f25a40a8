// SPDX-License-Identifier: Apache-2.0
// Embree's tree and traversal with our leaf: canonical bits at Embree's speed.
//
// To Embree the scene is one geometry of user type, whose primitives are blocks of up to four triangles that
// lie together. Its callback runs the canonical test and keeps the best hit in an extended context; the tfar
// that Embree goes by lies a little behind it, so that Embree's rounding culls no box with a hit of the same
// t. The blocks are the leaves of a binary BVH, which groups them well, and which answers for the rays that
// start so far outside of the scene that no fixed widening of the boxes covers their rounding.
#include <bit>

#include "accel/backends.h"
#include "accel/build/binary_tree.h"
#include "accel/build/phase_timer.h"
#include "accel/bvh/traversal.h"
#include "accel/checked_accelerator.h"
#include "accel/embree/bounds.h"
#include "accel/embree/device.h"
#include "accel/embree/embree.h"
#include "accel/embree/leaf.h"
#include "accel/embree/ray.h"
#include "accel/instruction_sets.h"

namespace twinray {
namespace {

/// By how much tfar lies behind a hit, and tnear before t_min: far above the 32 u (u = 2^-24) to which
/// Embree's and the canonical parameters of one plane differ relatively.
constexpr float slack = 0x1p-14f;

/// Leaves of one block each, as full as can be: 95 bytes a triangle instead of 114 at the same speed.
BuildOptions block_options(const BuildOptions& options) {
  return {
      .threads = options.threads, .max_leaf_size = TriangleBlock::width, .leaf_block = TriangleBlock::width};
}

class EmbreeAccelerator final : public CheckedAccelerator {
 public:
  EmbreeAccelerator(std::shared_ptr<const Geometry> geometry, const BuildOptions& options, float widening)
      : geometry_(std::move(geometry)),
        leaf_(chosen(embree::leaf_functions(), options.simd)),
        device_(embree::configuration(options)),
        scene_(rtcNewScene(device_.get())) {
    bvh_ = make_bvh(*geometry_, block_options(options), stats_.phases);
    scene_size_ = embree::scene_size(*geometry_);
    widened_size_ = scene_size_ * widening;
    timed("embree", stats_.phases, [&] { build(options.threads); });
    stats_.primitives = geometry_->primitive_count();
    stats_.bytes = bvh_.bytes() + device_.bytes();
  }

  Aabb bounds() const noexcept override { return geometry_->bounds(); }
  AccelStats stats() const override { return stats_; }

 private:
  void build(int threads) {
    embree::GeometryOwner blocks(rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_USER));
    rtcSetGeometryUserPrimitiveCount(blocks.get(), unsigned(bvh_.blocks.size()));
    rtcSetGeometryUserData(blocks.get(), this);
    rtcSetGeometryBoundsFunction(blocks.get(), bound_block, nullptr);
    rtcSetGeometryIntersectFunction(blocks.get(), leaf_.intersect);
    rtcSetGeometryOccludedFunction(blocks.get(), leaf_.occlude);
    embree::attach(scene_.get(), std::move(blocks), 0);
    embree::commit(device_, scene_.get(), threads);
  }

  static void bound_block(const RTCBoundsFunctionArguments* arguments) {
    const auto& self = *static_cast<const EmbreeAccelerator*>(arguments->geometryUserPtr);
    const TriangleBlock& block = self.bvh_.blocks[arguments->primID];
    *arguments->bounds_o = embree::widened(block_bounds(*self.geometry_, block), self.widened_size_);
  }

  Hit trace_closest(const CheckedRay& ray) const noexcept override { return closest(ray, nullptr); }
  bool trace_any(const CheckedRay& ray) const noexcept override { return any(ray, nullptr); }
  Hit count_closest(const CheckedRay& ray, QueryCounts& counts) const noexcept override {
    return closest(ray, &counts);
  }
  bool count_any(const CheckedRay& ray, QueryCounts& counts) const noexcept override {
    return any(ray, &counts);
  }

  Hit closest(const CheckedRay& ray, QueryCounts* counts) const {
    if (is_far(ray)) return far_hit<QueryKind::closest>(ray, counts);
    const float scale = length_scale(ray);
    embree::LeafQuery query(bvh_.blocks.data(), *geometry_, ray, scale * (1 + slack), counts);
    RTCRayHit ray_hit = embree::without_hit(embree_ray(ray, scale));
    embree::intersect(scene_.get(), query, ray_hit);
    return query.best.hit();
  }

  bool any(const CheckedRay& ray, QueryCounts* counts) const {
    if (is_far(ray)) return bool(far_hit<QueryKind::any>(ray, counts));
    const float scale = length_scale(ray);
    embree::LeafQuery query(bvh_.blocks.data(), *geometry_, ray, scale * (1 + slack), counts);
    RTCRay occlusion_ray = embree_ray(ray, scale);
    embree::occluded(scene_.get(), query, occlusion_ray);
    return query.is_hit;
  }

  bool is_far(const CheckedRay& ray) const { return max_abs(ray.origin) > scene_size_ * embree::reach; }

  /// A power of two, at most the direction's largest component and more than half of it. Embree gets a
  /// direction divided by it, for it takes components below 10^-18 for 10^-18.
  static float length_scale(const CheckedRay& ray) {
    return std::bit_cast<float>(std::bit_cast<std::uint32_t>(max_abs(ray.direction)) & 0x7f800000u);
  }
  /// 1 / a power of two: the exponent of one is 127.
  static float inverse_power(float power) {
    return std::bit_cast<float>((2 * 127u << 23) - std::bit_cast<std::uint32_t>(power));
  }
  static RTCRay embree_ray(const CheckedRay& ray, float scale) {
    return embree::make_ray(ray.origin, ray.direction * inverse_power(scale), ray.t_min * scale * (1 - slack),
                            ray.t_max * scale * (1 + slack));
  }

  /// The answer of our own tree. Apart, for its stack is large.
  template <QueryKind kind>
  [[gnu::noinline]] Hit far_hit(const CheckedRay& ray, QueryCounts* counts) const {
    Hit best;
    float t_max = ray.t_max;
    traverse(bvh_, ray, t_max, NoCounts{}, [&](const TriangleBlock& block) {
      if (counts) {
        ++counts->leaves;
        counts->primitives += block.count;
      }
      test_block<kind>(*geometry_, ray, block, best);
      if (kind == QueryKind::closest) t_max = std::min(t_max, best.t);
      return kind == QueryKind::any && best;
    });
    return best;
  }

  std::shared_ptr<const Geometry> geometry_;
  Bvh bvh_;
  float scene_size_ = 0;    ///< The largest coordinate of the scene.
  float widened_size_ = 0;  ///< The same, as the widening of the blocks' boxes takes it.
  AccelStats stats_;
  embree::LeafFunctions leaf_;
  embree::Device device_;
  embree::Scene scene_;
};

}  // namespace

std::unique_ptr<Accelerator> build_embree(std::shared_ptr<const Geometry> geometry,
                                          const BuildOptions& options) {
  return build_embree_widened(std::move(geometry), options, 1);
}

std::unique_ptr<Accelerator> build_embree_widened(std::shared_ptr<const Geometry> geometry,
                                                  const BuildOptions& options, float widening) {
  return std::make_unique<EmbreeAccelerator>(std::move(geometry), options, widening);
}

}  // namespace twinray
