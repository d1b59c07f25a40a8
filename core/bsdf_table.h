// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "core/bsdf.h"
#include "core/interiors.h"
#include "core/regularize.h"
#include "core/scene.h"
#include "core/surface.h"

namespace twinray {

/// How a path sees the surfaces that it comes to.
struct Viewing {
  Materials materials = Materials::exact;
  Interiors interiors = {};  ///< That it is in.
};

/// The scattering function of a material at a point: its own, or one of a BsdfTable, which must outlive it.
class BsdfAt {
 public:
  explicit BsdfAt(const Bsdf* of_table) : of_table_(of_table) {}
  explicit BsdfAt(Bsdf&& own) : own_(std::move(own)) {}

  const Bsdf& operator*() const { return own_ ? *own_ : *of_table_; }
  const Bsdf* operator->() const { return &**this; }
  /// Bsdf::look_from.
  void look_from(const Vec3& wo);
  /// Makes it its own, for who outlives the table.
  void keep() {
    if (!own_) own_ = *of_table_;
  }

 private:
  const Bsdf* of_table_ = nullptr;
  std::optional<Bsdf> own_;
};

/// The scattering functions of a scene's materials, made once: some take longer to make than to evaluate.
class BsdfTable {
 public:
  /// The scene must outlive it. `materials` says how they may be asked for: of `exact`, in no other way.
  explicit BsdfTable(const Scene& scene, Materials materials = Materials::regularized);

  const Scene& scene() const { return scene_; }
  /// That of a material, not a Mix, at a point, for a viewer on one side; made anew where textures have a
  /// part in it, or what is around.
  BsdfAt at(std::uint32_t material, const SurfacePoint& point, Side side, const Viewing& viewing = {}) const;

 private:
  const Scene& scene_;
  const std::size_t kinds_;  ///< Of each material: 2 or 4,
  std::vector<Bsdf> made_;   ///< exact outside and inside, and regularized outside and inside.
};

}  // namespace twinray
