// SPDX-License-Identifier: Apache-2.0
#include "tests/support/wrong_engine.h"

#include <algorithm>

#include "accel/canonical/instance_ray.h"
#include "accel/canonical/shape_test.h"
#include "accel/canonical/slab.h"
#include "accel/embree/embree.h"

namespace twinray::test {
namespace {

struct Primitive {
  Aabb box;
  PrimitiveId id;
  std::uint32_t instance = no_instance;  ///< Whose box it then is.
};

struct Node {
  Aabb box;
  std::size_t first = 0, count = 0;  ///< Of a leaf.
  std::unique_ptr<Node> children[2];
};

std::vector<Primitive> primitives_of(const Geometry& geometry) {
  std::vector<Primitive> all;
  const auto add = [&](ShapeRange shapes, std::uint32_t instance) {
    for (std::uint32_t shape = shapes.first; shape < shapes.end(); ++shape)
      for (std::uint32_t i = 0; i < geometry.primitive_count({shape, 1}); ++i) {
        const PrimitiveId id{shape, i};
        all.push_back(
            {instance == no_instance ? primitive_bounds(geometry, id) : geometry.placed()[instance].box, id,
             instance});
      }
  };
  add(geometry.direct_shapes(), no_instance);
  for (std::uint32_t i = 0; i < geometry.instances().size(); ++i)
    add(geometry.prototypes()[geometry.instances()[i].prototype], i);
  return all;
}

class WrongEngine final : public Accelerator {
 public:
  WrongEngine(std::shared_ptr<const Geometry> geometry, Defect defect)
      : Accelerator(std::move(geometry)), defect_(defect), primitives_(primitives_of(this->geometry())) {
    if (defect_ == Defect::last_primitive_lost) primitives_.pop_back();
    root_ = build(0, primitives_.size());
  }

 private:
  std::unique_ptr<Node> build(std::size_t first, std::size_t count) {
    auto node = std::make_unique<Node>();
    for (std::size_t i = first; i < first + count; ++i) node->box.extend(primitives_[i].box);
    if (count <= 2) {
      node->first = first;
      node->count = count;
      return node;
    }
    const Vec3 extent = node->box.extent();
    const int axis = extent.x >= std::max(extent.y, extent.z) ? 0 : extent.y >= extent.z ? 1 : 2;
    const auto begin = primitives_.begin() + std::ptrdiff_t(first);
    std::sort(begin, begin + std::ptrdiff_t(count), [&](const Primitive& a, const Primitive& b) {
      const float p = a.box.center()[axis], q = b.box.center()[axis];
      if (p != q) return p < q;
      if (a.instance != b.instance) return a.instance < b.instance;
      return a.id.mesh != b.id.mesh ? a.id.mesh < b.id.mesh : a.id.primitive < b.id.primitive;
    });
    node->children[0] = build(first, count / 2);
    node->children[1] = build(first + count / 2, count - count / 2);
    return node;
  }

  Hit closest(Query query) const noexcept override {
    return closest_of(geometry(), query.ray, [&](const CheckedRay& ray) {
      Hit best;
      visit<false>(*root_, seen(ray), best);
      return best;
    });
  }
  bool any(Query query) const noexcept override {
    return any_of(geometry(), query.ray, [&](const CheckedRay& ray) {
      Hit found;
      return visit<true>(*root_, seen(ray), found);
    });
  }

  /// The ray as this engine sees it.
  CheckedRay seen(CheckedRay ray) const {
    if (defect_ != Defect::minus_zero_ignored) return ray;
    for (int axis = 0; axis < 3; ++axis) ray.is_negative[axis] = ray.direction[axis] < 0;
    return ray;
  }

  bool intersects(const Aabb& bounds, const CheckedRay& ray, float t_max) const {
    Aabb box = padded(bounds);
    if (defect_ == Defect::box_rounds_inward) {
      const Vec3 inward = bounds.extent() * 1e-6f;
      box = {bounds.lower + inward, bounds.upper - inward};
    }
    const SlabInterval interval = intersect_slab(ray, box);
    if (defect_ == Defect::equal_node_culled && std::max(interval.near, ray.t_min) >= t_max) return false;
    return interval.near <= interval.far && interval.near <= t_max && interval.far >= ray.t_min;
  }

  bool replaces(const Hit& hit, const Hit& best) const {
    if (defect_ == Defect::t_max_lags) return true;
    if (defect_ == Defect::flipped_comparison && hit.t == best.t) return precedes(best, hit);
    return precedes(hit, best);
  }

  /// Whether a hit was found; is_any: stops there.
  template <bool is_any>
  bool visit(const Node& node, const CheckedRay& ray, Hit& best) const {
    if (!intersects(node.box, ray, std::min(ray.t_max, best.t))) return false;
    if (!node.children[0]) return test_leaf<is_any>(node, ray, best);
    const bool left = visit<is_any>(*node.children[0], ray, best);
    if (is_any && (left || defect_ == Defect::right_never_looked_at)) return left;
    if (defect_ == Defect::skipped_child && &node == root_.get()->children[1].get()) return left;
    return visit<is_any>(*node.children[1], ray, best) || left;
  }

  template <bool is_any>
  bool test_leaf(const Node& node, const CheckedRay& ray, Hit& best) const {
    bool found = false;
    for (std::size_t i = node.first; i < node.first + node.count; ++i) {
      Hit hit;
      CheckedRay own = ray;
      const std::uint32_t instance = primitives_[i].instance;
      if (instance != no_instance && !enter_instance(geometry().placed(), instance, ray, ray.t_max, own))
        continue;
      test_primitive(geometry(), own, primitives_[i].id, hit);
      if (hit.is_miss() || !replaces(hit, best)) continue;
      best = hit;
      found = true;
      if (is_any) return true;
    }
    return found;
  }

  Defect defect_;
  std::vector<Primitive> primitives_;
  std::unique_ptr<Node> root_;
};

}  // namespace

const char* defect_name(Defect defect) {
  constexpr const char* names[] = {"none",
                                   "box rounds inward",
                                   "flipped comparison",
                                   "skipped child",
                                   "right never looked at",
                                   "t_max lags",
                                   "last primitive lost",
                                   "minus zero ignored",
                                   "equal node culled",
                                   "embree bounds unpadded"};
  return names[std::size_t(defect)];
}

std::vector<Defect> all_defects() {
  std::vector<Defect> defects{Defect::box_rounds_inward,  Defect::flipped_comparison,
                              Defect::skipped_child,      Defect::right_never_looked_at,
                              Defect::t_max_lags,         Defect::last_primitive_lost,
                              Defect::minus_zero_ignored, Defect::equal_node_culled};
#ifdef TWINRAY_WITH_EMBREE
  defects.push_back(Defect::embree_bounds_unpadded);
#endif
  return defects;
}

std::unique_ptr<Accelerator> build_wrong_engine(std::shared_ptr<const Geometry> geometry, Defect defect) {
#ifdef TWINRAY_WITH_EMBREE
  if (defect == Defect::embree_bounds_unpadded) return build_embree_widened(std::move(geometry), {}, 0);
#endif
  return std::make_unique<WrongEngine>(std::move(geometry), defect);
}

}  // namespace twinray::test
