# SPDX-License-Identifier: Apache-2.0
"""What is wrong with glTF files, and who is told (io/gltf/)."""
from mutant import Mutant

GLTF = "test_io_gltf"
UNREAD = "gltf: an extension that is not read is named where it stands, unless it is declared"
MISPLACED = "gltf: an extension where it means nothing is named, and its values are not read"
LIKENESS = "gltf: a long beginning or end that names of extensions share is no likeness"
TARGETS = "gltf: there are as many weights as morph targets, and as many of these in all primitives"
WEIGHTS = "gltf: weights below 0, or that do not add up to 1, are counted, and what is done is said"
DAMAGED = "gltf: a binary file that is damaged says where"
MISSING = "gltf: coordinates that a mesh does not have are called that, whatever others it has"

MUTANTS = [
    Mutant("extensions that are declared are told twice", "io/gltf/schema.cpp",
           "if (!is_declared(name) && !is_silent_extension(name))", "if (!is_silent_extension(name))",
           GLTF, UNREAD),
    Mutant("an extension means something wherever it stands", "io/gltf/schema.cpp",
           "!may_have_extension(kind, name)", "false", GLTF, MISPLACED),
    Mutant("extensions of one beginning are alike", "io/gltf/rules.cpp",
           'nearest_name(own, {&its, 1}).empty() ? "" : nearest', "nearest", GLTF, LIKENESS),
    Mutant("primitives may have different numbers of morph targets", "io/gltf/schema.cpp",
           "if (targets_of(primitives[i]) != targets)", "if (false)", GLTF, TARGETS),
    Mutant("a set of joints may be without the one before it", "io/gltf/attributes.cpp",
           'number.size() == 1 && number != "0"', "false", GLTF,
           "gltf: joints and weights come together, in sets from 0 on"),
    Mutant("any numbers are normals", "io/gltf/accessor.cpp",
           "is_quantized && has_word(format.quantized, own)", "is_quantized", GLTF,
           "gltf: attributes have the numbers that the format says, and what quantization adds"),
    Mutant("colors may be no numbers", "io/gltf/accessor.cpp",
           "return !std::isfinite(number);", "return number == 1e30f;", GLTF,
           "gltf: numbers that must be finite and are not are named with their element"),
    Mutant("numbers begin anywhere", "io/gltf/accessor.cpp",
           "begin % extent.component_bytes != 0", "false", GLTF,
           "gltf: numbers begin at multiples of their size"),
    Mutant("weights add up to anything", "io/gltf/deform.cpp",
           "least < 0 || !(std::abs(sum - 1) <= rounding)", "least < 0", GLTF, WEIGHTS),
    Mutant("a strip begins again in silence", "io/gltf/primitive.cpp",
           "if (found != corners.end())", "if (false)", GLTF,
           "gltf: the largest number of its type is no index"),
    Mutant("a chunk's header may be cut", "io/gltf/container.cpp",
           "if (rest >= 4)", "if (false)", GLTF, DAMAGED),
    Mutant("an unlit surface of specular and glossiness is black", "io/gltf/material.cpp",
           "(is_unlit ? 1 : 1 - reflected)", "(1 - reflected)", GLTF,
           "gltf: an unlit surface of specular and glossiness shows its diffuse color"),
    Mutant("coordinates that are missing are others", "io/gltf/shapes.cpp",
           "if (!primitive.uvs.contains(each))", "if (false)", "test_io", MISSING),
]
