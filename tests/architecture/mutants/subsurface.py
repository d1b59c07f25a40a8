# SPDX-License-Identifier: Apache-2.0
"""Defects of light below surfaces."""
from mutant import Mutant

INVERSE = "the albedo of one scattering is that of the reflectance that it makes"
MEDIUM = "a medium below has the mean way between scatterings that was asked for"
EMERGING = "of light that has entered a coat, so much comes out as was asked for"
BASE = "a matte base has the albedo of its own part of the scattering function"
DRAWN = "a draw takes a direction from the matte base where the base says so, and a cosine's density"
REFUSED = "a subsurface that is out of range, or has no base above it, is refused"
DEEP = "a deep body reflects as much as its albedo was asked for"
PLATE = "a plate reflects and lets through what a walk along one axis says"
CLEAR = "what absorbs nothing loses nothing"
WITHIN = "surfaces of other materials within a body change nothing, and parts of one body are one"
OPEN = "a walk that leaves a body that is not closed does not come out"
DRAWS = "draws of a walk are those of no vertex of a path, nor of another walk"
SAME = "where light goes no way below, a body is what its base would be, by lamps and by directions"
WHITE = "a body that absorbs nothing cannot be told from a white sky, by every way of finding light"
BEHIND = "light comes out of a body where no lamp shines on it"
BOUNCE = "a lit walk through a body counts as one bounce"
METHODS = "all ways of finding light agree on what comes out of bodies"
PARTS = "what comes out of a body is diffuse light, and the parts of a picture add up to it"
REPLAY = "a replayed path names its walks below surfaces, and its terms add up to its radiance"
FURNACE = "a furnace takes the base for what is below it"
EMITTED = "pbrt's subsurface by what comes out of it, and by how far light goes"
COEFFICIENTS = "pbrt's subsurface by what the body absorbs and scatters, by a name, or skin"
TEXTURE = "a texture of what comes out of a body is that at each point"
TWO = "a subsurface material that says two things, or half of one, is refused"
OPENPBR = "OpenPBR's subsurface has the colour of its base, mixed by its weight"
OWN_TEXTURE = "a texture of OpenPBR's base is not that of what is below it"
WRITTEN = "written pbrt: a body comes back, and what pbrt's cannot be is named"
TOLD = "a replay says where a path goes below a surface, and where it comes out"

