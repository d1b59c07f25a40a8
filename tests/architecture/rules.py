#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks the house's rules on every source file: rules.py ROOT prints what breaks one, and then exits with 1.

A rule is a function of the tree (file name -> text) that yields findings: (file, line, message).
rules_test.py plants a violation of each rule and sees it found.
"""
import re
import sys
from os.path import normpath
from pathlib import Path

# Folder -> the folders whose headers it may include. Tests may include anything.
MAY_INCLUDE = {
    "core": {"core"},
    "accel": {"accel", "core"},
    "integrators": {"integrators", "accel", "core"},
    "io": {"io", "core"},
    "check": {"check", "integrators", "accel", "core"},
    "cli": {"cli", "io", "check", "integrators", "accel", "core"},
    "bench": {"bench", "io", "check", "integrators", "accel", "core"},
}
LIBRARIES = ("core", "accel", "integrators", "check", "io")
SOURCE_FOLDERS = (*MAY_INCLUDE, "tests")

# Outside library: its headers, and the one file or folder that may include them.
DOORS = {
    "Embree": (r"embree[34]?/", r"accel/embree/"),
    "Highway and intrinsics": (r"hwy/|\w+intrin\.h",  # denormals: FTZ and DAZ
                               r"accel/|core/(denormals|instruction_sets|map_points)\.cpp|integrators/wave/|"
                               r"tests/core/instruction_sets_test\.cpp"),
    "Boost": (r"boost/", r"check/(exact\.h|welch\.cpp)"),
    "oneTBB": (r"tbb/|oneapi/", r"core/parallel\.cpp"),
    "OpenEXR": (r"Imf\w+\.h|Iex\.h|half\.h|OpenEXR/|Imath/", r"io/picture/exr_\w+\.(h|cpp)"),
    "OpenImageIO": (r"OpenImageIO/", r"io/picture/openimageio_(codec|view)\.cpp"),
    "libpng": (r"png\.h", r"io/picture/png(_reader)?\.cpp|tests/io/picture/png_reader_test\.cpp"),
    "libjpeg": (r"jpeglib\.h|jerror\.h",
                r"io/picture/jpeg_reader\.cpp|tests/io/picture/jpeg_reader_test\.cpp"),
    "zlib": (r"zlib\.h", r"io/gzip\.cpp"),
    "Blosc": (r"blosc\.h", r"io/nanovdb/blosc\.cpp"),
    "NanoVDB": (r"nanovdb/", r"io/nanovdb/grid\.cpp|tests/io/nanovdb/nvdb_bytes\.cpp"),
    "Zstandard": (r"zstd\.h", r"io/film/zstd\.cpp"),
    "xxHash": (r"xxhash\.h", r"io/film/content_hash\.cpp"),
    "libzip": (r"zip\.h", r"io/zip_archive\.cpp"),
    "tinyxml2": (r"tinyxml2\.h", r"io/xml/reader\.(h|cpp)"),
    "tinygltf": (r"tiny_gltf\.h", r"io/gltf/\w+\.cpp"),
    "Draco": (r"draco/", r"io/gltf/draco\.cpp|tests/io/gltf/compression_test\.cpp"),
    "meshoptimizer": (r"meshoptimizer\.h", r"io/gltf/meshopt\.cpp|tests/io/gltf/compression_test\.cpp"),
    "tinyobjloader": (r"tiny_obj_loader\.h", r"io/obj/(reader\.h|reader\.cpp|material\.cpp)"),
    "Assimp": (r"assimp/", r"io/assimp/assimp_importer\.cpp"),
    "CLI11": (r"CLI/", r"cli/|bench/options\.cpp"),
    "nlohmann/json": (r"nlohmann/", r"(cli|bench)/(\w+/)?\w*report\.cpp|"
                                    r"cli/(study/record|live/web_state|film/notes_json)\.cpp|"
                                    r"cli/plan/open_job\.cpp|io/utf8\.cpp|"
                                    r"cli/status/(json_lines|metrics_file)\.cpp|"
                                    r"io/(film/film_header|gltf/schema|picture/cryptomatte)\.cpp|"
                                    r"io/exchange/json\.h|"
                                    r"io/gltf/writer_file\.h|"
                                    r"tests/support/json\.h"),
    "Landlock": (r"linux/landlock\.h", r"cli/sandbox/files\.cpp"),
    "libseccomp": (r"seccomp\.h", r"cli/sandbox/system_calls\.cpp"),
    "cmark": (r"cmark", r"cli/study/notes\.cpp"),
    "Catch2": (r"catch2/", r"tests/support/catch\.h"),
    "Google Benchmark": (r"benchmark/", r"bench/"),
}

# libm differs from machine to machine. sqrt, fma, floor and the like are exact or correctly rounded.
LIBM = re.compile(r"(?<![\w.>])(?:std::|::)?(?:a?(?:sin|cos|tan)h?|atan2|sincos|exp[2m]?1?|"
                  r"log(?:2|10|1p|b)?|pow|cbrt|hypot|erfc?|[tl]gamma)[fl]?\s*\(")
# What the standard leaves to the implementation.
UNSPECIFIED_RANDOM = re.compile(r"\b(?:std::)?s?rand\s*\(|"
                                r"std::(?:random_device|shuffle|\w+_distribution)\b")
# Errors are thrown, values are returned; only cli/ talks to people or ends the process.
TALKS = re.compile(r"\b(?:std::c(?:out|err|log)\b|(?:std::)?f?printf\s*\(|(?:std::)?f?puts\s*\(|fmt::print\b|"
                   r"(?:std::)?(?:exit|abort|terminate|quick_exit)\s*\()")

# Libraries that are loaded while the program runs: each by its door.
LOADS = re.compile(r"\bdlopen\s*\(")
LOADERS = ("io/picture/image_codec.cpp", "io/assimp/scene_importer.cpp",
           "integrators/denoise/open_image_denoise.cpp")

LEFT_OPEN = re.compile(r"\b(?:TO" r"DO|FIX" r"ME|X" r"XX|HA" r"CK)\b")
NATIVE = "-march=" + "native"
MACHINE_PATH = re.compile(r"(?<![\w.}])/(?:ho" r"me|ro" r"ot|wo" r"rk)/")
NOT_COUNTED = re.compile(r"\bSKIP\s*\(|\[!(?:mayfail|shouldfail)\]|\[\.[\w]*\]|\bDISABLED_|\bWILL_FAIL\b")

# ctest's list of tests takes a bracket or a semicolon apart: the tests that follow are lost without a word. A
# name that begins with a dash is an option of Catch2's.
BROKEN_NAME = re.compile(r'TEST_CASE\(\s*"(?:-|[^"]*[][;\\])')

# The line that a type's definition begins with; its members' definitions and specialisations are others.
TYPE = re.compile(r"(?:struct|class|enum class) (?:alignas\(\w+\) )?(\w+)(?!\w|::|<)[^;(]*\{")

MAX_LINES = 450
MAX_COLUMNS = 110


def is_header(name):
    return name.endswith(".h")


def is_cpp(name):
    return name.endswith((".h", ".cpp"))


def is_source(name):
    scripts = ("run", ".ci/run", "scenes/fetch")
    others = name.endswith((".py", ".cmake", ".cmake.in", "CMakeLists.txt")) or name in scripts
    return others or is_cpp(name)


def folder(name):
    return name.split("/", 1)[0]


def lines(text):
    return enumerate(text.splitlines(), 1)


def without_comments(text):
    """The same lines, with nothing in place of // comments, and so of what they mention."""
    return re.sub(r"//.*", "", text)


