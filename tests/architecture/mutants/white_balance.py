# SPDX-License-Identifier: Apache-2.0
"""Defects of the white that a scene's file asks for, and of what a file says of its picture besides."""
from mutant import Mutant

SERIES = "daylight's color lies where the CIE has it, and below 4000 K is a black body's"
WHITE = "the daylight that a scene's file names is white, unless another white is asked for"
FILM = "a film's white balance says which daylight is white, where it is one that can be shown"
PICTURES = "the daylight that a scene's film names is white in its pictures, and in those of its films"
BACK = "exchange: what a file says of its picture comes back"
WRITTEN = "written pbrt: what a file said of its picture stays, and nothing else is said of the filter"
BAKED = "boards and pictures that lie differently are drawn with texels enough to show each of their squares"

MUTANTS = [
    Mutant("daylight is a black body", "io/pbrt/spectrum.cpp",
           "if (t < 4000) return blackbody_color(kelvin);", "return blackbody_color(kelvin);", "test_io",
           SERIES),
    Mutant("cool daylight goes by the formula of warm one", "io/pbrt/spectrum.cpp",
           "t <= 7000", "t <= 70000", "test_io", SERIES),
    Mutant("daylight is asked for at the temperature of another constant", "io/pbrt/spectrum.cpp",
           "kelvin * 1.4388 / 1.4380", "kelvin", "test_io", SERIES),
    Mutant("a file's white wins over that of the command line", "io/display/display.cpp",
           "if (display.white_kelvin)\n    gain",
           "if (display.white_kelvin && !display.daylight_kelvin)\n    gain",
           "test_io", WHITE),
    Mutant("a white balance of any number is taken", "io/pbrt/camera.cpp",
           "if (!(kelvin >= least_white_kelvin && kelvin <= most_white_kelvin)) {", "if (false) {", "test_io",
           FILM),
    Mutant("the note on a film's white balance is left out", "io/pbrt/camera.cpp",
           "  context.notes.push_back(\n      fmt::format(\"in pictures of 8 bits",
           "  (void)(\n      fmt::format(\"in pictures of 8 bits", "test_io", FILM),
    Mutant("pictures do not take their file's white", "cli/render_command_line.cpp",
           "arguments.display.daylight_kelvin = defaults.daylight_kelvin;", "", "test_cli", PICTURES),
    Mutant("films forget their scene's white", "cli/film/merge_command.cpp",
           "arguments.display.daylight_kelvin = daylight_of(notes.picture.metadata);", "", "test_cli",
           PICTURES),
    Mutant("our form takes a white of any number", "io/exchange/reader.cpp",
           "if (!(kelvin >= least_white_kelvin && kelvin <= most_white_kelvin))", "if (false)", "test_io",
           BACK),
    Mutant("a written pbrt file has no white balance", "io/pbrt/writer_camera.cpp",
           "if (input.picture.daylight_kelvin)", "if (false)", "test_io", WRITTEN),
    Mutant("boards that lie differently are drawn at their corners alone", "io/picture/baked_texture.cpp",
           "std::max(frame.part.width, texels_of(part, 0))", "std::max(frame.part.width, 1)", "test_io",
           BAKED),
    Mutant("a turned board is drawn as if it were not", "io/picture/baked_texture.cpp",
           "std::fabs(double(part.uv.m[1][axis])) * part.height", "0 * part.height", "test_io", BAKED),
    Mutant("a picture that repeats without end is drawn so", "io/picture/baked_texture.cpp",
           "double(most)));", "4096.0));", "test_io",
           "a picture of what lies differently has a bound, however often its parts repeat"),
    Mutant("a crop window is that of the nearest doubles", "io/pbrt/camera.cpp",
           "double(float(i < 2 ? size.width : size.height) * part[i])",
           "double(i < 2 ? size.width : size.height) * double(part[i])", "test_io",
           "film, sampler and integrator are defaults of the picture"),
]
