// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/camera.h"
#include "core/density_grid.h"
#include "core/geometry.h"
#include "core/light.h"
#include "core/material.h"
#include "core/texture.h"

namespace twinray {

inline constexpr std::uint32_t no_light = 0xffffffff, no_asset = 0xffffffff, no_material = 0xffffffff;

/// What a shape is made of and, where it emits, which light it is: indices into Scene's materials, lights and
/// textures.
struct ShapeBinding {
  std::uint32_t material = 0;
  std::uint32_t light = no_light;
  std::uint32_t alpha = no_texture;  ///< The texture that cuts holes into it (core/alpha_test.h), if any.
  std::uint32_t asset = no_asset;    ///< What it belongs to: index into Scene::assets; itself, if none.
};

/// A whole scene: values, linked by index.
struct Scene {
  std::shared_ptr<const Geometry> geometry = std::make_shared<const Geometry>();
  std::vector<ShapeBinding> bindings;  ///< One for each of the geometry's shapes.
  std::vector<Material> materials;
  std::vector<Light> lights;
  std::vector<std::string> light_groups;  ///< Names; each light is of one of them, if there are any,
  std::uint32_t media_group = no_light;   ///< and so is what media emit, if they do.
  std::vector<std::string> assets;        ///< Names of what several shapes may belong to.
  std::vector<Texture> textures;
  std::vector<std::shared_ptr<const DensityGrid>> densities;  ///< Of media that are not even.
  Camera camera;
  /// The material whose interior fills space around all bodies, if any. An Interface.
  std::uint32_t atmosphere = no_material;
};

/// The number of what a shape belongs to: of one of the scene's assets or, behind all of them, its own.
inline std::uint32_t asset_of(const Scene& scene, std::uint32_t shape) {
  const std::uint32_t asset = scene.bindings[shape].asset;
  return asset != no_asset ? asset : std::uint32_t(scene.assets.size()) + shape;
}

/// Throws Error where an index points nowhere, a light's shape is not of the light's kind, a mixture is one
/// of materials behind it, the atmosphere is that of no interface, light is of no group where there are any,
/// or a shape is opaque that has an alpha, or the other way round.
void check_scene(const Scene& scene);

}  // namespace twinray
