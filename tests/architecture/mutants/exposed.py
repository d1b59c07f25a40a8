# SPDX-License-Identifier: Apache-2.0
"""Defects in how pbrt files' numbers are checked, and their light is exposed."""
from mutant import Mutant

GREYS = "a float that stands for a color is in its range"
SPECTRA = "spectra come from files and lists, and what is wrong with them is named"
TERMINAL = "bytes that a terminal would act on are shown as spaces"

MUTANTS = [
    Mutant("a float that stands for a color has any value", "io/pbrt/spectrum.cpp",
           "check_range(grey, parameter, role);", "", "test_io", GREYS),
    Mutant("light of media is not exposed", "io/pbrt/builder.cpp", "glow = glow * exposure;", "", "test_io",
           "the exposure of film and shutter multiplies the light of media, within shapes and around all"),
    Mutant("negative spectra are black", "io/pbrt/spectrum.cpp",
           "value < 0 && -value > noise * largest", "false", "test_io", SPECTRA),
    Mutant("noise of spectra is an error", "io/pbrt/spectrum.cpp",
           "value < 0 && -value > noise * largest", "value < 0", "test_io", SPECTRA),
    Mutant("a shutter stays open for ever", "io/pbrt/camera.cpp",
           "parameters.real(\"shutterclose\", 1, shutter_times)", "parameters.real(\"shutterclose\", 1)",
           "test_io", "a shutter that stays open for longer than any exposure is an error"),
    Mutant("names in messages reach the terminal as they are", "io/diagnostic.cpp",
           "printable_lines(shortened(message))", "shortened(message)", "test_io", TERMINAL),
    Mutant("letters that are none stay in messages", "io/diagnostic.cpp",
           "return as_utf8(result);", "return result;", "test_io", TERMINAL),
    Mutant("a second parameter of a name wins without a word", "io/pbrt/parameters.cpp",
           "last != &parameter)", "false)", "test_io",
           "a parameter that stands in a statement twice is named, and the last one counts"),
    Mutant("pictures below 0 emit nothing without a word", "io/pbrt/light.cpp",
           "if (negative > 0)", "if (false)", "test_io",
           "what a picture that emits has below 0 is named, and is 0"),
]
