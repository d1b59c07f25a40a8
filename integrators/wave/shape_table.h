// SPDX-License-Identifier: Apache-2.0
// Private: what a wave reads of a scene's shapes, side by side.
#pragma once
#include <cstdint>
#include <vector>

#include "core/light_set.h"
#include "core/rgb.h"
#include "core/scene.h"
#include "integrators/wave/requests.h"

namespace twinray {

/// A shape as its hits are expanded; pointers into the scene.
struct ShapeEntry {
  const Vec3* positions = nullptr;  ///< Null for a set of spheres.
  const Triangle* triangles = nullptr;
  const Vec3* normals = nullptr;  ///< Null where a mesh has none.
  const Triangle* normal_indices = nullptr;
  const Vec2* uvs = nullptr;  ///< Null, too, where the scene has no textures.
  const Triangle* uv_indices = nullptr;
  Rgb reflectance;                     ///< Of a Lambert surface without textures.
  const Material* textured = nullptr;  ///< Its material, where that has textures.
  bool is_lambert = true;              ///< Of one material without maps, whose model is Lambert's.
  bool emits = false;
};

/// One entry for each shape of the scene, which must outlive them; behind them one that points in media are
/// of.
std::vector<ShapeEntry> shape_table(const Scene& scene);

/// Whether a mesh of it has two sets of texture coordinates, and there are textures.
bool has_second_uvs(const Scene& scene);

/// Whether some of its textures go by the points of the scene.
bool has_placed_textures(const Scene& scene);

/// Whether there are too many triangles for all that is known of them to stay in the second cache.
bool exceeds_cache(const Geometry& geometry);

/// One entry for each light; scene and lights must outlive them.
std::vector<PatchTable> patch_tables(const Scene& scene, const LightSet& lights);

/// One for each light, where there are groups of lights; else none.
std::vector<Lamp> lamp_table(const Scene& scene, const LightSet& lights);

}  // namespace twinray
