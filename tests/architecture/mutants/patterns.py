# SPDX-License-Identifier: Apache-2.0
"""Defects of textures that are computed: noise, dots, corners, and what goes by the points of the scene."""
from mutant import Mutant

NOISE = "noise is pbrt-v4's"
OCTAVES = "octaves are added up as pbrt-v4 does, as far as the width lets them be seen"
FAR = "noise beyond what has whole numbers, and of what is no number, is 0"
DOTS = "dots lie where pbrt-v4's do, and cover the part of the plane that is said"
MARBLE = "marble has pbrt-v4's colours along its phase, which repeat after a turn"
SPACE = "cubes alternate in space, and directions mix by the normal on either side"
PLANE = "dots and what lies between corners go by the transformed coordinates"
WIDTH = "noise goes by the point and by the width of what is seen"
SPHERE = "a pattern around a sphere has the angle from z in half turns, and that around it in turns"
CYLINDER = "a pattern around a cylinder has the angle from -x in turns, and z"
FOOTPRINT = "a footprint around an axis is how far the coordinates change on the surface"
POSITION = "textures that go by the point in the scene are told from the others, whatever they are part of"
MEAN = "the mean of a texture is that of many points, where its parts are independent"
WAVES = "waves of paths have the bits and the rays of paths one after the other"
CORNERS = "corners are mixed over the unit square, and dots lie on another texture"
PLACED = "a pattern in the plane is placed by its mapping"
IN_SPACE = "patterns in space lie where their transform puts them"
DIRECTION = "a mix by direction turns with its transform, and goes by the normal of the geometry"
WRITTEN = "written pbrt: textures of each class give the same values, as colors and as numbers"
EXCHANGED = "textures come back from exchange form with all that they are made of"
BAKED = "what goes by the points of the scene is baked as its mean, and what never repeats in part"
VERSION = "textures in exchange form are of its third version, patterns of its fourth"

