# SPDX-License-Identifier: Apache-2.0
"""Defects of the STL reader, and of what an OBJ file says beside its triangles."""
from mutant import Mutant

CUT_OFF = "an STL file that is cut off is not taken for a whole one"
SOLIDS = "solids of an ASCII STL file are objects, words in any letters and on any lines"
BINARY = "triangles of a binary STL file are read, whatever its title says"
STATEMENTS = "a statement that OBJ does not have is named, and what is left out is counted"

MUTANTS = [
    Mutant("words of STL are small letters alone", "io/stl/ascii.cpp",
           "(word_ == keyword || lower_case(std::string(word_)) == keyword)", "word_ == keyword",
           "test_io", SOLIDS),
    Mutant("a text that ends between facets is whole", "io/stl/ascii.cpp",
           "if (is_in_solid_)", "if (false)", "test_io", CUT_OFF),
    Mutant("a title decides what an STL file is", "io/stl/reader.cpp",
           "head.find('\\0') == head.npos", "true", "test_io", BINARY),
    Mutant("a binary file has one triangle less than its head says", "io/stl/reader.cpp",
           "if (count > whole)", "if (count > whole + 2)", "test_io", CUT_OFF),
    Mutant("the normal of a binary file is a corner", "io/stl/reader.cpp",
           "at + normal_bytes, sizeof corners", "at, sizeof corners", "test_io", BINARY),
    Mutant("a coordinate that is no number passes behind the first", "io/stl/reader.cpp",
           "!is_finite(corner) || max_abs(corner) > max_coordinate", "!(max_abs(corner) <= max_coordinate)",
           "test_io", "what is wrong with an STL file is an error that says where"),
    Mutant("attributes of triangles are not counted", "io/stl/reader.cpp",
           "marked += mark != 0", "marked += 0", "test_io", BINARY),
    Mutant("the place of an index is the last face's", "io/obj/reader.cpp",
           "if (std::size_t(place) >= need.count)", "if (std::size_t(place) + 1 >= need.count)",
           "test_io", "what is wrong with a face of an OBJ file is an error with its line"),
    Mutant("statements of OBJ that nobody knows are silent", "io/obj/statements.cpp",
           "    else\n      warnings.add", "    else if (false)\n      warnings.add", "test_io", STATEMENTS),
    Mutant("normals of MTL lean as far as their picture says", "io/obj/material.cpp",
           "how.bump_multiplier,", "1,", "test_io", "the normals of a map lean as far as its option says"),
    Mutant("a normal map of Assimp is flat", "io/assimp/assimp_importer.cpp",
           "how->contrast = how->bump_multiplier = 1", "how->contrast = 1", "test_io",
           "the normal map of an imported scene leans as its picture says"),
]
