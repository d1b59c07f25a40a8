// SPDX-License-Identifier: Apache-2.0
// What records say of surfaces: the same functions for PathReference and for the waves.
#pragma once
#include <algorithm>
#include <cstddef>

#include "core/hit.h"
#include "core/record.h"
#include "core/scene.h"
#include "core/surface.h"
#include "core/vec.h"

namespace twinray {

/// Of a layer of points or directions.
inline Rgb vector_record(const Vec3& v) { return {v.x, v.y, v.z}; }

/// The surface that a camera ray hits.
struct FirstSurface {
  const Hit& hit;
  Vec3 position;
  Vec3 geometric_normal;  ///< On the viewer's side.
};

/// What records say of it: calls `record` with each layer that is of the first surface, and with the function
/// that gives its value for one. Depth is the hit's t, for the direction of a camera ray has length 1 along
/// the camera's axis.
template <class Record>
void record_first_surface(const Scene& scene, Record&& record) {
  using enum Layer;
  using Surface = const FirstSurface&;
  const auto material = [&](Surface surface) { return scene.bindings[surface.hit.mesh].material; };
  record(geometric_normal, [](Surface surface) { return vector_record(surface.geometric_normal); });
  record(depth, [](Surface surface) { return Rgb{surface.hit.t, 0, 0}; });
  record(position, [](Surface surface) { return vector_record(surface.position); });
  record(uv, [&](Surface surface) {
    const Mesh* const mesh = scene.geometry->mesh(surface.hit.mesh);
    if (!mesh || mesh->uvs.empty()) return Rgb{};
    const Vec2 uv = texture_coordinates(*scene.geometry, surface.hit);
    return Rgb{uv.x, uv.y, 0};
  });
  record(ids, [&](Surface surface) {
    const std::uint32_t instance = surface.hit.instance;
    return Rgb{float(surface.hit.mesh) + 1, float(material(surface)) + 1,
               instance == no_instance ? 0 : float(instance) + 1};
  });
  record(object_matte, [](Surface surface) { return record_id(surface.hit.mesh + 1); });
  record(material_matte, [&](Surface surface) { return record_id(material(surface) + 1); });
  record(asset_matte, [&](Surface surface) { return record_id(asset_of(scene, surface.hit.mesh) + 1); });
}

/// A surface that a path has come to from the camera, by mirrors, smooth glass and the like alone, if by any.
struct SeenSurface {
  Rgb throughput;  ///< Of the path.
  float eta_squared = 1;
  Rgb albedo;
};

// Albedo and normal are, in the convention of denoisers, those of the last surface that the path comes to so,
// the albedo tinted by what is between. So a mirror has those of what it shows, and smooth glass a blend by
// Fresnel's equations, as its rays have; where they show nothing, their own.

inline Rgb albedo_record(const SeenSurface& seen) {
  const Rgb albedo = seen.throughput * seen.eta_squared * seen.albedo;
  return {std::min(albedo.r, 1.0f), std::min(albedo.g, 1.0f), std::min(albedo.b, 1.0f)};
}

/// Whether camera rays see an environment wherever they leave the scene.
bool has_environment(const Scene& scene);

/// How much of the picture a camera ray covers.
inline Rgb alpha_record(bool is_beyond_scene, bool has_environment) {
  return {is_beyond_scene && !has_environment ? 0.0f : 1.0f, 0, 0};
}

}  // namespace twinray