MUTANTS = [
    Mutant("four directions of noise are others", "core/noise.cpp",
           "10, 11, 0, 1, 10, 11}", "10, 11, 0, 1, 2, 3}", "test_core", NOISE),
    Mutant("noise has creases at whole points", "core/noise.cpp",
           "return t * t * t * (t * (t * 6 - 15) + 10);", "return t;", "test_core", NOISE),
    Mutant("noise beyond whole numbers is undefined", "core/noise.cpp",
           "if (!(max_abs(p) < most) || !is_finite(p)) return 0;", "", "test_core", FAR),
    Mutant("octaves are twice as fine", "core/noise.cpp", "finer *= 1.99f", "finer *= 2", "test_core",
           OCTAVES),
    Mutant("octaves as fine as the width are seen", "core/noise.cpp",
           "-1 - short_log2_of(width)", "0 - short_log2_of(width)", "test_core", OCTAVES),
    Mutant("octaves come in at once", "core/noise.cpp",
           "smooth_step(count - float(whole), 0.3f, 0.7f)", "0", "test_core", OCTAVES),
    Mutant("nothing stands for creases that are not seen", "core/noise.cpp",
           "i < octaves.most; ++i, octave.next()) sum += octave.strength * mean;", "false;) ;", "test_core",
           OCTAVES),
    Mutant("dots lie in the middle of their squares", "core/noise.cpp",
           "most_shift = 0.5f - radius", "most_shift = 0", "test_core", DOTS),
    Mutant("marble is half a turn off", "core/noise.cpp", "(0.5f + 0.5f *", "(0.5f - 0.5f *", "test_core",
           MARBLE),
    Mutant("cubes are columns", "core/texture_pattern.cpp",
           " + std::floor(double(p.z)));", ");", "test_core", SPACE),
    Mutant("corners along u are those along v", "core/texture_pattern.cpp",
           "texture.v10 * uv.x) * (1 - uv.y)", "texture.v01 * uv.x) * (1 - uv.y)", "test_core", PLANE),
    Mutant("gusts blow backwards", "core/texture_pattern.cpp",
           "std::fabs(fbm(p * 0.1f, at.width * 0.1f, {3}))", "fbm(p * 0.1f, at.width * 0.1f, {3})",
           "test_core", WIDTH),
    Mutant("marble is seen without a width", "core/texture_pattern.cpp",
           "at.width * std::fabs(texture.scale)", "at.width", "test_core", WIDTH),
    Mutant("a direction mixes by one side alone", "core/texture.cpp",
           "std::fabs(dot(at.normal, texture.direction))", "dot(at.normal, texture.direction)", "test_core",
           SPACE),
    Mutant("the angle from a sphere's pole is in turns", "core/texture_placement.cpp",
           "2 * float(atan2_turns(around, p.z))", "float(atan2_turns(around, p.z))", "test_core", SPHERE),
    Mutant("a cylinder begins at +x", "core/texture_placement.cpp",
           "turns <= 0.5f ? turns + 0.5f : turns - 0.5f", "turns", "test_core", CYLINDER),
    Mutant("on an axis a footprint is not finite", "core/texture_placement.cpp",
           "std::isfinite(density) ? density : 0", "density", "test_core", FOOTPRINT),
    Mutant("what is made of a placed pattern goes by the surface", "core/scene_textures.cpp",
           "found[i] = found[i] || (part < i && found[part]);", "(void)part;", "test_core", POSITION),
    Mutant("a pattern in a plane needs the surface's coordinates", "core/scene_textures.cpp",
           "placed && placed->placement != TexturePlacement::space", "false", "test_core",
           "textures that go by the surface's coordinates are told from the others"),
    Mutant("every square has a dot", "core/noise.h", "25832.0f / 65536 *", "", "test_core", MEAN),
    Mutant("waves know no point of textures", "integrators/wave/textured_surfaces.cpp",
           "at.position = point.position;", "", "test_integrators", WAVES),
    Mutant("waves know no width of textures", "integrators/wave/other_surfaces.cpp",
           "point.width = at.width;", "", "test_integrators", WAVES),
    Mutant("bumps are asked for at one point", "core/shading_map.cpp",
           "at.position += tangents.du * du + tangents.dv * dv;", "", "test_integrators",
           "a bump map in space rises as one by texture coordinates"),
    Mutant("holes of noise are at the origin", "core/alpha_test.cpp",
           "by_position_[texture] ? texture_point(surface_at(geometry, hit))",
           "false ? texture_point(surface_at(geometry, hit))", "test_accel",
           "holes may go by the points of the scene, also those of instances"),
    Mutant("a lamp's holes lie by its coordinates alone", "core/light_set.cpp",
           "texture_point(surface_at(geometry_, hit))", "{.uv = texture_coordinates(geometry_, hit)}",
           "test_integrators",
           "a lamp with holes by points of the scene emits from what is left, by every way of finding it"),
    Mutant("waves take all textures for those of coordinates", "integrators/path.cpp",
           "has_placed_textures_(has_placed_textures(scene))", "has_placed_textures_(false)",
           "test_integrators", WAVES),
    Mutant("coordinates that single precision has not are taken", "io/pbrt/texture.cpp",
           "is_finite && std::isfinite(number)", "true", "test_io",
           "what is wrong with a texture that is placed is said at its statement"),
    Mutant("no shape needs coordinates for its textures", "io/pbrt/builder.cpp",
           "return materials_.textures.needs_coordinates(use.texture);", "return use.texture == no_texture;",
           "test_io", "a mesh without texture coordinates has those that pbrt gives each triangle"),
    Mutant("a pattern that pbrt cannot place is not named", "io/pbrt/writer_texture.cpp",
           "if (!to_world || uv != UvTransform{})", "if (!to_world)", "test_io",
           "written pbrt: marble has its colors, is its mean as a number, and what cannot be placed is "
           "named"),
    Mutant("planes are written turned", "io/pbrt/writer_texture.cpp",
           'pbrt_vector(i == 0 ? "v1" : "v2"', 'pbrt_vector(i == 0 ? "v2" : "v1"', "test_io", WRITTEN),
    Mutant("colors between corners are grey", "io/pbrt/texture.cpp",
           'corner("v01", 1)', 'corner("v01", 0)', "test_io", CORNERS),
    Mutant("a plane's second axis is its first", "io/pbrt/texture.cpp",
           "{v1, v2, own_axes[2]}", "{v1, v1, own_axes[2]}", "test_io", PLACED),
    Mutant("squares that are placed are the other ones", "io/pbrt/texture.cpp",
           "pattern.first = constant({}).index;", "pattern.first = constant(white).index;", "test_io",
           PLACED),
    Mutant("patterns lie where their transform comes from", "io/pbrt/texture.cpp",
           "const Transform from_scene = from_world(statement);",
           "const Transform from_scene = statement.to_world;", "test_io", IN_SPACE),
    Mutant("a direction does not turn", "io/pbrt/texture.cpp",
           'statement.to_world.vector(parameters.point("dir", {0, 1, 0}))',
           'parameters.point("dir", {0, 1, 0})', "test_io", DIRECTION),
    Mutant("a pattern is written where the world is", "io/pbrt/writer_texture.cpp",
           "pbrt_transform(to_world.value_or(Transform{}))", "pbrt_transform(Transform{})", "test_io",
           WRITTEN),
    Mutant("a pattern on a plane is written without its own coordinates", "io/pbrt/writer_texture.cpp",
           "uv.m[i][0] * texture.to_texture.m[0][k] + uv.m[i][1] * texture.to_texture.m[1][k]",
           "texture.to_texture.m[i][k]", "test_io", WRITTEN),
    Mutant("cubes are baked as they are at the origin", "io/picture/baked_texture.cpp",
           "if (by_position[i]) list[i].model = ConstantTexture{means[i]};", "", "test_io", BAKED),
    Mutant("nobody is told that cubes are baked", "io/picture/baked_texture.cpp",
           "frame.is_exact && are_by_surface", "frame.is_exact", "test_io", BAKED),
    Mutant("dots are baked as one", "io/picture/baked_texture.cpp",
           "{texture.uv, 8, 256, 256", "{texture.uv, 1, 256, 256", "test_io", BAKED),
    Mutant("an exchange form has no roughness of noise", "io/exchange/members.h",
           'visit("roughness", texture.octaves.roughness, Valid::any);', "", "test_io", EXCHANGED),
    Mutant("an exchange form with noise is of the third version", "io/exchange/writer.cpp",
           "if (!std::visit(IsOfThirdVersion{}, texture.model)) return 4;", "", "test_io", VERSION),
]
