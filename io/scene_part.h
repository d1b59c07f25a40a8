// SPDX-License-Identifier: Apache-2.0
// How readers put scenes together: shapes with what they are made of, and the rest.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/scene.h"

namespace twinray {

/// A shape in the making, with what it wears and what it emits.
struct ScenePart {
  Shape shape;
  std::uint32_t material = 0;
  MeshLight glow = {};  ///< A mesh's, but for its shape; a sphere has the radiance. Black: no light.
  std::string light_name = {};
  std::uint32_t asset = no_asset;    ///< What it belongs to.
  std::uint32_t alpha = no_texture;  ///< The texture that cuts holes into it.
  /// Which prototype it is a shape of, if it stands in the scene by instances alone. Such a part emits
  /// nothing.
  std::optional<std::uint32_t> prototype = {};
};

/// A scene of these shapes. `rest` has all but them: materials, textures, lights without a shape, which come
/// behind those of shapes, in the order of these, and what else there is. `instances` are those of the parts'
/// prototypes. Throws Error as Geometry and check_scene() do.
Scene assemble(std::vector<ScenePart> parts, Scene rest, std::vector<Instance> instances = {});

}  // namespace twinray
