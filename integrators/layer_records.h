// SPDX-License-Identifier: Apache-2.0
// What records say of surfaces: the same functions for PathReference and for the waves.
#pragma once
#include <algorithm>
#include <cstddef>

#include "core/hit.h"
#include "core/record.h"
#include "core/scene.h"
#include "core/vec.h"

namespace twinray {

/// The surface that a camera ray hits.
struct FirstSurface {
  const Hit& hit;
  Vec3 position;
  Vec3 geometric_normal;  ///< On the viewer's side.
};

/// Writes what the first surface is asked for, into a sample's record: geometric normal, depth (the hit's t,
/// for the direction of a camera ray has length 1 along the camera's axis), position, texture coordinates,
/// ids.
void record_first_surface(const Scene& scene, const FirstSurface& surface, const RecordSpans& records,
                          std::size_t sample);

/// Whether any record is asked for that.
bool shows_first_surface(const RecordSpans& records);

/// A surface that a path has come to from the camera, by mirrors, smooth glass and the like alone, if by any.
struct SeenSurface {
  Rgb throughput;  ///< Of the path.
  float eta_squared = 1;
  Rgb albedo;
  Vec3 normal;  ///< Its shading normal.
};

/// Whether any record is asked for what surfaces look like.
inline bool shows_features(const RecordSpans& records) {
  return records.has(Layer::albedo) || records.has(Layer::normal);
}

/// Writes albedo and normal, in the convention of denoisers: those of the last surface that the path comes to
/// so, the albedo tinted by what is between. So a mirror has those of what it shows, and smooth glass a blend
/// by Fresnel's equations, as its rays have; where they show nothing, their own.
inline void record_features(const SeenSurface& seen, const RecordSpans& records, std::size_t sample) {
  const Rgb tint = seen.throughput * seen.eta_squared;
  const Rgb albedo = tint * seen.albedo;
  if (records.has(Layer::albedo))
    records[Layer::albedo][sample] = {std::min(albedo.r, 1.0f), std::min(albedo.g, 1.0f),
                                      std::min(albedo.b, 1.0f)};
  if (records.has(Layer::normal))
    records[Layer::normal][sample] = {seen.normal.x, seen.normal.y, seen.normal.z};
}

/// Whether camera rays see an environment wherever they leave the scene.
bool has_environment(const Scene& scene);

/// Writes how much of the picture a camera ray covers.
inline void record_alpha(const Hit& hit, bool has_environment, const RecordSpans& records,
                         std::size_t sample) {
  if (records.has(Layer::alpha))
    records[Layer::alpha][sample] = {hit.is_miss() && !has_environment ? 0.0f : 1.0f, 0, 0};
}

}  // namespace twinray
