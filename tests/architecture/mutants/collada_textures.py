# SPDX-License-Identifier: Apache-2.0
"""Textures and instances of COLLADA files."""
from mutant import Mutant

IO = "test_io"
SETS = "bind_vertex_input says which set of texture coordinates a texture means"
FOUND = "a picture is found by its URI or, where exporters wrote another system's path, beside the file"
SAMPLER = "a sampler says how a picture goes on beside itself, and a Maya technique where it lies"
HOLES = "a texture of the transparency cuts holes, in each opaque mode"
BINDINGS = "instances have one material, and each other binding is a prototype of its own"

MUTANTS = [
    Mutant("any name of texture coordinates is bound", "io/collada/material.cpp",
           'bind.attribute("semantic") == texcoord', "true",
           IO, SETS),
    Mutant("texture coordinates are always the first ones", "io/collada/shapes.cpp",
           "binding.material.is_textured && is_there ? wanted : part.uv_set", "part.uv_set",
           IO, SETS),
    Mutant("a mirrored picture lies as one that is not", "io/collada/texture.cpp",
           "halved(sampling.uv, sampling.mirrors_u, sampling.mirrors_v)", "sampling.uv",
           IO, SAMPLER),
    Mutant("a border repeats", "io/collada/texture.cpp",
           'return word == "BORDER" || word == "NONE" ?', "return false ?",
           IO, SAMPLER),
    Mutant("a picture is sought where its path says alone", "io/picture_path.cpp",
           "std::filesystem::exists(beside, error) ? beside : path", "false ? beside : path",
           IO, FOUND),
    Mutant("zero is there, one is not", "io/collada/material.cpp",
           'mode.ends_with("ONE") ? 0.0f : 1.0f', 'mode.ends_with("ONE") ? 1.0f : 0.0f',
           IO, HOLES),
    Mutant("the factor of a transparency does not count", "io/collada/material.cpp",
           "std::fabs(at_0 - amount)", "std::fabs(at_0 - 1)",
           IO, HOLES),
    Mutant("a picture without holes makes its surface ask for them", "io/collada/material.cpp",
           "if (at_1 == 1 && textures_.is_one(texture)) return;", "",
           IO, "a picture without holes leaves its surface opaque"),
    Mutant("a picture that is missing shines magenta", "io/collada/material.cpp",
           "if (texture == no_texture || textures_.is_faulty(texture)) return;\n  const auto& picture",
           "if (texture == no_texture) return;\n  const auto& picture",
           IO, "an emission texture is the picture of a light"),
    Mutant("textures are rendered by CS184's rules, too", "io/collada/material.cpp",
           "use->from_file.empty() || is_cs184)", "use->from_file.empty())",
           IO, "by CS184's rules a textured surface is grey"),
    Mutant("an archive's pictures may lie anywhere", "io/collada/archive.cpp",
           "return decode_texture(archive.read(entry_of(wanted)), wanted, meaning, how);",
           "return load_texture(wanted, meaning, how);",
           IO, "pictures of an archive are its own"),
    Mutant("instances of one geometry share a prototype, whatever they wear", "io/collada/shapes.cpp",
           "{shown.bindings[i].material.index, uv_set_of", "{0, uv_set_of",
           IO, BINDINGS),
    Mutant("what emits is stored once, in a COLLADA file", "io/collada/shapes.cpp",
           "if (emits(shown.bindings[i].material.glow)) add_part", "if (false) add_part",
           IO, "a geometry that nodes share is stored once, but for what emits"),
    Mutant("instances are made by CS184's rules, too", "io/collada/shapes.cpp",
           "!is_cs184() && !shown.shape->parts.empty()", "!shown.shape->parts.empty()",
           IO, "by CS184's rules everything is a copy"),
    Mutant("holes of a missing picture are everywhere", "io/collada/material.cpp",
           "if (texture == no_texture || textures_.is_faulty(texture)) return;\n  const float at_0",
           "if (texture == no_texture) return;\n  const float at_0",
           IO, "holes of a picture that cannot be read are none"),
    Mutant("an effect has one picture, whoever instances it", "io/collada/texture.cpp",
           "use.sampler, path, int(meaning.role)", 'use.sampler, "", int(meaning.role)',
           IO, "materials that instance one effect may set its picture"),
    Mutant("any path is one within the archive", "io/collada/archive.cpp",
           "if (wanted.rfind(inside, 0) != 0)", "if (false)",
           IO, "pictures of an archive are its own"),
]
