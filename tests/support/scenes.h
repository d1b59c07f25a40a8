// SPDX-License-Identifier: Apache-2.0
// Small scenes made in code, whose light is known in closed form.
#pragma once
#include "core/scene.h"

namespace twinray::test {

/// An axis-aligned box [-half, half]^3 of twelve triangles whose fronts face inward.
Mesh inward_box(float half);
/// A square [-half, half]^2 at height y whose front faces up (+y).
Mesh floor_square(float half, float y);
/// A closed sphere of radius 1 around the origin, fronts outward, of 20 * 4^subdivisions triangles.
Mesh icosphere(int subdivisions);

/// A scene of one mesh of one Lambert material, seen by a camera at `eye` that looks at `target`.
Scene scene_of(Mesh mesh, const Rgb& reflectance, const Vec3& eye, const Vec3& target);
/// Adds a shape with a black Lambert material that emits; returns its shape index.
std::uint32_t add_lamp(Scene& scene, Shape shape, const Rgb& radiance, EmissionSide side);
/// Adds a light without a shape.
void add_light(Scene& scene, LightSource source);

/// A sky of one colour all around.
EnvironmentLight constant_sky(const Rgb& radiance);
/// A ball of a model that fills the picture, under such a sky.
Scene ball_under_sky(const SurfaceModel& model, const Rgb& radiance = {1, 1, 1});

/// A camera of 40 degrees at `eye` that looks at `target`; up is +y, or +z where it looks along y.
Camera camera_at(const Vec3& eye, const Vec3& target);

/// The closed box of side 2 all of whose walls emit and reflect: from inside, radiance is
/// emitted / (1 - reflectance) everywhere; with m bounces at most, emitted (1 - reflectance^(m+1)) / (1 -
/// reflectance).
Scene emissive_enclosure(float emitted, float reflectance);

/// A box of coloured walls with a lamp under its ceiling, an icosphere and a sphere: a little of everything.
/// Its sides are 2 scale.
Scene small_room(float scale = 1);

}  // namespace twinray::test
