# SPDX-License-Identifier: Apache-2.0
"""Defects about normal maps, bump maps and tangents, in all folders."""
from mutant import Mutant

CHANNELS = "red of a normal map points along u, green along v, blue along the normal, on both sides"
RAMP = "a bump map that rises evenly shades as a plane that rises so"
SOFT = "at the end of what the geometry sees light falls to nothing, instead of breaking off"
WAVES = "waves have the reference's bits where surfaces have maps, on every engine"
UNEQUAL = "facets of unequal widths have their directions from the texture coordinates"
TURNED = "the tangent of facets is turned from dp/du towards n x dp/du, and so is that of a map"
WIDENED = "what widens facets widens those of the roughness, wherever it stands among the textures"
TRIANGLE = "a triangle's tangents lead from corner to corner as its texture coordinates do"
BALL = "a sphere's tangents are the derivatives of its octahedral coordinates"

MUTANTS = [
    Mutant("green of a normal map points down", "core/shading_map.cpp",
           "2 * color.g - 1,", "1 - 2 * color.g,", "test_integrators", CHANNELS),
    Mutant("bumps are dents", "core/shading_map.cpp",
           "cross(du + n * rise_u, dv + n * rise_v)", "cross(du - n * rise_u, dv - n * rise_v)",
           "test_integrators", RAMP),
    Mutant("a bump's slope is taken over half of its step", "core/shading_map.cpp",
           "const float rise_u = (height(bump_step, 0) - height(-bump_step, 0)) / (2 * bump_step);",
           "const float rise_u = (height(bump_step, 0) - height(-bump_step, 0)) / bump_step;",
           "test_integrators", RAMP),
    Mutant("light of mapped surfaces is not softened", "integrators/interaction.h",
           "if (!shading_.is_mapped) return 1;", "return 1;", "test_integrators", SOFT),
    Mutant("scattered rays of mapped surfaces are not softened", "integrators/scattering.cpp",
           "at.kept(wi) * std::fabs(sample.wi.z)", "std::fabs(sample.wi.z)", "test_integrators",
           "what a mirror with a map shows is softened as light samples are"),
    Mutant("lanes take Lambert's surfaces with maps", "integrators/wave/shape_table.cpp",
           "has_map(material) ? nullptr : std::get_if<Lambert>(&material.model)",
           "std::get_if<Lambert>(&material.model)", "test_integrators", WAVES),
    Mutant("waves sample light for the normal without its map", "integrators/wave/other_surfaces.cpp",
           "    surfaces_.shading.set(other.index, other.at.normal());\n", "", "test_integrators", WAVES),
    Mutant("unequal widths lie along any axis", "integrators/shading_frame.cpp",
           "return {Frame(shading, facet_tangent(scene, material, point, tangents->du)), is_mapped};",
           "return {Frame(shading), is_mapped};",
           "test_integrators", UNEQUAL),
    Mutant("dp/dv has the sign of dp/du", "core/tangents.cpp",
           "solve(-qu, pu)", "solve(qu, pu)", "test_core", TRIANGLE),
    Mutant("the lower half of a ball is taken for the upper one", "core/tangents.cpp",
           "const bool is_folded = normal.z < 0;", "const bool is_folded = false;", "test_core", BALL),
    Mutant("a normal map is decoded as colours are", "io/picture/texture_file.cpp",
           "{path, {PictureRole::data, PictureChannels::color}}, flat",
           "{path, {PictureRole::color, PictureChannels::color}}, flat", "test_io",
           "a normal map is read as data, a displacement is a bump map, and one that is missing is flat"),
    Mutant("brushed surfaces of OpenPBR have no direction", "core/shading_map.cpp",
           "found || model.specular_roughness_anisotropy > 0", "found", "test_core",
           "the facets of a brushed principled surface have a direction"),
    Mutant("the furnace takes one pixel of each texture for all samples", "integrators/furnace.cpp",
           "    point.texture_draw = sampler.draw_2d(Purpose::texture);\n", "", "test_integrators",
           "in a furnace the mean of stochastic textures is that of the pixels around"),
    Mutant("facets are turned with the clock", "core/shading_map.cpp",
           "{cosine * own.x - sine * own.y, sine * own.x + cosine * own.y, 0}",
           "{cosine * own.x + sine * own.y, cosine * own.y - sine * own.x, 0}", "test_integrators", TURNED),
    Mutant("a tangent map is not turned", "core/shading_map.cpp",
           ".to_world({cosine * own.x - sine * own.y, sine * own.x + cosine * own.y, 0})",
           ".to_world({own.x, own.y, 0})", "test_integrators", TURNED),
    Mutant("a tangent that points back is dp/du", "core/shading_map.cpp",
           "if (own.x > 0 && own.y == 0", "if (own.y == 0", "test_integrators", TURNED),
    Mutant("the turn of facets is that of the viewer's side", "integrators/shading_frame.cpp",
           "facet_tangent(scene, material, point, tangents->du)",
           "facet_tangent(scene, material, [&] { auto p = point; p.shading_normal = shading; return p; }(), "
           "tangents->du)", "test_integrators",
           "facets whose tangent is turned are those of texture coordinates that are turned the other way"),
    Mutant("facets are widened before their roughness is known", "core/textured_material.cpp",
           "      widening = value.number();\n",
           "      widen(std::get<Principled>(model), value.number());\n", "test_core", WIDENED),
    Mutant("facets are widened by the root of what the format has", "core/textured_material.cpp",
           "(1 - across) * strength * strength", "(1 - across) * strength", "test_core", WIDENED),
    Mutant("pictures that are scaled beyond 1 are filtered by chance", "core/scene_textures.cpp",
           "is_cut[part] = is_cut[part] || is_cut[i];", "(void)part;", "test_core",
           "pictures whose values are cut off somewhere are not filtered by chance"),
    Mutant("pictures in tiles are taken to lie in [0, 1]", "io/picture/texture_store.cpp",
           "std::move(texture.tiles), texture.is_within_unit)", "std::move(texture.tiles), true)", "test_io",
           "a converted picture says whether its texels lie from 0 to 1"),
    Mutant("normals are looked up by chance", "core/shading_map.cpp",
           "at.is_smooth = true;\n  const Rgb color", "const Rgb color", "test_integrators",
           "between two pixels a map's direction lies between theirs, whatever the filter"),
    Mutant("a sample sees as much as the one before", "core/ray_cone.h",
           "sample < 4 ? 1.0f / 2", "sample < 5 ? 1.0f / 2", "test_core",
           "a camera's cone is as wide as a pixel, or as one's part that a sample stands for"),
    Mutant("all samples see a whole pixel", "integrators/wave/camera_stage.h",
           "pixel_cone_.part(part_of_pixel(sample.index))", "pixel_cone_", "test_integrators",
           "a sample sees less of its pixel the more there were before it"),
]
