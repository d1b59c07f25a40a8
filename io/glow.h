// SPDX-License-Identifier: Apache-2.0
// What surfaces emit by pictures.
#pragma once
#include <memory>

#include "core/geometry.h"
#include "core/image.h"
#include "core/light.h"
#include "core/texture.h"
#include "io/scene_part.h"

namespace twinray {

struct Glow {
  Rgb radiance;  ///< Black: the surface emits nothing.
  EmissionSide side = EmissionSide::both;
  std::shared_ptr<const Image> picture = nullptr;  ///< Times which the radiance is; null: even.
  UvTransform uv;                                  ///< Of the picture's coordinates.
  Wrap wrap = WrapMode::clamp;
  bool may_move_uvs = false;  ///< By whole numbers: all pictures of the surface repeat.
};

bool emits(const Glow& glow);

/// Sets what a part emits that will have this mesh, whose texture coordinates may be moved by whole numbers.
/// A light has one picture over the unit square of its mesh's own coordinates: where these leave it, the
/// picture's mean stands for it, and the result is false.
bool set_emission(const Glow& glow, Mesh& mesh, ScenePart& part);
/// The warning of that.
inline constexpr const char* emits_mean =
    "texture coordinates beyond one picture are not rendered where it emits: this surface emits the "
    "picture's mean";

}  // namespace twinray