def includes(text):
    """(line, header, whether it is written in quotes) of each #include."""
    for number, line in lines(text):
        if match := re.match(r'\s*#\s*include\s*(["<])([^">]+)', line):
            yield number, match[2], match[1] == '"'


def is_private(text):
    """Whether a header says so in its opening comment."""
    return any(line.startswith("// Private") for line in text.splitlines()[:3])


def private_headers(tree):
    return {name for name, text in tree.items() if is_header(name) and is_private(text)}


def layers(tree):
    for name, text in tree.items():
        allowed = MAY_INCLUDE.get(folder(name))
        if not is_cpp(name) or allowed is None:
            continue
        for number, header, quoted in includes(text):
            if quoted and folder(header) not in allowed:
                yield name, number, f"{folder(name)}/ must not include {header}"


def includes_from_root(tree):
    for name, text in tree.items():
        if not is_cpp(name) or folder(name) not in SOURCE_FOLDERS:
            continue
        for number, header, quoted in includes(text):
            ours = folder(header) in SOURCE_FOLDERS and "/" in header
            beside = str(Path(name).parent / header)  # data of one file, which goes where that file goes
            if quoted and header.endswith(".inc") and beside in tree:
                continue
            if quoted and (header not in tree or ".." in header) and not name.startswith("tests/consumer/"):
                yield name, number, f'"{header}" is not a file of the tree, written from its root'
            elif not quoted and ours and header in tree:
                yield name, number, f"<{header}> is ours: write it in quotes"


