# SPDX-License-Identifier: Apache-2.0
"""Scenes of meshes alone: OBJ with MTL, PLY, and the light that such have by default."""
from mutant import Mutant

FACES = "faces of an OBJ file become triangles with their winding, normals and texture coordinates"
CORNERS = "a face of an OBJ file may have many corners, be concave, and stand before its vertices"
PARTS = "objects, groups and materials of an OBJ file are shapes of their own"
WRONG = "what is wrong with a face of an OBJ file is an error with its line"
NAMES = "names of materials and their files may have spaces"
MODELS = "MTL's models of illumination become materials"
EMIT = "surfaces of an OBJ file emit, and are dissolved, as MTL says"
PICTURES = "pictures of MTL files are textures, placed as their options say"
LIT = "an OBJ file is lit by default, unless something else lights it"
APART = "work that runs apart gives its bytes or its fault, however it ends"

BEHIND = "colors behind an OBJ file's coordinates are those of its vertices, where no picture is"

FILTER = "a filter is set for all pictures but those whose pixels are to be seen, or are exact"

TIMES = "a picture of what a material reflects is times its colour, unless that is black or absent"
FILLED = "what MTL lets a file leave out of a color or an option is filled in"
GLOW = "a picture of what surfaces emit is placed as its options say"
FILES = "a line of several material files has all of them, each with pictures beside it"
NUMBERS = "a coordinate that is no number is an error at its line, of other numbers a warning"

