# SPDX-License-Identifier: Apache-2.0
"""Defects of the eight-wide tree in little memory: its nodes, its leaves, its parts."""
from mutant import Mutant

TARGET = "test_accel"
ENGINES = "test_accel_engines"

OUTWARD = "a grid reaches over all children, and the nearest planes outside of each are found"
ROOMS = "a floor and a ceiling become thicker on the outside alone"
HOLDS = "every compact tree holds all primitives, in one part and in many"
PACKED = "blocks of random triangles that share corners come back with their bits"
BATCHES = "the fast kernels take the steps of the scalar traversal in batches"
PARTS = "parts are a sixteenth of all primitives at most, and lie no deeper than a stack has room for"
AGREE = "engines agree on triangle soups and spheres"

MUTANTS = [
    Mutant("a lower plane is rounded up", "accel/compact/grid.cpp",
           "  while (plane(steps) > at) --steps;\n", "",
           TARGET, "a plane is the nearest one to itself, and not to the floats beside it"),
    Mutant("an upper plane is rounded down", "accel/compact/grid.cpp",
           "  while (plane(steps) < at) ++steps;\n", "",
           TARGET, OUTWARD),
    Mutant("a grid may end before the last child does", "accel/compact/grid.cpp",
           "&& grid.plane(Grid::most_steps) >= all.upper", "",
           TARGET, OUTWARD),
    Mutant("steps are twice as long as they must be", "accel/compact/grid.cpp",
           "float(length(all) / Grid::most_steps)", "float(2 * length(all) / Grid::most_steps)",
           TARGET, "without flat children a grid is the finest one, from end to end"),
    Mutant("floors become thicker on the inside", "accel/compact/grid.cpp",
           "std::min(first_end, child.upper)", "std::min(first_end, child.lower)",
           TARGET, ROOMS),
    Mutant("ceilings become thicker on the inside", "accel/compact/grid.cpp",
           "std::max(last_begin, child.lower)", "std::max(last_begin, child.upper)",
           TARGET, ROOMS),
    Mutant("grids give up where a plane is rounded inward", "accel/compact/grid.cpp",
           "lower_moves + upper_moves < 8", "lower_moves + upper_moves < 1",
           TARGET, ROOMS),
    Mutant("fitted steps may be too small for a normal float", "accel/compact/grid.cpp",
           "finest.step >= min_fitted_step", "true",
           TARGET, OUTWARD),
    Mutant("a grid meets flat children of either half with either end", "accel/compact/grid.cpp",
           "first_end < middle ?", "first_end < infinity ?",
           TARGET, "a single flat child becomes thicker on the side of the nearer end, wherever it lies"),
    Mutant("what equal nodes do not use differs", "accel/compact/node.h",
           "unused[5] = {};", "unused[5];",
           TARGET, "the compact tree has the same bits on any number of threads"),
    Mutant("steps of fitted grids are longer than they must be", "accel/compact/grid.cpp",
           "(Grid::most_steps - 2)", "(Grid::most_steps / 2)",
           TARGET, ROOMS),
    Mutant("wide ids are packed as narrow ones", "accel/compact/packed_block.cpp",
           "    is_wide |= primitives.is_wide() || block.ids[0].mesh > UINT16_MAX;\n", "",
           TARGET, "ids that lie far apart, and of several meshes, are packed whole"),
    Mutant("nine vertices are packed into eight places", "accel/compact/packed_block.cpp",
           "if (place == packed::max_vertices) return false;",
           "if (place == packed::max_vertices) return true;",
           TARGET, PACKED),
    Mutant("the least index is forgotten where leaves are unpacked in lanes", "accel/compact/unpack-inl.h",
           "{mesh, least + words_", "{mesh, words_",
           ENGINES, AGREE),
    Mutant("wide axes are unpacked as narrow ones", "accel/compact/unpack-inl.h",
           "0u - (head_.wide_axes >> axis & 1)", "0u",
           ENGINES, AGREE),
    Mutant("the block of the nearest hit is written over", "accel/compact/unpack-inl.h",
           "free_ ^= best.block == &places_[free_].block;", "free_ ^= 0 * (best.block == nullptr);",
           ENGINES, AGREE),
    Mutant("parts may lie as deep as splits like", "accel/compact/partition.cpp",
           "is_free ? divide(", "true ? divide(",
           TARGET, PARTS),
    Mutant("walls share parts with what is in the room", "accel/compact/partition.cpp",
           "std::size_t(large) > most) return", "large > 0) return",
           TARGET, "a tree that was built in parts takes few more steps than one that was built as a whole"),
    Mutant("the triangles of a wall are parts of their own", "accel/compact/partition.cpp",
           "if (is_one_box(primitives) &&", "if (primitives.size() == 1 &&",
           TARGET, "walls of a room are parts of their own, each with the triangles of its rectangle"),
    Mutant("parts are not divided further to fill a node", "accel/compact/partition.cpp",
           "return !is_leaf && piece.depth < most_depth ?", "return piece.count() > part_size_ ?",
           TARGET, "nodes above the parts are full, and few primitives need none"),
    Mutant("the tree above the parts names their numbers", "accel/compact/build.cpp",
           "child = roots[child.index()];", "child = roots[0];",
           TARGET, HOLDS),
]