def doors(tree):
    for name, text in tree.items():
        if not is_cpp(name):
            continue
        for number, header, _ in includes(text):
            for library, (headers, door) in DOORS.items():
                if re.match(headers, header) and not re.match(door, name):
                    place = door.replace("\\", "")
                    yield name, number, f"{library} is included here, but its only door is {place}"


def privacy(tree):
    private = private_headers(tree)
    for name, text in tree.items():
        if not is_cpp(name):
            continue
        for number, header, _ in includes(text):
            if header not in private:
                continue
            if folder(name) not in ("core", "accel", "check", "bench", "tests", folder(header)):
                yield name, number, f"{header} is private to core/, accel/ and what checks or measures them"
            elif is_header(name) and name not in private and folder(name) != "tests":
                yield name, number, f"{header} is private, so a public header must not include it"


def installed_headers(tree):
    text = tree.get("cmake/Install.cmake", "")
    listed = set(re.findall(r"^  ([\w/-]+\.h)\b", text, re.MULTILINE))
    private = {name for name in private_headers(tree) if folder(name) in LIBRARIES}
    for name in sorted(private - listed):
        yield name, 1, "says that it is private, but cmake/Install.cmake would install it"
    for name in sorted(listed - private):
        yield "cmake/Install.cmake", 1, f"{name} is listed as private, but its first lines do not say so"


def public_headers(tree):
    """A user's compiler finds the standard library and ours, nothing else."""
    private = private_headers(tree)
    for name, text in tree.items():
        if not is_header(name) or folder(name) not in LIBRARIES or name in private:
            continue
        for number, header, quoted in includes(text):
            if not quoted and ("/" in header or header.endswith((".h", ".hpp"))):
                yield name, number, f"a public header must not include <{header}>"


def headers_guarded(tree):
    for name, text in tree.items():
        # What Highway compiles once for each instruction set is read as often.
        guard = "HWY_TARGET_TOGGLE" if name.endswith("-inl.h") else "\n#pragma once\n"
        if is_header(name) and guard not in text:
            yield name, 1, f"a header needs {guard.strip()}"


def licensed(tree):
    for name, text in tree.items():
        mark = "// " if is_cpp(name) else "# "
        if is_source(name) and mark + "SPDX-License-Identifier: Apache-2.0" not in text.splitlines()[:2]:
            yield name, 1, f"the first line must be {mark}SPDX-License-Identifier: Apache-2.0"


def sizes(tree):
    for name, text in tree.items():
        if not is_source(name):
            continue
        count = len(text.splitlines())
        if count > MAX_LINES:
            yield name, MAX_LINES + 1, f"{count} lines; more than {MAX_LINES} are more than one idea"
        for number, line in lines(text):
            if len(line) > MAX_COLUMNS and "cmake" not in name.lower():
                yield name, number, f"{len(line)} columns; at most {MAX_COLUMNS} are read with ease"


def pattern_rule(pattern, applies, message, code_only):
    """A rule against whatever matches the pattern in the files for which applies(name) holds."""
    def rule(tree):
        for name, text in tree.items():
            if not applies(name):
                continue
            for number, line in lines(without_comments(text) if code_only else text):
                if match := re.search(pattern, line):
                    yield name, number, message.format(match[0].strip(" ("))
    return rule


def in_libraries(name):
    return is_cpp(name) and folder(name) in LIBRARIES


def in_program(name):
    return is_cpp(name) and folder(name) in (*LIBRARIES, "cli")


def is_written(name):
    return is_source(name) or name.endswith(".md")


def in_portable_build(name):
    return is_source(name) and not name.startswith("tests/consumer/")


def in_tests(name):
    return folder(name) == "tests" and not name.endswith(".py")


same_bits = pattern_rule(
    LIBM, in_program, "{} differs between machines: use core/elementary.h", code_only=True)
random_numbers = pattern_rule(
    UNSPECIFIED_RANDOM, is_cpp, "{} gives other numbers elsewhere: use core/sampler.h", code_only=True)
quiet_libraries = pattern_rule(
    TALKS, in_libraries, "{}: a library throws Error or returns a value", code_only=True)
loaded_libraries = pattern_rule(
    LOADS, lambda name: in_program(name) and name not in LOADERS,
    f"{{}}: libraries are loaded by {' and '.join(LOADERS)} alone", code_only=True)
nothing_left_open = pattern_rule(
    LEFT_OPEN, is_written, "{}: finish it, or say in the documentation what is missing", code_only=False)
no_machine_paths = pattern_rule(
    MACHINE_PATH, is_written, "{} is a path of one machine", code_only=False)
portable_builds = pattern_rule(
    NATIVE, in_portable_build, "{}: what users build must run on every x86-64", code_only=False)
every_test_counts = pattern_rule(
    NOT_COUNTED, in_tests, "{}: a test that may not count", code_only=False)


