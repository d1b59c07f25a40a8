# SPDX-License-Identifier: Apache-2.0
"""Defects in the readers of pbrt scenes, PLY meshes and words that are numbers."""
from mutant import Mutant

MUTANTS = [
    Mutant("a mirroring transform turns a mesh inside out", "io/pbrt_shape.cpp",
           "if ((to_world.determinant() < 0) != is_reversed) {", "if (is_reversed) {",
           "test_io", "the front of a triangle is pbrt's outside, through every turn and mirror"),
    Mutant("a reversed shape keeps its normals", "io/pbrt_shape.cpp",
           "((mirrors != is_reversed ? -1 : 1) / size)", "((mirrors ? -1 : 1) / size)",
           "test_io", "shading normals say which side is outside, whatever the winding"),
    Mutant("a roughness is alpha, remapped or not", "io/pbrt_material.cpp",
           "is_remapped ? std::sqrt(r) : r", "r",
           "test_io", "a roughness is the square of alpha, unless it is not remapped"),
    Mutant("a lamp of two sides has the power of one", "io/pbrt_light.cpp",
           "(is_two_sided ? 2 : 1) * pi * area", "pi * area",
           "test_io", "an area light of a power has it, over the area and both sides"),
    Mutant("the field of view is the whole angle to either side", "io/pbrt_camera.cpp",
           "tan_radians(double(camera.fov_degrees) * radians_per_degree / 2)",
           "tan_radians(double(camera.fov_degrees) * radians_per_degree)",
           "test_io", "LookAt and a perspective camera give pbrt's picture: left-handed, the shorter side "
           "has the fov"),
    Mutant("the film's speed does not count", "io/pbrt_scene.cpp",
           "builder_.finish(camera_.exposure_seconds * film_.iso / 100)",
           "builder_.finish(camera_.exposure_seconds)",
           "test_io", "the exposure of film and shutter multiplies all light"),
    Mutant("black bodies shine by the fourth power of the wavelength", "io/pbrt_spectrum.cpp",
           "return 1 / (x * x * x * x * x *", "return 1 / (x * x * x * x *",
           "test_io", "a black body's color lies where the CIE has it"),
    Mutant("an index of a PLY face may be one too large", "io/ply_reader.cpp",
           "numbers_.whole(list.type, vertices - 1, \"the index\")",
           "numbers_.whole(list.type, vertices, \"the index\")",
           "test_io", "what is wrong with a PLY file is named, with its place"),
    Mutant("a number above the largest is 0", "io/decimal.h",
           "is_tiny(word) ? DecimalFault::none : DecimalFault::too_large", "DecimalFault::none",
           "test_io", "each broken file gives exactly its message"),
    Mutant("a texture counts its parts once, however often they are named", "core/texture.cpp",
           "return 1 + of(texture.first) + of(texture.second);\n  }\n  std::uint64_t operator()"
           "(const MixTexture",
           "return 1 + std::max(of(texture.first), of(texture.second));\n  }\n  std::uint64_t operator()"
           "(const MixTexture",
           "test_core", "a texture of which few statements make very many is an error"),
]