MUTANTS = [
    Mutant("elements from the back are one off", "io/obj/reader.cpp",
           "return std::uint32_t(std::int64_t(count) + index);",
           "return std::uint32_t(std::int64_t(count) + index + 1);", "test_io", FACES),
    Mutant("polygons are fans", "io/obj/scene.cpp",
           "for (const auto& triangle : triangulate(positions)) add(triangle);",
           "for (std::uint32_t i = 2; i < corners.size(); ++i) add({0, i - 1, i});", "test_io", CORNERS),
    Mutant("a group goes on in the next object", "io/obj/reader.cpp",
           "self(reader).group_.clear();", "", "test_io",
           "a group ends where another object begins"),
    Mutant("faces of different materials are one shape", "io/obj/reader.cpp",
           "{object_, group_, material_, has_normals, has_uvs}, model_",
           "{object_, group_, 0, has_normals, has_uvs}, model_", "test_io", PARTS),
    Mutant("indices are not checked", "io/obj/reader.cpp",
           "if (index != no_element && index >= count)", "if (false && index >= count)", "test_io", WRONG),
    Mutant("lines are counted by line feeds alone", "io/obj/reader.cpp",
           "c == '\\n' || c == '\\r'", "c == '\\n'", "test_io",
           "a coordinate is the float that is nearest to what the file says"),
    Mutant("a file's name ends at a space", "io/obj/reader.cpp",
           "if (std::filesystem::is_regular_file(whole, error)) return {whole};", "", "test_io", NAMES),
    Mutant("all that is clear is glass", "io/obj/material.cpp",
           "return is_clear && m.ior > 1 &&", "return is_clear ||", "test_io", EMIT),
    Mutant("a specular colour is taken as it stands", "io/obj/material.cpp",
           "unit(2 * max_component(specular))", "unit(max_component(specular))", "test_io", MODELS),
    Mutant("what emits also waits for light", "io/mesh_scene.cpp",
           "loaded.wants_light = loaded.scene.lights.empty();", "loaded.wants_light = true;",
           "test_io", EMIT),
    Mutant("alpha of a shape is lost", "io/scene_part.cpp",
           ".alpha = part.alpha, ", "", "test_io", EMIT),
    Mutant("pictures are not moved", "io/obj/material.cpp",
           "how.origin_offset[1]", "0.0f", "test_io", PICTURES),
    Mutant("a mesh alone stays dark", "cli/render_scene.cpp",
           "arguments.default_light != DefaultLight::none || loaded.wants_light;",
           "arguments.default_light != DefaultLight::none;",
           "test_cli_engines", LIT),
    Mutant("the sky is there beside a picture of one", "cli/render_scene.cpp",
           "!= DefaultLight::always && is_lit(loaded.scene))", "!= DefaultLight::always && false)",
           "test_cli_engines", LIT),
    Mutant("mirrored nodes show their backs", "io/assimp/assimp_importer.cpp",
           "const bool mirrors = to_world.Determinant() < 0;", "const bool mirrors = false;", "test_io",
           "nodes, materials and pictures of an imported scene are where the file has them"),
    Mutant("nodes are where their parents are not", "io/assimp/assimp_importer.cpp",
           "above * node.mTransformation", "above", "test_io",
           "nodes, materials and pictures of an imported scene are where the file has them"),
    Mutant("what runs apart takes any memory", "io/assimp/apart.cpp",
           "if (bounds_memory) setrlimit(RLIMIT_DATA, &memory);", "", "test_io", APART),
    Mutant("what is killed apart is silence", "io/assimp/apart.cpp",
           "if (code > 128)", "if (code < 0)", "test_io", APART),
    Mutant("a damaged model is taken", "io/assimp/model_bytes.cpp",
           "if (!is_sound(faces, model))", "if (false)", "test_io",
           "a model comes back from its bytes, and from no others"),
    Mutant("the fourth texel of a triangle is the mean of the others", "io/vertex_colors.cpp",
           "value(b) + value(c) - value(a)", "(value(b) + value(c) + value(a)) * (1 / 3.0f)",
           "test_io", "colors of a PLY file's vertices are mixed as their triangles do, from any distance"),
    Mutant("colors of vertices are linear", "io/ply/reader.cpp",
           "value > 0 ? decode_srgb(std::min(value, 1.0f)) : 0", "value > 0 ? std::min(value, 1.0f) : 0",
           "test_io", "colors of a PLY file's vertices are mixed as their triangles do, from any distance"),
    Mutant("colors of words are bytes", "io/ply/reader.cpp",
           "? 255.0f : 65535.0f", "? 255.0f : 255.0f",
           "test_io", "colors of vertices are bytes, words or numbers up to 1, within which they are kept"),
    Mutant("vertices are colored by their numbers among those that faces use", "io/obj/scene.cpp",
           "model.colors[numbers.empty() ? i : numbers[i]]", "model.colors[i]",
           "test_io", BEHIND),
    Mutant("vertices before the first color have its", "io/obj/reader.cpp",
           "model_.colors.resize(model_.positions.size(), {1, 1, 1});",
           "model_.colors.resize(model_.positions.size(), color.value_or(Rgb{1, 1, 1}));",
           "test_io", BEHIND),
    Mutant("pixels of vertices' colors are chosen by chance", "core/texture.cpp",
           "(image.filter == TextureFilter::bilinear && !has_levels)", "false",
           "test_core", FILTER),
    Mutant("a picture says nothing of its colour", "io/obj/material.cpp",
           "const bool is_whole = is_black(color) || color == white;", "const bool is_whole = true;",
           "test_io",
           TIMES),
    Mutant("a black colour makes its picture black", "io/obj/material.cpp",
           "is_black(color) || color == white;", "color == white;", "test_io",
           TIMES),
    Mutant("what a colour lacks is 0", "io/obj/material_text.cpp",
           "if (words.size() == 1) words.resize(count, words[0]);", "", "test_io",
           FILLED),
    Mutant("what a scale lacks is 0", "io/obj/material_text.cpp", '{"-s", 3, "1"}', '{"-s", 3, "0"}',
           "test_io",
           FILLED),
    Mutant("an option that the library lacks stays", "io/obj/material_text.cpp",
           'if (word != "-cc") made +=', "made +=", "test_io",
           FILLED),
    Mutant("a halo is a number", "io/obj/material_text.cpp",
           'if (word != "-halo") words.push_back(word);', "words.push_back(word);", "test_io",
           FILLED),
    Mutant("a picture is brightened by half", "io/obj/material.cpp", "white * (2 * how.brightness)",
           "white * how.brightness", "test_io", "a picture is brightened as its option says"),
    Mutant("a picture of a lamp lies over all of it", "io/obj/material.cpp", "glow.uv = map.uv;", "",
           "test_io",
           GLOW),
    Mutant("what other pictures see is moved with a lamp's", "io/obj/material.cpp",
           "surface.glow.may_move_uvs &=", "std::ignore =", "test_io",
           GLOW),
    Mutant("pictures lie beside the last material file", "io/obj/material.cpp",
           "file_ = model_.material_files[std::size_t(number)];", "file_ = model_.material_files.back();",
           "test_io", FILES),
    Mutant("a line of material files has the first", "io/obj/reader.cpp",
           "for (const std::string& file : paths()) add(file, *materials, *numbers);",
           "add(paths()[0], *materials, *numbers);",
           "test_io", FILES),
    Mutant("comments go on, too", "io/obj/text.cpp",
           "if (is_last && text[line_begin(text, at)] != '#') return at;", "if (is_last) return at;",
           "test_io",
           "a backslash continues a line, in comments it does not, and places stay right"),
    Mutant("what is no number is 0", "io/obj/reader.cpp", "if (numbers.count < 3 && !numbers.end.empty())",
           "if (false)", "test_io",
           NUMBERS),
    Mutant("pictures of Assimp's models are one texel", "io/assimp/model_bytes.cpp", "visit(how->scale);", "",
           "test_io", "nodes, materials and pictures of an imported scene are where the file has them"),
]
