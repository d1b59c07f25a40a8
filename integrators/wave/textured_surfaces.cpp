// SPDX-License-Identifier: Apache-2.0
// What a wave does where a scene has textures: its paths' cones, and the reflectance of Lambert surfaces.
#include "core/textured_material.h"
#include "integrators/wave/path_wave.h"

namespace twinray {

void PathWave::prepare_textures() {
  draw(Purpose::texture, {}, wave_.texture_x, wave_.texture_y);
  for (std::size_t i = 0; i < paths_.size; ++i) {
    const float distance = wave_.hits[i].t * length(paths_.direction.at(i));
    paths_.cone_width[i] = RayCone{paths_.cone_width[i], paths_.cone_spread[i]}.at(distance).width;
  }
}

SurfacePoint PathWave::with_footprint(SurfacePoint point, std::size_t i) const {
  if (!has_textures()) return point;
  const Geometry& geometry = *context_.transport.scene.geometry;
  const Hit& hit = wave_.hits[i];
  point.uv = texture_coordinates(geometry, hit);
  point.footprint = texture_footprint(geometry, hit, point, paths_.cone_width[i], paths_.direction.at(i));
  point.texture_draw = {wave_.texture_x[i], wave_.texture_y[i]};
  return point;
}

Rgb PathWave::textured_reflectance(const ShapeEntry& shape, std::size_t i) const {
  const SurfacePoint point = surface_at(*context_.transport.scene.geometry, wave_.hits[i]);
  const TexturePoint at = texture_point(with_footprint(point, i));
  return std::get<Lambert>(textured_model(*shape.textured, context_.transport.scene.textures, at))
      .reflectance;
}

void PathWave::widen_cones() {
  for (std::size_t i = 0; i < paths_.size; ++i)
    if (Seeking(wave_.seeking[i]) != Seeking::alone)
      paths_.cone_spread[i] = RayCone{0, paths_.cone_spread[i]}.scattered(wave_.pdf[i]).spread;
}

}  // namespace twinray
