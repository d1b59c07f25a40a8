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
#include "accel/build/phase_timer.h"
#include "accel/bvh/build.h"
#include "accel/bvh/traversal.h"
#include "accel/embree/bounds.h"
#include "accel/embree/device.h"
#include "accel/embree/embree.h"
#include "accel/embree/leaf.h"
#include "accel/embree/ray.h"
#include "core/instruction_sets.h"

namespace twinray {
namespace {

/// Leaves of one block each, as full as can be: 95 bytes a triangle instead of 114 at the same speed.
BuildOptions block_options(const BuildOptions& options) {
  return {.threads = options.threads,
          .max_leaf_size = PrimitiveBlock::width,
          .leaf_block = PrimitiveBlock::width};
}

/// What Embree asks about a block while it builds.
struct BlockBounds {
  const Geometry& geometry;
  const Bvh& bvh;
  float widened_size;  ///< The largest coordinate of the scene, as the widening of the boxes takes it.
};

void bound_block(const RTCBoundsFunctionArguments* arguments) {
  const auto& [geometry, bvh, size] = *static_cast<const BlockBounds*>(arguments->geometryUserPtr);
  *arguments->bounds_o = embree::widened(block_bounds(geometry, bvh.blocks[arguments->primID]), size);
}

/// Blocks of primitives, and Embree's tree over them.
struct EmbreeBlocks {
  Bvh bvh;
  embree::Device device;
  embree::Scene scene;

  EmbreeBlocks(const Geometry& geometry, const BuildOptions& options, AccelStats& stats)
      : bvh(make_bvh(geometry, block_options(options), stats.phases)),
        device(embree::configuration(options)),
        scene(rtcNewScene(device.get())) {}

  void build(BlockBounds& bounds, const embree::LeafFunctions& leaf, int threads) {
    embree::GeometryOwner blocks(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_USER));
    rtcSetGeometryUserPrimitiveCount(blocks.get(), unsigned(bvh.blocks.size()));
    rtcSetGeometryUserData(blocks.get(), &bounds);
    rtcSetGeometryBoundsFunction(blocks.get(), bound_block, nullptr);
    rtcSetGeometryIntersectFunction(blocks.get(), leaf.intersect);
    rtcSetGeometryOccludedFunction(blocks.get(), leaf.occlude);
    embree::attach(scene.get(), std::move(blocks), 0);
    embree::commit(device, scene.get(), threads);
  }
};

class EmbreeAccelerator final : public Accelerator {
 public:
  EmbreeAccelerator(std::shared_ptr<const Geometry> geometry, EmbreeBlocks blocks, AccelStats stats)
      : Accelerator(std::move(geometry), std::move(stats)),
        blocks_(std::move(blocks)),
        scene_size_(embree::scene_size(this->geometry())) {}

 private:
  Hit closest(Query query) const noexcept override {
    return closest_of(query.ray, [&](const CheckedRay& ray) {
      if (is_far(ray)) return far_hit<QueryKind::closest>(ray, query.counts);
      const float scale = length_scale(ray);
      embree::LeafQuery leaf_query(blocks_.bvh.blocks.data(), geometry(), ray, embree::told_t_max(scale),
                                   query.counts);
      RTCRayHit ray_hit;
      set_ray(ray_hit.ray, ray, scale);
      embree::set_no_hit(ray_hit.hit);
      embree::trace(blocks_.scene.get(), leaf_query, ray_hit);
      return leaf_query.best.hit();
    });
  }

  bool any(Query query) const noexcept override {
    return any_of(query.ray, [&](const CheckedRay& ray) {
      if (is_far(ray)) return bool(far_hit<QueryKind::any>(ray, query.counts));
      const float scale = length_scale(ray);
      embree::LeafQuery leaf_query(blocks_.bvh.blocks.data(), geometry(), ray, embree::told_t_max(scale),
                                   query.counts);
      RTCRay occlusion_ray;
      set_ray(occlusion_ray, ray, scale);
      embree::trace(blocks_.scene.get(), leaf_query, occlusion_ray);
      return leaf_query.is_hit;
    });
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
  static void set_ray(RTCRay& to, const CheckedRay& ray, float scale) {
    embree::set_ray(to, ray.origin, ray.direction * inverse_power(scale),
                    embree::told_t_min(ray.t_min * scale), embree::told_t_max(ray.t_max * scale));
  }

  /// The answer of our own tree. Apart, for its stack is large.
  template <QueryKind kind>
  [[gnu::noinline]] Hit far_hit(const CheckedRay& ray, QueryCounts* counts) const {
    Hit best;
    float t_max = ray.t_max;
    traverse(blocks_.bvh, ray, t_max, NoCounts{}, [&](const PrimitiveBlock& block) {
      if (counts) {
        ++counts->leaves;
        counts->primitives += block.count;
      }
      test_block<kind>(geometry(), ray, block, best);
      if (kind == QueryKind::closest) t_max = std::min(t_max, best.t);
      return kind == QueryKind::any && best;
    });
    return best;
  }

  EmbreeBlocks blocks_;
  float scene_size_;  ///< The largest coordinate of the scene.
};

}  // namespace

std::unique_ptr<Accelerator> build_embree(std::shared_ptr<const Geometry> geometry,
                                          const BuildOptions& options) {
  return build_embree_widened(std::move(geometry), options, 1);
}

std::unique_ptr<Accelerator> build_embree_widened(std::shared_ptr<const Geometry> geometry,
                                                  const BuildOptions& options, float widening) {
  const embree::LeafFunctions leaf = chosen(embree::leaf_functions(), options.simd);
  AccelStats stats;
  EmbreeBlocks blocks(*geometry, options, stats);
  BlockBounds bounds{*geometry, blocks.bvh, embree::scene_size(*geometry) * widening};
  timed("embree", stats.phases, [&] { blocks.build(bounds, leaf, options.threads); });
  stats.bytes = blocks.bvh.bytes() + blocks.device.bytes();
  return std::make_unique<EmbreeAccelerator>(std::move(geometry), std::move(blocks), std::move(stats));
}

}  // namespace twinray
