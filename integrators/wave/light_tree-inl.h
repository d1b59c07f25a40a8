// SPDX-License-Identifier: Apache-2.0
// Private: one of many lights for each surface, chosen by a tree (core/light_tree.h), in lanes, compiled once
// for each instruction set. Each lane walks from the root to a leaf of its own.
#if defined(TWINRAY_WAVE_LIGHT_TREE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TWINRAY_WAVE_LIGHT_TREE_INL_H
#undef TWINRAY_WAVE_LIGHT_TREE_INL_H
#else
#define TWINRAY_WAVE_LIGHT_TREE_INL_H
#endif

#include "core/light_tree.h"
#include "integrators/wave/double_lanes-inl.h"
#include "integrators/wave/fetch-inl.h"
#include "integrators/wave/receivers-inl.h"

HWY_BEFORE_NAMESPACE();
namespace twinray::HWY_NAMESPACE {

/// The functions of core/light_tree.cpp.
HWY_ATTR HWY_INLINE Lanes cos_less(Lanes sin_a, Lanes cos_a, Lanes sin_b, Lanes cos_b) {
  return select(hn::Gt(cos_a, cos_b), splat(1), hn::Add(hn::Mul(cos_a, cos_b), hn::Mul(sin_a, sin_b)));
}
HWY_ATTR HWY_INLINE Lanes sin_less(Lanes sin_a, Lanes cos_a, Lanes sin_b, Lanes cos_b) {
  return select(hn::Gt(cos_a, cos_b), splat(0), hn::Sub(hn::Mul(sin_a, cos_b), hn::Mul(cos_a, sin_b)));
}
HWY_ATTR HWY_INLINE Lanes sine_of(Lanes cosine) {
  return hn::Sqrt(positive(hn::Sub(splat(1), hn::Mul(cosine, cosine))));
}

/// LightNode::importance of the nodes of these numbers.
HWY_ATTR HWY_INLINE Lanes importance(std::span<const LightTree::Node> nodes, WordLanes node,
                                     const ReceiverLanes& receiver) {
  const LightNode& bounds = nodes[0].bounds;
  const Fetch fetch(node, sizeof nodes[0]);
  const Lanes squared_radius = fetch.number(bounds.squared_radius), power = fetch.number(bounds.power);
  const Lanes3 towards = fetch.vector(bounds.center) - receiver.position;
  const Lanes squared = dot(towards, towards);
  const Lanes least = splat(std::numeric_limits<float>::min());
  const Lanes within = hn::Div(power, select(hn::Lt(squared_radius, least), least, squared_radius));

  const Lanes3 direction = towards / hn::Sqrt(squared);
  const Lanes squared_sine = hn::Div(squared_radius, squared);
  const Lanes sin_box = hn::Sqrt(squared_sine), cos_box = hn::Sqrt(hn::Sub(splat(1), squared_sine));

  const Lanes cos_axis = hn::Neg(dot(fetch.vector(bounds.axis), direction)), sin_axis = sine_of(cos_axis);
  const Lanes cos_normals = fetch.number(bounds.cos_normals), sin_normals = fetch.number(bounds.sin_normals);
  const Lanes cos_beyond = cos_less(sin_axis, cos_axis, sin_normals, cos_normals);
  const Lanes sin_beyond = sin_less(sin_axis, cos_axis, sin_normals, cos_normals);
  const Lanes cos_least = cos_less(sin_beyond, cos_beyond, sin_box, cos_box);

  const Lanes cos_normal = select(receiver.is_in_medium, splat(1), dot(receiver.normal, direction));
  const Lanes cos_receiver = select(receiver.lets_light_through, hn::Abs(cos_normal), cos_normal);
  const Lanes cos_at_best =
      hn::Add(cos_less(sine_of(cos_receiver), cos_receiver, sin_box, cos_box), splat(LightNode::slack));
  const Lanes bound = hn::Div(hn::Mul(hn::Mul(power, cos_least), cos_at_best), squared);
  const Lanes beyond = select(hn::Lt(bound, splat(0)), splat(0), bound);
  const Lanes outside = hn::IfThenZeroElse(hn::Lt(cos_least, fetch.number(bounds.cos_emission)), beyond);
  return select(hn::Gt(squared, squared_radius), outside, within);
}

/// 1 where a draw falls on the first of two, of this probability, else 0; the draw is stretched over what it
/// has fallen on.
HWY_ATTR HWY_INLINE HalfLanes falls_on_first(DoubleLanes& draw, HalfLanes probability) {
  const DoubleTag tag;
  const DoubleLanes one = hn::Set(tag, 1), first = hn::PromoteTo(tag, probability);
  const auto is_first = hn::Lt(draw, first);
  draw = hn::IfThenElse(is_first, hn::Div(draw, first), hn::Div(hn::Sub(draw, first), hn::Sub(one, first)));
  return hn::DemoteTo(HalfTag(), hn::IfThenElseZero(is_first, one));
}

/// Uniform draws in [0, 1), from which choices are made one after the other.
class DrawLanes {
 public:
  /// Their sums.
  HWY_ATTR HWY_INLINE DrawLanes(Lanes coarse, Lanes fine)
      : lower_(sum(hn::LowerHalf(HalfTag(), coarse), hn::LowerHalf(HalfTag(), fine))),
        upper_(sum(hn::UpperHalf(HalfTag(), coarse), hn::UpperHalf(HalfTag(), fine))) {}