MUTANTS = [
    Mutant("the albedo below forgets the anisotropy", "core/subsurface.cpp",
           "(1 - anisotropy * s * s)", "1", "test_core", INVERSE),
    Mutant("what is not scattered below is not absorbed", "core/subsurface.cpp",
           "absorption = (1 - albedo) / radius;", "absorption = albedo * 0 / radius;", "test_core", MEDIUM),
    Mutant("a coat reflects nothing back down into a body", "core/subsurface.cpp",
           "return {channel(emerging.r)", "return emerging; return {channel(emerging.r)", "test_core",
           EMERGING),
    Mutant("a coated base is seen through no coat", "core/lobes/coated_diffuse.cpp",
           "base_ * ((1 - reflectance) * out)", "base_ * out", "test_core", BASE),
    Mutant("a layered base is seen through no gloss", "core/lobes/principled.cpp",
           "seen.through_gloss * (white - gloss_average_)", "(white - gloss_average_)", "test_core", BASE),
    Mutant("a coated base is drawn where the coat is", "core/lobes/coated_diffuse.cpp",
           "return {probability, 1 - probability,", "return {0, 1 - probability,", "test_core", DRAWN),
    Mutant("a layered base is drawn where fuzz is", "core/lobes/principled.cpp",
           "return {seen.choice.fuzz, seen.choice.diffuse,", "return {0, seen.choice.diffuse,", "test_core",
           DRAWN),
    Mutant("a sheet may have light below it", "core/material.cpp",
           "(principled && !principled->geometry_thin_walled)", "principled", "test_core", REFUSED),
    Mutant("a walk goes on where it is given up", "integrators/walk_below.cpp",
           "left = left / probability;", "", "test_integrators", DEEP),
    Mutant("a walk keeps its direction", "integrators/walk_below.cpp",
           ".direction = wi};", ".direction = direction};", "test_integrators", PLATE),
    Mutant("a walk's steps begin where it entered", "integrators/walk_below.cpp",
           "end.ray.origin + direction * flight.distance()", "end.ray.origin", "test_integrators", PLATE),
    Mutant("a walk's weights are its last one's", "integrators/walk_below.cpp",
           "end.left = end.left * flight.weight();", "end.left = flight.weight();", "test_integrators",
           PLATE),
    Mutant("a walk comes out at whatever it meets", "integrators/walk_below.cpp",
           "if (scene.bindings[point.shape].material == body) return end;", "return end;",
           "test_integrators", WITHIN),
    Mutant("walks below all vertices have the same draws", "integrators/walk_below.h",
           "(vertex + 1) * (2 * most_events)", "2 * most_events", "test_integrators", DRAWS),
    Mutant("a body's base is not taken from what is reflected above it", "integrators/interaction.cpp",
           "at_least_zero(all.value - value * weight_below_)", "all.value", "test_integrators", SAME),
    Mutant("directions of the base count where it is a body", "integrators/interaction.cpp",
           "std::max(all.pdf - pdf * base.probability * weight_below_, 0.0f)", "all.pdf", "test_integrators",
           SAME),
    Mutant("the base absorbs before the body does", "integrators/interaction.cpp",
           ".value = ratio(base.albedo, base.reflectance) * (weight_below_ / pi),",
           ".value = base.albedo * (weight_below_ / pi),", "test_integrators", SAME),
    Mutant("what comes out passes the coat as if there were none", "integrators/interaction.cpp",
           "return {ratio(value, base.albedo), pdf};", "return {white * (1 / pi), pdf};", "test_integrators",
           SAME),
    Mutant("all light goes below, whatever the weight", "integrators/interaction.cpp",
           "lobe < base.first + base.probability * weight_below_;", "lobe < base.first + base.probability;",
           "test_integrators", SAME),
    Mutant("where a path comes out no light is looked for", "integrators/path_reference.cpp",
           "!leave(*emerged, draws.at_end())", "!scatter(*emerged, depth, draws.at_end(), path, observer)",
           "test_integrators", BEHIND),
    Mutant("to enter a body is a bounce, and to come out another", "integrators/path_reference.cpp",
           "if (path.is_below) return true;",
           "if (path.is_below) return path.bounces += one_bounce(next->kind), true;",
           "test_integrators", BOUNCE),
    Mutant("scenes of bodies are traced in waves", "integrators/path.cpp",
           "has_flights(materials) || std::any_of", "has_flights(materials) && std::any_of",
           "test_integrators", BEHIND),
    Mutant("what comes out of a body is no diffuse light", "integrators/interaction.cpp",
           "if (is_emerging()) return {1, 1, 1};", "if (is_emerging()) return {};", "test_integrators",
           PARTS),
    Mutant("a path's log does not name its walks", "integrators/path_reference.cpp",
           ".events_below = end->events", ".events_below = std::nullopt", "test_integrators", REPLAY),
    Mutant("pbrt's scale of a body does not scale its ways", "io/pbrt/subsurface_material.cpp",
           "ColorRole::unbounded) * scale);", "ColorRole::unbounded));", "test_io", EMITTED),
    Mutant("what comes out of a body is its base", "io/pbrt/subsurface_material.cpp",
           "model.reflectance = base_of_emerging(model, emerging);", "model.reflectance = emerging;",
           "test_io", EMITTED),
    Mutant("a body's way is that of what it scatters", "io/pbrt/subsurface_material.cpp",
           "radius = 1 / extinction;", "radius = 1 / s;", "test_io", COEFFICIENTS),
    Mutant("a texture of what comes out is that of the base", "core/textured_material.cpp",
           "coated && has_emerging)", "coated && !has_emerging)", "test_io", TEXTURE),
    Mutant("a body may have one of its coefficients", "io/pbrt/subsurface_material.cpp",
           'if (in.has("sigma_a") != in.has("sigma_s"))', "if (false)", "test_io", TWO),
    Mutant("the base's colour is that of what is below it", "io/pbrt/subsurface_material.cpp",
           "own + (color - own) * weight", "color", "test_io", OPENPBR),
    Mutant("the base's texture is that of what is below it", "io/pbrt/subsurface_material.cpp",
           "std::erase_if(in.uses, is_of_base) > 0",
           "std::count_if(in.uses.begin(), in.uses.end(), is_of_base) > 0",
           "test_io", OWN_TEXTURE),
    Mutant("written pbrt has the base for what comes out", "io/pbrt/writer_material.cpp",
           "is_body ? emerging_of_base(model, model.reflectance) : model.reflectance", "model.reflectance",
           "test_io", WRITTEN),
    Mutant("a replay does not say that a path enters a body", "cli/replay/text.cpp",
           'if (next.is_below) return "entering the body";', "", "test_cli", TOLD),
]
