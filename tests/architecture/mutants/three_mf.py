# SPDX-License-Identifier: Apache-2.0
"""Defects of the 3MF reader."""
from mutant import Mutant

SHOWN = "a 3MF package shows its items where they stand, z up"
PARTS = "objects of a 3MF package may lie in other parts of it"
STORED = "what a 3MF package shows often is stored once where that is asked for"
WORN = "triangles of 3MF wear materials and colours: their own, their object's, or that of what holds it"
WRONG = "a 3MF package that is wrong is refused where it is wrong"
MULTIPLIED = "a 3MF package whose objects multiply is refused before they are all made"
NAMED = "what 3MF has and is not rendered is named"
PIECES = "triangles of a 3MF mesh that look alike are a piece, with the vertices that they use"
CORNERS = "corners of a 3MF triangle that differ in colour have vertices of their own"
RELATIONS = "a 3MF package begins where its relations say, whatever the case of names"
SCENE = "io/three_mf/scene.cpp"

MUTANTS = [
    Mutant("a 3MF package lies on its back", SCENE, "show(item, z_up, {})", "show(item, {}, {})", "test_io",
           SHOWN),
    Mutant("rows of a 3MF transform are columns", SCENE, "numbers[3 * column + row]",
           "numbers[4 * row + column]", "test_io", SHOWN),
    Mutant("a 3MF component moves before what holds it", SCENE, "around * transform_of(named_by)",
           "transform_of(named_by) * around", "test_io", SHOWN),
    Mutant("the path of a 3MF item is left out", SCENE, 'local_attribute(named_by, "path")',
           'local_attribute(named_by, "none")', "test_io", PARTS),
    Mutant("instances of 3MF all stand where the first one does", SCENE,
           "instances_.push_back({prototype, to_world})", "instances_.push_back({prototype, {}})", "test_io",
           STORED),
    Mutant("a 3MF object forgets what holds it wears", SCENE,
           'if (!object.attribute("pid")) return inherited;',
           'if (!object.attribute("pid")) return std::nullopt;', "test_io", WORN),
    Mutant("a number alone of a 3MF triangle is of the first group", "io/three_mf/mesh.cpp",
           ": *own.group;", ": 0;", "test_io", WORN),
    Mutant("an inch of 3MF is four", SCENE, '{"inch", 0.0254}', '{"inch", 0.1016}', "test_io",
           "units of 3MF packages are told in metres, and coordinates stay in them"),
    Mutant("a 3MF object may contain itself", SCENE, "if (std::find(around_.begin(), around_.end(), object)",
           "if (false && std::find(around_.begin(), around_.end(), object)", "test_io", WRONG),
    Mutant("objects of 3MF may multiply", SCENE, "most_shown = 1000000", "most_shown = 100000000", "test_io",
           MULTIPLIED),
    Mutant("a required extension of 3MF is taken for known", SCENE,
           'if (space.find("/production/") != std::string::npos',
           'if (!space.empty() || space.find("/production/") != std::string::npos', "test_io", NAMED),
    Mutant("vertices of 3MF pieces are all of the mesh", "io/three_mf/mesh.cpp",
           "if (!piece.mesh.positions.empty()) continue;", "piece.mesh.positions = positions_; continue;",
           "test_io", PIECES),
    Mutant("the third corner of a 3MF triangle has the colour of the second", "io/three_mf/mesh.cpp",
           'triangle.index_attribute("p3", p1)', 'triangle.index_attribute("p2", p1)', "test_io", CORNERS),
    Mutant("colours of 3MF with alpha are shifted", "io/three_mf/properties.cpp",
           "if (text.size() == 9) bits >>= 8;", "", "test_io",
           "materials and colours of 3MF are decoded from sRGB, without their alpha"),
    Mutant("names of parts of 3MF must be in the archive's case", "io/three_mf/package.cpp",
           "entries_.emplace(lower_case(entry), entry)", "entries_.emplace(entry, entry)", "test_io",
           RELATIONS),
]