  HWY_ATTR HWY_INLINE LaneMask choose_first(Lanes probability) {
    const HalfLanes lower = falls_on_first(lower_, hn::LowerHalf(HalfTag(), probability));
    const HalfLanes upper = falls_on_first(upper_, hn::UpperHalf(HalfTag(), probability));
    return is_positive(hn::Combine(FloatTag(), upper, lower));
  }

  /// What is left of them.
  HWY_ATTR HWY_INLINE Lanes rest() const {
    const HalfTag half;
    const Lanes rest = hn::Combine(FloatTag(), hn::DemoteTo(half, upper_), hn::DemoteTo(half, lower_));
    return hn::Min(rest, splat(0x1.fffffep-1f));
  }

 private:
  static HWY_ATTR HWY_INLINE DoubleLanes sum(HalfLanes a, HalfLanes b) {
    return hn::Add(hn::PromoteTo(DoubleTag(), a), hn::PromoteTo(DoubleTag(), b));
  }

  DoubleLanes lower_, upper_;
};

/// The leaves that LightTree::pick comes to, and their probabilities: 0 where it picks none, and behind the
/// lanes that are wanted.
struct LeafLanes {
  WordLanes node;
  Lanes probability, rest;
};
HWY_ATTR HWY_INLINE LeafLanes pick(const LightTree& tree, const ReceiverLanes& receiver, DrawLanes draw,
                                   LaneMask is_wanted) {
  const std::span<const LightTree::Node> nodes = tree.nodes();
  const WordLanes root = hn::Zero(WordTag()), none = hn::Set(WordTag(), LightTree::none);
  const auto weight = [&](WordLanes node) HWY_ATTR {
    return tree.choice() == LightTree::Choice::power
               ? Fetch(node, sizeof nodes[0]).number(nodes[0].bounds.power)
               : importance(nodes, node, receiver);
  };
  WordLanes node = root;
  Lanes probability = hn::IfThenElseZero(is_wanted, splat(1));
  for (;;) {
    const Fetch fetch(node, sizeof nodes[0]);
    const auto is_inner = hn::Eq(fetch.word(nodes[0].light), none);
    const LaneMask walks = hn::And(is_positive(probability), hn::RebindMask(FloatTag(), is_inner));
    if (hn::AllFalse(FloatTag(), walks)) return {node, probability, draw.rest()};
    const auto of_walking = hn::RebindMask(WordTag(), walks);
    const WordLanes first = hn::IfThenElseZero(of_walking, hn::Add(node, hn::Set(WordTag(), 1)));
    const WordLanes second = hn::IfThenElseZero(of_walking, fetch.word(nodes[0].second));
    const Lanes of_first = weight(first), sum = hn::Add(of_first, weight(second));
    const Lanes share = select(hn::Lt(sum, splat(std::numeric_limits<float>::infinity())),
                               hn::Div(of_first, sum), splat(0.5f));
    // Where a lane has arrived, all of the draw is left.
    const LaneMask is_first = draw.choose_first(select(walks, share, splat(1)));
    const Lanes chosen = select(is_first, share, hn::Sub(splat(1), share));
    const Lanes product = hn::IfThenElseZero(is_positive(sum), hn::Mul(probability, chosen));
    probability = select(walks, product, probability);
    const WordLanes child = hn::IfThenElse(hn::RebindMask(WordTag(), is_first), first, second);
    node = hn::IfThenElse(of_walking, child, node);
  }
}

HWY_ATTR void choose_lights(const LightSet::Group& group, const Surfaces& surfaces, Floats& u,
                            std::size_t size, LightPicks& picks) {
  const std::span<const LightTree::Node> nodes = group.tree.nodes();
  for (std::size_t i = 0; i < size; i += lane_count) {
    store(hn::Zero(WordTag()), picks.light, i);
    store(splat(0), picks.probability, i);
    if (nodes.empty()) continue;
    const ReceiverLanes receiver = load_receivers(surfaces, i);
    const DrawLanes draw(load(u, i), load(picks.finer, i));
    const LeafLanes leaf = pick(group.tree, receiver, draw, within(i, size));
    const auto is_picked = hn::RebindMask(WordTag(), is_positive(leaf.probability));
    const WordLanes place = Fetch(leaf.node, sizeof nodes[0]).word(nodes[0].light);
    const Fetch light(hn::IfThenElseZero(is_picked, place), sizeof(std::uint32_t));
    store(hn::IfThenElseZero(is_picked, light.word(group.lights[0])), picks.light, i);
    store(leaf.probability, picks.probability, i);
    store(leaf.rest, u, i);
  }
}

}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
