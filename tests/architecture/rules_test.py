#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Every rule of rules.py can fail: each test writes a small tree that keeps all rules, plants one violation
in it and expects that finding, and no other."""
import tempfile
import unittest
from pathlib import Path

import rules

CPP = "// SPDX-License-Identifier: Apache-2.0\n"
HEADER = CPP + "#pragma once\n"
PRIVATE = CPP + "// Private: a test of this tree.\n#pragma once\n"
SHELL = "# SPDX-License-Identifier: Apache-2.0\n"

CLEAN = {
    "core/CMakeLists.txt": SHELL + "twinray_library(core\n  vec.cpp)\n",
    "core/vec.h": HEADER + "#include <cmath>\n",
    "core/vec.cpp": CPP + '#include "core/lanes.h"\n#include "core/vec.h"\n// Not sin(x), nor a std::cout.\n',
    "core/lanes.h": PRIVATE,
    "accel/bvh.h": HEADER + '#include "core/vec.h"\n',
    "cmake/Install.cmake": SHELL + "set(private_headers\n  core/lanes.h)\n",
    "README.md": "# A title\n",
}


class Rules(unittest.TestCase):
    def findings(self, planted):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in {**CLEAN, **planted}.items():
                path = Path(folder, name)
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text, encoding="utf-8")
            return rules.findings(rules.read_tree(Path(folder)))

    def expect(self, planted, *expected):
        found = self.findings(planted)
        self.assertEqual(len(found), len(expected), found)
        for finding, part in zip(found, expected):
            self.assertIn(part, finding)

    def test_a_clean_tree_has_no_findings(self):
        self.expect({})

    def test_a_folder_includes_only_what_lies_below_it(self):
        self.expect({"core/low.h": HEADER + '#include "accel/bvh.h"\n'},
                    "core/low.h:3: core/ must not include")
        self.expect({"io/file.h": HEADER + '#include "accel/bvh.h"\n'}, "io/file.h:3: io/ must not include")
        self.expect({"cli/x.h": HEADER, "bench/y.h": HEADER + '#include "cli/x.h"\n'},
                    "bench/ must not include")
        self.expect({"tests/t.h": HEADER + '#include "accel/bvh.h"\n'})

    def test_includes_are_written_from_the_root(self):
        self.expect({"core/a.h": HEADER + '#include "../core/vec.h"\n'},
                    "core/ must not include", "is not a file of the tree")
        self.expect({"tests/b.h": HEADER + '#include "vec.h"\n'}, "is not a file of the tree")
        self.expect({"tests/d.h": HEADER + '#include "d.inc"\n'}, "is not a file of the tree")
        self.expect({"tests/d.h": HEADER + '#include "d.inc"\n', "tests/d.inc": "1, 2\n"})
        self.expect({"tests/c.h": HEADER + "#include <core/vec.h>\n"}, "write it in quotes")

    def test_an_outside_library_has_one_door(self):
        for header in ("embree3/rtcore.h", "hwy/highway.h", "immintrin.h", "tbb/parallel_for.h", "tinyxml2.h",
                       "tiny_gltf.h", "draco/mesh/mesh.h", "meshoptimizer.h",
                       "OpenImageIO/imageio.h", "CLI/CLI.hpp", "nlohmann/json.hpp", "catch2/catch.hpp",
                       "benchmark/benchmark.h"):
            self.expect({"tests/far.h": HEADER + f"#include <{header}>\n"}, "its only door")
        listed = CLEAN["cmake/Install.cmake"].replace(")", "\n  accel/embree/leaf.h)")
        self.expect({"accel/embree/leaf.h": PRIVATE + "#include <embree3/rtcore.h>\n",
                     "cmake/Install.cmake": listed})

    def test_private_headers_stay_in_core_and_accel(self):
        self.expect({"cli/a.h": HEADER + '#include "core/lanes.h"\n'}, "private to core/, accel/ and")
        self.expect({"accel/a.h": HEADER + '#include "core/lanes.h"\n'},
                    "a public header must not include it")
        self.expect({"tests/a.h": HEADER + '#include "core/lanes.h"\n'})

    def test_private_headers_are_not_installed(self):
        self.expect({"core/box.h": PRIVATE}, "core/box.h:1: says that it is private")
        self.expect({"core/lanes.h": HEADER}, "core/lanes.h is listed as private")

    def test_public_headers_need_the_standard_library_alone(self):
        self.expect({"core/text.h": HEADER + "#include <fmt/format.h>\n"}, "must not include <fmt/format.h>")
        self.expect({"core/text.h": HEADER + "#include <unistd.h>\n"}, "must not include <unistd.h>")

    def test_headers_have_a_guard(self):
        self.expect({"core/a.h": CPP + "struct A {};\n"}, "#pragma once")
        self.expect({"core/a-inl.h": HEADER}, "HWY_TARGET_TOGGLE")

    def test_files_name_their_licence(self):
        self.expect({"core/a.h": "#pragma once\n\n#pragma once\n"}, "the first line must be // SPDX")
        self.expect({"run": "#!/bin/sh\n"}, "the first line must be # SPDX")
        self.expect({"tests/a.py": '"""Nothing."""\n'}, "the first line must be # SPDX")

    def test_files_and_lines_stay_short(self):
        self.expect({"core/a.h": HEADER + "\n" * (rules.MAX_LINES - 2)})
        self.expect({"core/a.h": HEADER + "\n" * (rules.MAX_LINES - 1)}, "451 lines")
        self.expect({"core/a.h": HEADER + "//" + "x" * 108 + "\n"})
        self.expect({"core/a.h": HEADER + "//" + "x" * 109 + "\n"}, "core/a.h:3: 111 columns")

    def test_libm_stays_out_of_what_reaches_a_pixel(self):
        for call in ("std::sin(x)", "cosf(x)", "std::atan2(y, x)", "::exp(x)", "log1p(x)", "std::powf(x, y)",
                     "hypot(x, y)", "std::exp2 (x)"):
            self.expect({"integrators/a.h": HEADER + f"float f = {call};\n"}, "differs between machines")
        for call in ("std::sqrt(x)", "std::fma(x, y, z)", "pow_of(x, y)", "sincos_turns(x)", "curve.log(x)",
                     "expect(x)", "std::floor(x)"):
            self.expect({"integrators/a.h": HEADER + f"inline float f = {call};\n"})
        self.expect({"tests/a.h": HEADER + "inline float f = std::sin(x);\n"})

    def test_random_numbers_come_from_the_sampler(self):
        for call in ("std::random_device d;", "std::uniform_int_distribution<int> d;", "int x = rand();"):
            self.expect({"tests/a.h": HEADER + call + "\n"}, "gives other numbers elsewhere")

    def test_libraries_do_not_talk(self):
        for call in ("std::cout << 1;", 'std::printf("");', 'fmt::print("");', "std::exit(1);", "abort();"):
            self.expect({"io/a.h": HEADER + call + "\n"}, "a library throws Error")
            self.expect({"cli/a.h": HEADER + call + "\n"})

    def test_libraries_are_loaded_by_their_doors(self):
        load = HEADER + 'void* const library = dlopen("library.so", 0);\n'
        self.expect({"io/a.h": load}, "libraries are loaded by")
        self.expect({"tests/a.h": load})

    def test_nothing_is_left_open(self):
        for word in ("TO" "DO", "FIX" "ME", "X" "XX", "HA" "CK"):
            self.expect({"core/a.h": HEADER + f"// {word}: later\n"}, "core/a.h:3: " + word)
            self.expect({"README.md": f"{word}\n"}, word)

    def test_no_path_of_one_machine_is_written_down(self):
        self.expect({"README.md": "cd /ho" "me/me/twinray\n"}, "path of one machine")
        self.expect({"README.md": "cd ${top}/wo" "rk/twinray, or https://example.org/home\n"})

    def test_builds_are_portable(self):
        flag = "-march=" + "native"
        self.expect({"cmake/Settings.cmake": SHELL + f"add_compile_options({flag})\n"}, flag)
        self.expect({"tests/consumer/CMakeLists.txt": SHELL + f"add_compile_options({flag})\n"})

    def test_every_test_counts(self):
        for mark in ("[!mayfail]", "[!shouldfail]", "[.]", "[.slow]"):
            self.expect({"tests/a.h": HEADER + f'TEST_CASE("a", "{mark}")\n'}, "a test that may not count")
        self.expect({"tests/a.h": HEADER + 'SKIP("no");\n'}, "a test that may not count")

    def test_names_reach_ctest_whole(self):
        for name in ("x in [0, 1)", "x; y", "a\\\\b", "-x is y"):
            self.expect({"tests/a.h": HEADER + f'TEST_CASE("{name}", "[tag]")\n'},
                        "a test's name must not hold")
        self.expect({"tests/a.h": HEADER + 'TEST_CASE("x, from 0 to 1", "[tag]")\n'})

    def test_every_source_file_is_compiled(self):
        self.expect({"core/lost.cpp": CPP}, "core/lost.cpp:1: no CMakeLists.txt lists this file")
        self.expect({"core/ec.cpp": CPP}, "core/ec.cpp:1: no CMakeLists.txt lists this file")
        self.expect({"tests/x/CMakeLists.txt": SHELL + "twinray_test(x SOURCES a_test.cpp ../y/b.cpp)\n",
                     "tests/x/a_test.cpp": CPP, "tests/y/b.cpp": CPP})

    def test_instruction_sets_are_left_out_before_highway(self):
        tree = {"accel/CMakeLists.txt": SHELL + "twinray_library(accel\n  lanes.cpp)\n",
                "core/instruction_sets.h": HEADER}
        sets, each = '#include "core/instruction_sets.h"\n', "#include <hwy/foreach_target.h>\n"
        self.expect({**tree, "accel/lanes.cpp": CPP + sets + each})
        for text in (each, each + sets):
            self.expect({**tree, "accel/lanes.cpp": CPP + text}, "include core/instruction_sets.h first")

    def test_nothing_is_included_in_a_circle(self):
        listed = SHELL + "twinray_library(accel\n  a.cpp b.cpp x/c.cpp y/d.cpp)\n"
        self.expect({"accel/CMakeLists.txt": listed, "accel/a.h": HEADER, "accel/b.h": HEADER,
                     "accel/a.cpp": CPP + '#include "accel/b.h"\n',
                     "accel/b.cpp": CPP + '#include "accel/a.h"\n'},
                    "accel/a:1: includes in a circle: accel/a -> accel/b -> accel/a")
        # No file does, but the folders do.
        self.expect({"accel/CMakeLists.txt": listed, "accel/x/c.h": HEADER, "accel/y/d.h": HEADER,
                     "accel/x/c.cpp": CPP + '#include "accel/y/d.h"\n',
                     "accel/y/e.h": HEADER + '#include "accel/x/c.h"\n'},
                    "accel/x:1: includes in a circle: accel/x -> accel/y -> accel/x")
        # A header, its source and the file with its lanes are one.
        self.expect({"accel/CMakeLists.txt": listed, "accel/a.h": HEADER,
                     "accel/a.cpp": CPP + '#include "accel/a.h"\n'})

    def test_a_type_is_defined_once(self):
        first = HEADER + "namespace twinray {\nstruct Tile {\n};\n}  // namespace twinray\n"
        derived = first.replace("struct Tile {", "class Tile final : public Other {")
        self.expect({"accel/a.h": first, "bench/b.h": derived},
                    "bench/b.h:4: accel/a.h defines another twinray::Tile")
        for other in (first.replace("twinray", "other"), first.replace("Tile {\n}", "Tile"),
                      first.replace("Tile {", "Tile::Part {"), first.replace("Tile {", "Tile<int> {"),
                      first.replace("struct", "namespace {\nstruct").replace("};", "};\n}  // namespace")):
            self.expect({"accel/a.h": first, "bench/b.h": other})


if __name__ == "__main__":
    unittest.main()
