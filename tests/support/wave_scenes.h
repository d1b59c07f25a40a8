// SPDX-License-Identifier: Apache-2.0
// Scenes in which much occurs that a path may meet, made in code from fixed numbers.
#pragma once
#include "core/scene.h"

namespace twinray::test {

/// Random triangles, some of them mirrors, with nothing but skies around.
Scene scene_under_skies();
/// Random triangles of which many lie close to an edge of another, spheres, and a light of every kind.
Scene scene_of_everything();
/// The same lights upon surfaces of every model, balls among them.
Scene scene_of_every_model();
/// The same in fog, with overlapping bodies that absorb or hide each other.
Scene scene_of_interiors();
/// The same without surfaces that are not there.
Scene scene_without_passages();
/// The same in media that scatter: even ones, one of which camera rays may start in, and an uneven one; and
/// surfaces of hair.
Scene scene_in_media();
/// Surfaces of every model, some of which light goes below: closed ones and open ones, in fog and in parts of
/// a mix.
Scene scene_with_bodies();
/// Lamps, balls and points of light, more of each than are sampled alone, some of them behind surfaces that
/// let light through.
Scene scene_of_many_lights();
/// The same, every input of every material by a texture, and meshes that emit by a picture.
Scene textured(Scene scene, TextureFilter filter);
/// The same of a textured scene, with maps that bend all normals.
Scene mapped(Scene scene);

}  // namespace twinray::test
