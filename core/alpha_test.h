// SPDX-License-Identifier: Apache-2.0
// Cut-outs: a texture says how much there is of a surface at each point, its alpha. Where that is between 0
// and 1, a hit counts with this probability: by a hash of ray and primitive, as in pbrt-v4 (whose hash is of
// the ray alone; there the ray begins anew behind each hit that does not count).
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/acceptance.h"
#include "core/geometry.h"
#include "core/scene.h"
#include "core/texture.h"

namespace twinray {

/// How much there is of a surface at a point: a texture's red, in [0, 1].
float alpha_at(std::span<const Texture> textures, std::uint32_t texture, TexturePoint at);

/// The acceptance of shapes by their alpha.
class AlphaTest final : public Acceptance {
 public:
  /// `alphas`: of each shape an index into `textures`, or no_texture where it is opaque.
  AlphaTest(std::vector<Texture> textures, std::vector<std::uint32_t> alphas);
  bool accepts(const Geometry& geometry, const Vec3& origin, const Vec3& direction,
               const Hit& hit) const noexcept override;

 private:
  std::vector<Texture> textures_;
  std::vector<std::uint32_t> alphas_;
  std::vector<bool> by_position_;  ///< Of each texture: whether it goes by the point in the scene.
};

/// The geometry of shapes that are cut out as their bindings say. One binding for each shape.
Geometry cut_out(std::vector<Shape> shapes, std::span<const ShapeBinding> bindings,
                 std::span<const Texture> textures, Instancing instancing = {});

}  // namespace twinray