whole_names = pattern_rule(
    BROKEN_NAME, in_tests,
    "a test's name must not hold brackets, semicolons or backslashes, nor begin with a dash", code_only=False)


def all_listed(tree):
    """A file that no CMakeLists.txt names is not compiled: a test in it passes always."""
    listed = {normpath(Path(name).parent / file)
              for name, text in tree.items() if name.endswith("CMakeLists.txt")
              for file in re.findall(r"[\w./]+\.cpp\b", text)}
    for name in tree:
        if name.endswith(".cpp") and folder(name) in SOURCE_FOLDERS and name not in listed:
            yield name, 1, "no CMakeLists.txt lists this file"


def sets_before_highway(tree):
    """What a file compiles for each instruction set leaves out those that core/instruction_sets.h names."""
    for name, text in tree.items():
        seen = set()
        for number, header, _ in includes(text) if is_cpp(name) else ():
            seen.add(header)
            if header == "hwy/foreach_target.h" and "core/instruction_sets.h" not in seen:
                yield name, number, "include core/instruction_sets.h first: it says which sets are left out"


def unit(name):
    """A header and the source file that implements it."""
    return re.sub(r"(-inl)?\.(h|cpp)$", "", name)


def circle(graph):
    """The nodes of one circle of a graph (node -> its successors), the first again at the end; or none."""
    done = set()

    def visit(node, path):
        if node in path:
            return [*path[path.index(node):], node]
        if node in done:
            return []
        for successor in sorted(graph.get(node, ())):
            if found := visit(successor, [*path, node]):
                return found
        done.add(node)
        return []

    for node in sorted(graph):
        if found := visit(node, []):
            return found
    return []


def no_circles(tree):
    """Neither files (a header with its source) nor subfolders include each other in a circle."""
    for library in MAY_INCLUDE:
        units, rooms = {}, {}
        for name, text in tree.items():
            if not is_cpp(name) or folder(name) != library:
                continue
            for _, header, quoted in includes(text):
                if not quoted or header not in tree or folder(header) != library:
                    continue
                if unit(header) != unit(name):
                    units.setdefault(unit(name), set()).add(unit(header))
                room, other = str(Path(name).parent), str(Path(header).parent)
                if room != other and library not in (room, other):
                    rooms.setdefault(room, set()).add(other)
        for graph in (units, rooms):
            if found := circle(graph):
                yield found[0], 1, f"includes in a circle: {' -> '.join(found)}"


def types(text):
    """(line, name with its namespaces) of each type that a file defines outside of nameless namespaces."""
    scope = []
    for number, line in lines(text):
        if match := re.match(r"namespace ?([\w:]*) ?\{", line):
            scope.append(match[1])
        elif line.startswith("}  // namespace"):
            scope = scope[:-1]
        elif match := re.match(TYPE, line):
            if "" not in scope:
                yield number, "::".join([*scope, match[1]])


def one_definition(tree):
    """Of two types with one name the linker would take the functions of either."""
    first = {}
    for name, text in sorted(tree.items()):
        for number, defined in types(text) if is_cpp(name) else ():
            if first.setdefault(defined, name) != name:
                yield name, number, f"{first[defined]} defines another {defined}"


RULES = (layers, includes_from_root, doors, privacy, installed_headers, public_headers, headers_guarded,
         licensed, sizes, same_bits, random_numbers, quiet_libraries, loaded_libraries, nothing_left_open,
         no_machine_paths, portable_builds, every_test_counts, whole_names, all_listed, sets_before_highway,
         no_circles, one_definition)


def read_tree(root):
    """All text files that belong to the project; built, hidden and scene files do not."""
    tree = {}
    tops = [root / name for name in (*SOURCE_FOLDERS, "cmake", ".ci", "docs")]
    files = [path for top in tops for path in top.rglob("*")] + [*root.iterdir(), root / "scenes" / "fetch"]
    for path in files:
        name = path.relative_to(root).as_posix()
        if path.is_file() and (is_source(name) or name.endswith((".md", ".inc"))):
            tree[name] = path.read_text(encoding="utf-8")
    return tree


def findings(tree):
    return [f"{name}:{line}: {message}" for rule in RULES for name, line, message in rule(tree)]


def main(arguments):
    if len(arguments) != 1:
        print("usage: rules.py ROOT", file=sys.stderr)
        return 2
    tree = read_tree(Path(arguments[0]))
    if not any(folder(name) == "core" for name in tree):
        print(f"{arguments[0]} holds no source files", file=sys.stderr)
        return 1
    found = findings(tree)
    print("\n".join(found) if found else f"{len(tree)} files keep all rules")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
