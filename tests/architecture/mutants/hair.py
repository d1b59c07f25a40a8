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
ROUND = "hair's reflectance may be a texture's, and its curves are round"
CLOSED = "a curve with ends is closed all around"

MUTANTS = [
    Mutant("scales turn reflections towards the tip", "core/lobes/hair.cpp", "spread(variance, -2 * tilt)",
           "spread(variance, 2 * tilt)", "test_core", SCALES),
    Mutant("scales turn what goes through towards the root", "core/lobes/hair.cpp",
           "spread(0.25f * variance, tilt)", "spread(0.25f * variance, -tilt)", "test_core", SCALES),
    Mutant("a fibre turns light half as far", "core/lobes/hair.cpp", "- 2 * gamma +", "- gamma +",
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
    Mutant("light samples do not get out of fibres", "integrators/passages.h",
           "return has_interfaces_ || starts_in_fibre;", "return has_interfaces_;", "test_integrators", SKY),
    Mutant("fibres have sides", "integrators/interaction.h", "if (is_fibre_) return true;", "",
           "test_integrators", TANGENT),
    Mutant("light samples start in fibres where they do not", "integrators/interaction.h",
           "is_fibre_ && !(dot(facing_normal_, wi) > 0)", "is_fibre_ && dot(facing_normal_, wi) > 0",
           "test_integrators", TANGENT),
    Mutant("fibres run nowhere", "core/shading_map.cpp",
           "  bool operator()(const Hair&) const { return true; }\n", "", "test_integrators", TANGENT),
    Mutant("waves let light samples out of fibres where they start outside", "integrators/wave/media.cpp",
           "context_.passages.may_pass(starts_in_fibre(k))",
           "context_.passages.may_pass(!starts_in_fibre(k))",
           "test_integrators", WAVES),
    Mutant("pbrt's two roughnesses of hair are one", "io/pbrt/material.cpp",
           "in.number(\"beta_n\", hair.azimuthal_roughness, {0, 1})",
           "in.number(\"beta_m\", hair.azimuthal_roughness, {0, 1})", "test_io", PIGMENTS),
    Mutant("the colour of pigments is that of usual hair", "io/pbrt/material.cpp",
           "hair_reflectance(pigments_of(in), hair.azimuthal_roughness)",
           "hair_reflectance({0.5f, 0.9f, 1.8f}, hair.azimuthal_roughness)", "test_io", PIGMENTS),
    Mutant("curves of hair are as others", "io/pbrt/shape.cpp",
           "curve.kind = CurveKind::cylinder, curve.has_ends = true;", "curve.has_ends = true;", "test_io",
           ROUND),
    Mutant("a tube has one end", "io/pbrt/curve.cpp",
           "  add_end(sections.front(), 0, sides, false, mesh);\n", "", "test_io", CLOSED),
]
