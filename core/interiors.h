// SPDX-License-Identifier: Apache-2.0
// Where a path is: in which of the closed surfaces that it has entered, and what that means for its light.
#pragma once
#include <cstdint>
#include <span>

#include "core/material.h"

namespace twinray {

/// The interiors that a path is in, as materials of a scene. Up to four: where a fifth is entered, the one
/// entered first is forgotten.
class Interiors {
 public:
  /// Materials of higher indices have no interior.
  static constexpr std::uint32_t most_materials = 0xffff;
  static constexpr std::uint32_t none = 0xffffffff;

  Interiors() = default;
  /// What bits() gave.
  explicit Interiors(std::uint64_t bits) : bits_(bits) {}
  std::uint64_t bits() const { return bits_; }

  bool empty() const { return bits_ == 0; }
  void enter(std::uint32_t material) { bits_ = bits_ << 16 | (material + 1); }
  /// Leaves it once; nothing happens where it was not entered.
  void leave(std::uint32_t material);
  /// Of a material, or of the parts of a mix, the one entered last; `none` where none was.
  std::uint32_t entered(std::uint32_t material, std::span<const Material> materials) const;
  /// The index of the one that is there, of several: that of the highest priority, of equals the one entered
  /// last. `none` outside of all.
  std::uint32_t prevailing(std::span<const Material> materials) const;
  /// Those that are in `other`, too, each as often as in both; in the order in which these were entered.
  Interiors shared_with(Interiors other) const;

 private:
  std::uint64_t bits_ = 0;  ///< Four indices plus one, the last one entered lowest; 0 for none.
};

/// Where nothing fills a body and nothing has a priority, it is the same whether a path knows that it is in
/// something clear: it need not.
void forget_clear_interiors(std::span<Material> materials);

/// The index of refraction of what is within a surface of this model, to what is outside; 1 of others.
float ior_of(const SurfaceModel& model);

/// Whether anything scatters light on its way between surfaces, or dims it here more than there.
bool has_flights(std::span<const Material> materials);

/// Whether anything emits light between surfaces,
bool has_glow(std::span<const Material> materials);
/// or does so here more than there.
bool has_uneven_glow(std::span<const Material> materials);

/// What is there, of several interiors; null outside of all.
const Interior* medium_in(std::span<const Material> materials, const Interiors& interiors);
inline bool scatters(const Interior& medium) { return !is_black(medium.scattering); }

/// The part of light that is left behind a way through interiors whose media are even, neither absorbed nor
/// scattered; `length` may be infinite.
Rgb transmittance(std::span<const Material> materials, const Interiors& interiors, float length);
/// An extinction below it is none: within the distances that floats have, it dims nothing.
inline constexpr float least_extinction = 1e-30f;
/// The same of one medium, by how much of it there is.
Rgb transmittance(const Rgb& extinction, float amount);
/// So much of it leaves nothing but what it does not dim at all: more does neither.
float opaque_amount(const Rgb& extinction);

/// What a surface is a boundary to, by the priorities of nested interiors (Schmidt and Budge, "Simple Nested
/// Dielectrics in Ray Traced Images", 2002).
struct Surroundings {
  /// Whether the surface lies within something of a higher priority: it is not there.
  bool is_hidden = false;
  /// The index of refraction of what is outside of the surface, to the vacuum.
  float ior = 1;
};
/// Of a surface of a material, to a viewer who is in `interiors` and sees it from outside or inside. Surfaces
/// that let light in and have priority 0, and all that lie in interiors of priority 0, are boundaries to
/// whatever they were described for.
Surroundings surroundings_of(std::span<const Material> materials, std::uint32_t material, bool is_inside,
                             Interiors interiors);

/// The model whose indices of refraction are relative to the vacuum, within something of another index.
SurfaceModel immersed(const SurfaceModel& model, float ior);

}  // namespace twinray
