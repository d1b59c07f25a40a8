# SPDX-License-Identifier: Apache-2.0
"""Defects of hair."""
from mutant import Mutant

DENSITY = "a fibre is sampled with its density"
WHITE = "a white fibre scatters all light, and a dark one what its surface reflects, or less"
GLASS = "a fibre reflects light as its surface does, and lets it through as a cylinder of glass does"
SCALES = "scales turn what is reflected towards the root, and what goes through towards the tip"
ABSORBED = "light on its way through a fibre is absorbed by the colour that many of them have"
LOOKED = "looking from a direction first changes no bit of a fibre"
SKY = "hair that absorbs nothing cannot be seen in a white sky, by every way of finding light"
LAMP = "all ways of finding light agree on hair before a lamp"
TANGENT = "a fibre's tangent runs along it, and none of its directions is lost at the sides of its tube"
WITHIN = "light that has come into a fibre leaves it at once, and is hidden by it from outside"
WAVES = "hair has the same bits on all engines, instruction sets and threads"
PIGMENTS = "hair has the colour of its pigments, and pbrt's roughnesses"
TURNED = "hair has no sides: what turns shapes around does not turn it, and no medium is in it"
FIRST = "of several colours of hair the first that pbrt asks for counts, and the others are named"
HUGE = "a curve whose lengths overflow is a mesh all the same, which is refused later"
EDGES = "no model scatters what is negative or not finite, at the ends of its parameters and directions"
ROUND = "hair's reflectance may be a texture's, and its curves are round"
CLOSED = "a curve with ends is closed all around"

MUTANTS = [
    Mutant("scales turn reflections towards the tip", "core/lobes/hair.cpp", "spread(variance, -2 * tilt)",
           "spread(variance, 2 * tilt)", "test_core", SCALES),
    Mutant("scales turn what goes through towards the root", "core/lobes/hair.cpp",
           "spread(0.25f * variance, tilt)", "spread(0.25f * variance, -tilt)", "test_core", SCALES),
    Mutant("a fibre turns light half as far", "core/lobes/hair.cpp", "- 2 * at.azimuth +", "- at.azimuth +",
           "test_core",
           GLASS),
    Mutant("light that goes through a fibre passes one side of it", "core/lobes/hair.cpp",
           "through * square(1 - reflected)", "through * (1 - reflected)", "test_core", WHITE),
    Mutant("light is reflected within a fibre once at most", "core/lobes/hair.cpp",
           "ratio < 1 ? next / (1 - ratio) : 0.0f", "0 * next * ratio", "test_core", WHITE),
    Mutant("the way through a fibre is its radius", "core/lobes/hair.cpp",
           "2 * cosine_of(sin_gamma_within) /", "cosine_of(sin_gamma_within) /", "test_core", ABSORBED),
    Mutant("a fibre is foreshortened as a surface is", "core/lobes/hair.cpp",
           "found.value = cosine > 0 ? found.value / cosine : Rgb{};", "", "test_core", WHITE),
    Mutant("what a fibre reflects often goes to one side", "core/lobes/hair.cpp", "azimuth += 2 * pi * rest;",
           "azimuth += pi * rest;", "test_core", DENSITY),
    Mutant("a fibre's samples spread too widely along it", "core/lobes/hair.cpp",
           "1 + spread.variance * log_of(", "1 + 1.5f * spread.variance * log_of(", "test_core", DENSITY),
    Mutant("a fibre's samples leave out what is beyond half a turn", "core/lobes/hair.cpp",
           "rest * inside_ + below_", "rest * (1 - below_) + below_", "test_core", DENSITY),
    Mutant("a fibre that is looked at has no azimuth", "core/lobes/hair.h",
           "void look_from(const Vec3& wo) { seen_ = seen(wo); }",
           "void look_from(const Vec3& wo) { seen_ = seen({wo.x, 0, wo.z}); }", "test_core", LOOKED),
    Mutant("a fibre is not there, seen from outside", "integrators/passages.h",
           "(kind == Kind::fibre && is_from_within(ray, hit))", "kind == Kind::fibre", "test_integrators",
           WITHIN),
    Mutant("a fibre's wall is there, seen from within", "integrators/passages.h",
           "(kind == Kind::fibre && is_from_within(ray, hit))", "false", "test_integrators", WITHIN),
    Mutant("fibres have sides", "integrators/interaction.h", "if (is_fibre_) return true;", "",
           "test_integrators", TANGENT),
    Mutant("fibres run nowhere", "core/shading_map.cpp",
           "  bool operator()(const Hair&) const { return true; }\n", "", "test_integrators", TANGENT),
    Mutant("pbrt's two roughnesses of hair are one", "io/pbrt/material.cpp",
           "in.mean_number(\"beta_n\", hair.azimuthal_roughness, {0, 1})",
           "in.mean_number(\"beta_m\", hair.azimuthal_roughness, {0, 1})", "test_io", PIGMENTS),
    Mutant("the colour of pigments is that of usual hair", "io/pbrt/material.cpp",
           "hair.reflectance = of(pigments_of(in));",
           "hair.reflectance = of({0.5f, 0.9f, 1.8f});", "test_io", PIGMENTS),
    Mutant("curves of hair are as others", "io/pbrt/shape.cpp",
           "curve.kind = CurveKind::cylinder, curve.has_ends = true;", "curve.has_ends = true;", "test_io",
           ROUND),
    Mutant("a tube has one end", "io/pbrt/curve.cpp",
           "  add_end(sections.front(), 0, sides, false, mesh);\n", "", "test_io", CLOSED),
    Mutant("ReverseOrientation turns hair inside out", "io/pbrt/builder.cpp", " && !context_.has_fibres", "",
           "test_io", TURNED),
    Mutant("a medium in hair is lost silently", "io/pbrt/builder.cpp",
           "         std::holds_alternative<Hair>(model) || (sheet", "         (sheet", "test_io", TURNED),
    Mutant("the last colour of hair counts", "io/pbrt/material.cpp", "if (found && said)",
           "if (found && said && is_pigment)", "test_io", FIRST),
    Mutant("a curve whose lengths overflow has no steps", "io/pbrt/curve.cpp",
           "return steps > 1 ? int(std::min(std::ceil(steps), most)) : 1;",
           "return int(std::clamp(std::ceil(steps), 1.0f, most));", "test_io", HUGE),
    Mutant("hair that scatters nothing has no density", "core/lobes/hair.cpp", "  if (sum == 0) return;", "",
           "test_core", EDGES),
]
