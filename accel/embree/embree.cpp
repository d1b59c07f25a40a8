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

/// Likewise about an instance.
struct InstanceBounds {
  const Geometry& geometry;
  float size, widening;
};

void bound_instance(const RTCBoundsFunctionArguments* arguments) {
  const auto& [geometry, size, widening] = *static_cast<const InstanceBounds*>(arguments->geometryUserPtr);
  *arguments->bounds_o = embree::instance_bounds(geometry.placed(), arguments->primID, size, widening);
}

/// Embree's tree over the blocks of some shapes.
struct EmbreeTree {
  embree::Scene scene;
  float size = 0;  ///< The largest coordinate of what is in it.
  float far = 0;   ///< Rays whose origin is farther away than this go through our own tree.
};

/// Blocks of primitives, and Embree's trees over them.
struct EmbreeBlocks {
  SceneBvh bvh;
  embree::Device device;
  EmbreeTree scene;                    ///< Number 0: the blocks that stand in it directly, 1: the instances.
  std::vector<EmbreeTree> prototypes;  ///< Of blocks.

  EmbreeBlocks(const Geometry& geometry, const BuildOptions& options, AccelStats& stats)
      : bvh(make_scene_bvh(geometry, block_options(options), stats.phases)),
        device(embree::configuration(options)) {}

  void build(const Geometry& geometry, const embree::LeafFunctions& leaf, int threads, float widening) {
    scene = new_tree(embree::scene_size(geometry), embree::reach);
    InstanceBounds instances{geometry, scene.size, widening};
    BlockBounds direct{geometry, bvh.direct, scene.size * widening};
    add_blocks(scene, direct, leaf);
    if (geometry.has_instances()) add_instances(scene, instances);
    embree::commit(device, scene.scene.get(), threads);
    for (std::size_t i = 0; i < bvh.prototypes.size(); ++i) {
      const Aabb& box = bvh.prototypes[i].box;
      prototypes.push_back(new_tree(embree::largest_coordinate(box), embree::prototype_reach));
      BlockBounds bounds{geometry, bvh.prototypes[i], embree::prototype_size(box) * widening};
      add_blocks(prototypes.back(), bounds, leaf);
      embree::commit(device, prototypes.back().scene.get(), threads);
    }
  }

 private:
  EmbreeTree new_tree(float size, float reach) {
    return {embree::Scene(rtcNewScene(device.get())), size, size * reach};
  }
  embree::GeometryOwner new_geometry(std::size_t primitives, void* bounds, RTCBoundsFunction bound) {
    embree::GeometryOwner geometry(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_USER));
    rtcSetGeometryUserPrimitiveCount(geometry.get(), unsigned(primitives));
    rtcSetGeometryUserData(geometry.get(), bounds);
    rtcSetGeometryBoundsFunction(geometry.get(), bound, nullptr);
    return geometry;
  }
  void add_blocks(EmbreeTree& tree, BlockBounds& bounds, const embree::LeafFunctions& leaf) {
    embree::GeometryOwner blocks = new_geometry(bounds.bvh.blocks.size(), &bounds, bound_block);
    rtcSetGeometryIntersectFunction(blocks.get(), leaf.intersect);
    rtcSetGeometryOccludedFunction(blocks.get(), leaf.occlude);
    embree::attach(tree.scene.get(), std::move(blocks), 0);
  }
  void add_instances(EmbreeTree& tree, InstanceBounds& bounds);
};

/// A power of two, at most the direction's largest component and more than half of it. Embree gets a
/// direction divided by it, for it takes components below 10^-18 for 10^-18.
float length_scale(const CheckedRay& ray) {
  return std::bit_cast<float>(std::bit_cast<std::uint32_t>(max_abs(ray.direction)) & 0x7f800000u);
}
/// 1 / a power of two: the exponent of one is 127.
float inverse_power(float power) {
  return std::bit_cast<float>((2 * 127u << 23) - std::bit_cast<std::uint32_t>(power));
}
void set_ray(RTCRay& to, const CheckedRay& ray, float scale) {
  embree::set_ray(to, ray.origin, ray.direction * inverse_power(scale), embree::told_t_min(ray.t_min * scale),
                  embree::told_t_max(ray.t_max * scale));
}

