// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/camera.h"
#include "core/geometry.h"
#include "core/light.h"
#include "core/material.h"
#include "core/texture.h"

namespace twinray {

inline constexpr std::uint32_t no_light = 0xffffffff;

/// What a shape is made of and, where it emits, which light it is: indices into Scene's materials, lights and
/// textures.
struct ShapeBinding {
  std::uint32_t material = 0;
  std::uint32_t light = no_light;
  std::uint32_t alpha = no_texture;  ///< The texture that cuts holes into it (core/alpha_test.h), if any.
  std::uint32_t asset = 0;           ///< What it belongs to: index into Scene::assets, if the scene has any.
};

/// A whole scene: values, linked by index.
struct Scene {
  std::shared_ptr<const Geometry> geometry = std::make_shared<const Geometry>();
  std::vector<ShapeBinding> bindings;  ///< One for each of the geometry's shapes.
  std::vector<Material> materials;
  std::vector<Light> lights;
  std::vector<std::string> light_groups;  ///< Names; each light is of one of them, if there are any.
  std::vector<std::string> assets;        ///< Names; each shape belongs to one of them, if there are any.
  std::vector<Texture> textures;
  Camera camera;
};

/// Throws Error where an index points nowhere, a light's shape is not of the light's kind, a mixture is one
/// of materials behind it, or a shape is opaque that has an alpha, or the other way round.
void check_scene(const Scene& scene);

}  // namespace twinray
