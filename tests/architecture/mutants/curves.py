# SPDX-License-Identifier: Apache-2.0
"""Defects of pbrt's curves."""
from mutant import Mutant

CURVE = "io/pbrt/curve.cpp"
STRAIGHT = "a straight curve is one step, whose area is that of a round tube of its width"
STEPS = "steps of a bent curve lie within a fiftieth of its width, or 0.004 of its length"
BASES = "each basis and degree of curves begins, passes and ends where it should"
RIBBON = "a ribbon faces its normals, across as wide as it is"
NONE = "curves that are none are refused where they stand"
STILL = "curves that stand still, or fold back, are meshes without anything that is not finite"

MUTANTS = [
    Mutant("tubes of curves are inscribed, and so too thin", CURVE,
           "pi / (float(sides) * sincos_turns(0.5f / float(sides)).sin)", "1.0f", "test_io", STRAIGHT),
    Mutant("the sides of a curve look inward", CURVE, "mesh.triangles.push_back({a, b, d});",
           "mesh.triangles.push_back({a, d, b});", "test_io", STRAIGHT),
    Mutant("a curve's steps are half as many", CURVE, "std::sqrt(0.75f * bend", "std::sqrt(0.19f * bend",
           "test_io", STEPS),
    Mutant("a cubic B-spline begins at its first point", CURVE,
           "lerp(lerp(p[0], p[1], 2.0f / 3), b, 0.5f)", "p[0]", "test_io", BASES),
    Mutant("quadratic curves bend half as much", CURVE, "lerp(a, b, 2.0f / 3), lerp(c, b, 2.0f / 3)",
           "lerp(a, b, 1.0f / 3), lerp(c, b, 1.0f / 3)", "test_io", BASES),
    Mutant("a curve has one width", CURVE, "curve.width0 * (1 - u) + curve.width1 * u", "curve.width0",
           "test_io", "a curve becomes thinner along all of it"),
    Mutant("a ribbon is twice as wide", CURVE, "(v - 0.5f) * section.width",
           "(v - 0.5f) * section.width * 2", "test_io", RIBBON),
    Mutant("a curve that stands still has no direction", CURVE,
           "if (!(length(place.along) > 0)) place.along = sections.empty()",
           "if (false) place.along = sections.empty()", "test_io", STILL),
    Mutant("a curve's end has no width of its own, nor that of all of it", "io/pbrt/curve_reader.cpp",
           'parameters.real("width1", width, widths)', 'parameters.real("width1", 1, widths)', "test_io",
           "curves of pbrt are tubes where they stand, and ribbons"),
    Mutant("a ribbon may have too few normals", "io/pbrt/curve_reader.cpp", "if (normals.size() != count)",
           "if (normals.empty() && count == 0)", "test_io", NONE),
]