bool is_far(const EmbreeTree& tree, const CheckedRay& ray) { return max_abs(ray.origin) > tree.far; }

/// Queries from far away, through our own trees; they count what Embree's callbacks count.
template <QueryKind kind>
class FarQuery {
 public:
  FarQuery(const Geometry& geometry, const CheckedRay& ray, QueryCounts* counts)
      : geometry_(geometry), ray_(ray), counts_(counts), t_max_(ray.t_max) {}

  // Apart, for their stacks are large.
  [[gnu::noinline]] Hit find_in(const SceneBvh& bvh) {
    traverse_scene(bvh, geometry_, ray_, t_max_, NoCounts{},
                   [&](const CheckedRay& own, const PrimitiveBlock& block) { return test(own, block); });
    return best_;
  }
  [[gnu::noinline]] Hit find_in(const Bvh& bvh) {
    traverse(bvh, ray_, t_max_, NoCounts{}, [&](const PrimitiveBlock& block) { return test(ray_, block); });
    return best_;
  }

 private:
  bool test(const CheckedRay& own, const PrimitiveBlock& block) {
    if (counts_) {
      ++counts_->leaves;
      counts_->primitives += block.count;
    }
    test_block<kind>(geometry_, own, block, best_);
    if (kind == QueryKind::closest) t_max_ = std::min(t_max_, best_.t);
    return kind == QueryKind::any && best_;
  }

  const Geometry& geometry_;
  const CheckedRay& ray_;
  QueryCounts* const counts_;
  float t_max_;
  Hit best_;
};

/// A query of a tree of blocks, or of the scene.
struct TreeQuery : embree::LeafQuery {
  const EmbreeBlocks& all;
  Hit best_of_instances;

  TreeQuery(const EmbreeBlocks& every, const Bvh& bvh, const Geometry& shapes, const CheckedRay& checked,
            float scale, QueryCounts* sums)
      : LeafQuery(bvh.blocks.data(), shapes, checked, embree::told_t_max(scale), sums), all(every) {}

  Hit closest() const {
    const Hit of_blocks = best.hit(ray);
    return precedes(of_blocks, best_of_instances) ? of_blocks : best_of_instances;
  }
};

/// Of what lies in one tree of Embree's.
Hit closest_in(const EmbreeBlocks& all, const EmbreeTree& tree, const Bvh& bvh, const Geometry& geometry,
               const CheckedRay& ray, QueryCounts* counts) {
  const float scale = length_scale(ray);
  TreeQuery query(all, bvh, geometry, ray, scale, counts);
  RTCRayHit ray_hit;
  set_ray(ray_hit.ray, ray, scale);
  embree::set_no_hit(ray_hit.hit);
  embree::trace(tree.scene.get(), query, ray_hit);
  return query.closest();
}

bool any_in(const EmbreeBlocks& all, const EmbreeTree& tree, const Bvh& bvh, const Geometry& geometry,
            const CheckedRay& ray, QueryCounts* counts) {
  const float scale = length_scale(ray);
  TreeQuery query(all, bvh, geometry, ray, scale, counts);
  RTCRay occlusion_ray;
  set_ray(occlusion_ray, ray, scale);
  embree::trace(tree.scene.get(), query, occlusion_ray);
  return query.is_hit;
}

/// An instance that a callback of Embree's is about, entered by its ray.
struct EnteredInstance {
  CheckedRay ray;
  bool is_entered;  ///< False where it cannot be hit.
  const EmbreeTree& tree;
  const Bvh& bvh;

