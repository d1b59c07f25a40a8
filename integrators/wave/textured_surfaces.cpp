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
    if (!shape.textured && shape.is_lambert) continue;
    const Vec2 uv = texture_coordinates(*scene.geometry, hit);
    wave_.texture_u[i] = uv.x;
    wave_.texture_v[i] = uv.y;
    wave_.footprint[i] =
        texture_footprint(*scene.geometry, hit, point_at(i), paths_.cone_width[i], paths_.direction.at(i));
    if (!shape.textured) continue;
    for (const TextureUse& use : shape.textured->textures)
      prefetch_texels(scene.textures, use.texture, texture_point_at(i));
  }
}

TexturePoint PathWave::texture_point_at(std::size_t i) const {
  return {
      {wave_.texture_u[i], wave_.texture_v[i]}, wave_.footprint[i], {wave_.texture_x[i], wave_.texture_y[i]}};
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
