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

void PathWave::ask_for_texels() {
  const Scene& scene = context_.transport.scene;
  for (std::size_t i = 0; i < paths_.size; ++i) {
    const Hit& hit = wave_.hits[i];
    const ShapeEntry& shape = context_.shapes[hit.mesh];
    if ((!shape.textured && shape.is_lambert) || is_in_medium(i)) continue;
    find_coordinates(i, CoordinateSet::first, wave_.texture_u[i], wave_.texture_v[i], wave_.footprint[i]);
    if (context_.has_second_uvs)
      find_coordinates(i, CoordinateSet::second, wave_.second_u[i], wave_.second_v[i],
                       wave_.second_footprint[i]);
    if (!shape.textured) continue;
    for (const TextureUse& use : shape.textured->textures)
      prefetch_texels(scene.textures, use.texture, texture_point_at(i));
  }
}

void PathWave::find_coordinates(std::size_t i, CoordinateSet set, float& u, float& v,
                                float& footprint) const {
  const Geometry& geometry = *context_.transport.scene.geometry;
  const Hit& hit = wave_.hits[i];
  const Vec2 uv = texture_coordinates(geometry, hit, set);
  u = uv.x;
  v = uv.y;
  footprint =
      texture_footprint(geometry, hit, point_at(i), paths_.cone_width[i], paths_.direction.at(i), set);
}

TexturePoint PathWave::texture_point_at(std::size_t i) const {
  TexturePoint at{.uv = {wave_.texture_u[i], wave_.texture_v[i]},
                  .footprint = wave_.footprint[i],
                  .draw = {wave_.texture_x[i], wave_.texture_y[i]}};
  const bool has_second = context_.has_second_uvs;
  at.second_uv = has_second ? Vec2{wave_.second_u[i], wave_.second_v[i]} : at.uv;
  at.second_footprint = has_second ? wave_.second_footprint[i] : at.footprint;
  if (context_.has_placed_textures) {
    const SurfacePoint point = point_at(i);
    at.position = point.position;
    at.normal = point.geometric_normal;
    at.width = section_width(point, paths_.cone_width[i], paths_.direction.at(i));
  }
  return at;
}

void PathWave::find_textured_reflectances() {
  const Scene& scene = context_.transport.scene;
  for (std::size_t i = 0; i < paths_.size; ++i) {
    const ShapeEntry& shape = context_.shapes[wave_.hits[i].mesh];
    if (!shape.textured || !shape.is_lambert) continue;
    const SurfaceModel model = textured_model(*shape.textured, scene.textures, texture_point_at(i));
    surfaces_.reflectance.set(i, std::get<Lambert>(model).reflectance);
  }
}

void PathWave::widen_cones() {
  for (std::size_t i = 0; i < paths_.size; ++i)
    if (Seeking(wave_.seeking[i]) != Seeking::alone)
      paths_.cone_spread[i] = RayCone{0, paths_.cone_spread[i]}.scattered(wave_.pdf[i]).spread;
}

}  // namespace twinray