  template <typename Arguments>
  EnteredInstance(const Arguments& arguments, const TreeQuery& query)
      : is_entered(enter(arguments.primID, query)),
        tree(query.all.prototypes[query.geometry.instances()[arguments.primID].prototype]),
        bvh(query.all.bvh.prototypes[query.geometry.instances()[arguments.primID].prototype]) {}

 private:
  bool enter(unsigned instance, const TreeQuery& query) {
    const float t_max = std::min(query.ray.t_max, std::min(query.best.t, query.best_of_instances.t));
    if (!enter_instance(query.geometry.placed(), instance, query.ray, t_max, ray)) return false;
    if (query.counts) ++query.counts->instances;
    return true;
  }
};

void intersect_instance(const RTCIntersectFunctionNArguments* arguments) {
  auto& query = *static_cast<TreeQuery*>(arguments->context);
  const EnteredInstance own(*arguments, query);
  if (!own.is_entered) return;
  const Hit hit = is_far(own.tree, own.ray)
                      ? FarQuery<QueryKind::closest>(query.geometry, own.ray, query.counts).find_in(own.bvh)
                      : closest_in(query.all, own.tree, own.bvh, query.geometry, own.ray, query.counts);
  if (!precedes(hit, query.best_of_instances)) return;
  query.best_of_instances = hit;
  query.shorten(hit.t, *reinterpret_cast<RTCRayHit*>(arguments->rayhit));
}

void occlude_instance(const RTCOccludedFunctionNArguments* arguments) {
  auto& query = *static_cast<TreeQuery*>(arguments->context);
  const EnteredInstance own(*arguments, query);
  if (!own.is_entered) return;
  query.is_hit = is_far(own.tree, own.ray)
                     ? bool(FarQuery<QueryKind::any>(query.geometry, own.ray, query.counts).find_in(own.bvh))
                     : any_in(query.all, own.tree, own.bvh, query.geometry, own.ray, query.counts);
  query.end_if_hit(*reinterpret_cast<RTCRay*>(arguments->ray));
}

void EmbreeBlocks::add_instances(EmbreeTree& tree, InstanceBounds& bounds) {
  embree::GeometryOwner instances = new_geometry(bounds.geometry.instances().size(), &bounds, bound_instance);
  rtcSetGeometryIntersectFunction(instances.get(), intersect_instance);
  rtcSetGeometryOccludedFunction(instances.get(), occlude_instance);
  embree::attach(tree.scene.get(), std::move(instances), 1);
}

class EmbreeAccelerator final : public Accelerator {
 public:
  EmbreeAccelerator(std::shared_ptr<const Geometry> geometry, EmbreeBlocks blocks, AccelStats stats)
      : Accelerator(std::move(geometry), std::move(stats)), blocks_(std::move(blocks)) {}

 private:
  Hit closest(Query query) const noexcept override {
    return closest_of(geometry(), query.ray, [&](const CheckedRay& ray) {
      if (is_far(blocks_.scene, ray))
        return FarQuery<QueryKind::closest>(geometry(), ray, query.counts).find_in(blocks_.bvh);
      return closest_in(blocks_, blocks_.scene, blocks_.bvh.direct, geometry(), ray, query.counts);
    });
  }
  bool any(Query query) const noexcept override {
    return any_of(geometry(), query.ray, [&](const CheckedRay& ray) {
      if (is_far(blocks_.scene, ray))
        return bool(FarQuery<QueryKind::any>(geometry(), ray, query.counts).find_in(blocks_.bvh));
      return any_in(blocks_, blocks_.scene, blocks_.bvh.direct, geometry(), ray, query.counts);
    });
  }

  EmbreeBlocks blocks_;
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
  timed("embree", stats.phases, [&] { blocks.build(*geometry, leaf, options.threads, widening); });
  stats.bytes = blocks.bvh.bytes() + blocks.device.bytes();
  return std::make_unique<EmbreeAccelerator>(std::move(geometry), std::move(blocks), std::move(stats));
}

}  // namespace twinray
