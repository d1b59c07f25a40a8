// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/memory.h"
#include "io/loaded_scene.h"

namespace twinray {

/// A material, and how much of the scene is made of it.
struct MaterialInfo {
  std::string name;
  std::string model;  ///< "lambert", "principled", ...: as exchange files call it.
  std::size_t textures = 0, shapes = 0, triangles = 0;
};

/// A texture that is a picture.
struct PictureInfo {
  std::string name;
  int width = 0, height = 0;
  std::uint64_t bytes = 0;  ///< In memory, with its mip-map.
};

/// What fills bodies, by the materials of their boundaries.
struct MediaInfo {
  std::size_t absorbing = 0;   ///< Those that absorb alone,
  std::size_t scattering = 0;  ///< that scatter light,
  std::size_t uneven = 0;      ///< and, of both, whose density is not even,
  std::size_t glowing = 0;     ///< or that emit light.
  std::size_t subsurface = 0;  ///< Materials below whose surfaces light is scattered.
  bool has_atmosphere = false;
};

/// What is in a scene.
struct SceneInfo {
  std::string scene;
  SceneSummary summary;
  Aabb bounds;  ///< Of all shapes.
  std::size_t cut_out_triangles = 0;
  std::uint64_t geometry_bytes = 0;
  std::uint64_t light_picture_bytes = 0;  ///< Of pictures that lights shine by.
  std::uint64_t density_bytes = 0;        ///< Of media that are not even.
  std::uint64_t measurement_bytes = 0;    ///< Of materials that were measured.
  MediaInfo media;
  std::vector<MaterialInfo> materials;
  std::vector<PictureInfo> pictures;
  std::vector<std::string> files;  ///< That it was read from, each once.
  std::vector<std::string> warnings;
  std::vector<MemoryNeed> needs;  ///< What a render takes besides.
};

/// All but the names of its files and what a render takes.
SceneInfo scene_info(const std::string& name, const LoadedScene& loaded);

}  // namespace twinray
