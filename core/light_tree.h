// SPDX-License-Identifier: Apache-2.0
// Which of many lights a surface is lit by: one is chosen, with a probability close to the light that it may
// bring (Conty and Kulla, "Importance Sampling of Many Lights with Adaptive Tree Splitting", 2018; without
// the splitting). The lights are leaves of a binary tree. A node knows the box around its lights, their power
// and a cone around the directions in which they emit; from the root on, a child is chosen by a bound of
// what it brings there: a walk of as many steps as the tree is deep.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/aabb.h"
#include "core/angle.h"
#include "core/light_patch.h"
#include "core/vec.h"

namespace twinray {

/// The directions of normals, and how far from a normal light is emitted: angles in radians.
struct EmissionCone {
  Vec3 axis{0, 0, 1};                     ///< Unit.
  double normals = pi_double;             ///< Around the axis, all normals lie within; in [0, pi].
  double emission = 1.57079632679489662;  ///< Around a normal, all light goes within; in [0, pi / 2].
};

/// A light, or several, as the tree sees them.
struct LightBounds {
  Aabb box;
  double power = 0;  ///< Any measure of the light that is sent, >= 0.
  EmissionCone cone;
};

/// A cone of all normals of both.
EmissionCone together(EmissionCone a, EmissionCone b);
/// The bounds of both.
LightBounds together(const LightBounds& a, const LightBounds& b);

/// What is asked of bounds at a receiver, prepared.
struct LightNode {
  explicit LightNode(const LightBounds& bounds);
  /// A measure of how much light of these bounds a receiver gets at most.
  float importance(const Receiver& receiver) const;

  /// Rounding must not cut off light that goes just within a cone.
  static constexpr float slack = 1e-5f;

  Vec3 center, axis;
  float squared_radius = 0, power = 0;
  float cos_normals = -1, sin_normals = 0, cos_emission = 0;
};

class LightTree {
 public:
  /// By `power` alone lights are chosen without regard to the receiver.
  enum class Choice { importance, power };
  struct Pick {
    std::uint32_t light;  ///< Index into the bounds that the tree was built of.
    float probability;    ///< > 0.
    float rest;           ///< Of the draw: in [0, 1), uniform again.
  };
  static constexpr std::uint32_t none = 0xffffffff;
  struct Node {
    LightNode bounds;
    std::uint32_t parent = none;
    std::uint32_t second = none;  ///< The first child follows its parent. None: a leaf.
    std::uint32_t light = none;
  };

  LightTree() = default;
  /// Lights of no power are never picked.
  explicit LightTree(std::span<const LightBounds> lights, Choice choice = Choice::importance);

  /// u in [0, 1). None where no light can reach the receiver.
  std::optional<Pick> pick(const Receiver& receiver, double u) const;
  /// The probability with which pick() chooses a light.
  float probability(std::uint32_t light, const Receiver& receiver) const;
  /// How many nodes lie between the root and the deepest light, both counted; 0 for an empty tree.
  int depth() const { return depth_; }
  Choice choice() const { return choice_; }
  /// The root first.
  std::span<const Node> nodes() const { return nodes_; }

 private:
  /// The node of these lights, and all below it; order holds their indices, at least one.
  LightBounds build(std::span<const LightBounds> lights, std::span<std::uint32_t> order, std::uint32_t parent,
                    int level);
  /// The probability of the first of a node's children; negative where none can be chosen.
  float first_probability(std::uint32_t node, const Receiver& receiver) const;
  float weight(std::uint32_t node, const Receiver& receiver) const;

  Choice choice_ = Choice::importance;
  int depth_ = 0;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> leaf_of_;  ///< By light; none where it has no power.
};

}  // namespace twinray
