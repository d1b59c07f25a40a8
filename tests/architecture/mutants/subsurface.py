# SPDX-License-Identifier: Apache-2.0
"""Defects of light below surfaces."""
from mutant import Mutant

INVERSE = "the albedo of one scattering is that of the reflectance that it makes"
MEDIUM = "a medium below has the mean way between scatterings that was asked for"
EMERGING = "of light that has entered a coat, so much comes out as was asked for"
BASE = "a matte base has the albedo of its own part of the scattering function"
LEAVES = "all light from below leaves the surface, whatever its base reflects"
PART = "what goes below is the subsurface's part of the base, and no metal"
NONE = "where light goes less far below than rounding, it is reflected where it is"
BEYOND = "a path that comes out beyond what covers a body is in what is there"
LET_IN = "what is let into a body sees no other body around it from within"
ENTERED = "light enters a body as it comes to the true surface, whatever other normals say"
WITHIN_BALL = "a body that is seen from within, with nothing beyond, reflects where it is"
LONG = "a walk that would be too long comes out where it went in"
WAY = "the way from a surface to where its rays begin is part of a walk"
RADIUS = "a radius of 0 is none, and one that is short in a channel at least a thousandth of the others'"
DRAWN = "a draw takes a direction from the matte base where the base says so, and a cosine's density"
REFUSED = "a subsurface that is out of range, or has no base above it, is refused"
DEEP = "a deep body reflects as much as its albedo was asked for"
PLATE = "a plate reflects and lets through what a walk along one axis says"
WITHIN = "surfaces of other materials within a body change nothing, and parts of one body are one"
DRAWS = "draws of a walk are those of no vertex of a path, nor of another walk"
SAME = "where light goes no way below, a body is what its base would be, by lamps and by directions"
BEHIND = "light comes out of a body where no lamp shines on it"
BOUNCE = "in a room of matte surfaces and bodies, diffuse bounces are bounces"
LEAVING = "what comes out of a body leaves through its layers, in directions of a matte surface"
PARTS = "what comes out of a body is diffuse light, and the parts of a picture add up to it"
REPLAY = "a replayed path names its walks below surfaces, and its terms add up to its radiance"
EMITTED = "pbrt's subsurface by what comes out of it, and by how far light goes"
COEFFICIENTS = "pbrt's subsurface by what the body absorbs and scatters, by a name, or skin"
TEXTURE = "a texture of what comes out of a body is that at each point"
TWO = "a subsurface material that says two things, or half of one, is refused"
OPENPBR = "OpenPBR's subsurface has its own colour, weight and ways"
OWN_TEXTURE = "OpenPBR's subsurface may have textures for its colour and its weight"
WRITTEN = "written pbrt: a body comes back, and what pbrt's cannot be is named"
TOLD = "a replay says where a path goes below a surface, and where it comes out"
INTO = "a walk into a body is in what its surface lets through, from just below it"
WAVES = "waves of paths have the bits and the rays of paths one after the other"

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
           "seen.through_gloss * (white - gloss_average_) *", "(white - gloss_average_) *", "test_core",
           BASE),
    Mutant("metal goes below", "core/lobes/principled.cpp",
           "return diffuse_ * subsurface_ * through_all(seen, wi) * (1 / pi);",
           "return diffuse_ * subsurface_ * through_all(seen, wi) * (1 / (pi * opaque_));", "test_core",
           BASE),
    Mutant("a subsurface is as rough as the rest of the base", "core/lobes/principled.h",
           "(rough + subsurface_ * (1 / pi))", "(white * rough_.evaluate(wo, wi).value)", "test_core", PART),
    Mutant("a subsurface has the base's colour", "core/lobes/principled.cpp",
           "reflectance_(mix(m.base_color * m.base_weight, m.subsurface_color, m.subsurface_weight)),",
           "reflectance_(m.base_color * m.base_weight),", "test_core", PART),
    Mutant("what leaves a coat from below is not all", "core/lobes/coated_diffuse.cpp",
           "/ ((1 - coat_.average_reflectance()) * pi)", "/ pi", "test_core", LEAVES),
    Mutant("what leaves layers from below is not all", "core/lobes/principled.cpp",
           "out.coat * out.fuzz / (through_.coat * through_.fuzz)", "out.coat * out.fuzz", "test_core",
           LEAVES),
    Mutant("a coated base is drawn where the coat is", "core/lobes/coated_diffuse.cpp",
           "return {probability, 1 - probability,", "return {0, 1 - probability,", "test_core", DRAWN),
    Mutant("a layered base is drawn where fuzz is", "core/lobes/principled.cpp",
           "return {seen.choice.fuzz, seen.choice.diffuse *", "return {0, seen.choice.diffuse *",
           "test_core", DRAWN),
    Mutant("a sheet may have light below it", "core/material.cpp",
           "(principled && !principled->geometry_thin_walled)", "principled", "test_core", REFUSED),
    Mutant("a walk goes on where it is given up", "integrators/walk_below.cpp",
           "left = left / probability;", "", "test_integrators", DEEP),
    Mutant("a walk keeps its direction", "integrators/walk_below.cpp",
           ".direction = Frame(-before.direction).to_world(phase_.sample(u))};",
           ".direction = before.direction};", "test_integrators", PLATE),
    Mutant("a walk's steps begin where it entered", "integrators/walk_below.cpp",
           "before.origin + before.direction * distance", "before.origin",
           "test_integrators", PLATE),
    Mutant("a walk's weights are its last one's", "integrators/walk_below.cpp",
           "walk_.left = walk_.left * flight_->weight();", "walk_.left = flight_->weight();",
           "test_integrators",
           PLATE),
    Mutant("a walk comes out at whatever it meets", "integrators/walk_below.cpp",
           "if (scene_->bindings[point.shape].material == body_.material) return comes_out();",
           "return comes_out();",
           "test_integrators", WITHIN),
    Mutant("walks below all vertices have the same draws", "integrators/walk_below.h",
           "(vertex + 1) * (2 * most_steps)", "2 * most_steps", "test_integrators", DRAWS),
    Mutant("a walk that is too long is lost", "integrators/walk_below.cpp",
           "return comes_back();", "return false;", "test_integrators", LONG),
    Mutant("a walk begins where its ray does", "integrators/walk_below.cpp",
           "before_(start.way)", "before_(0)", "test_integrators", WAY),
    Mutant("a walk comes out in what was there where it went in", "integrators/walk_below.cpp",
           "walk.interiors = Interaction::interiors_behind(scene, point, back, walk.interiors);", "",
           "test_integrators", BEYOND),
    Mutant("light is as dense within glass as outside of it, below a surface", "integrators/walk_below.cpp",
           "walk.left = walk.left / (eta * eta);", "", "test_integrators", BEYOND),
    Mutant("a body that lets light in has another around it", "integrators/emergence.cpp",
           "binding.material == at.material() && binding.alpha == no_texture && !lets_light_in(material)",
           "binding.alpha == no_texture", "test_integrators", LET_IN),
    Mutant("light enters a body around the shading normal", "integrators/scattering.cpp",
           "return Frame(facing(at.point().geometric_normal, at.wo())).to_world(local);",
           "return at.to_world(local);", "test_integrators", ENTERED),
    Mutant("what is turned back from no body is all of the light", "integrators/emergence.cpp",
           "start.left_if_open = reflectance;", "start.left_if_open = white * 0.5f;", "test_integrators",
           WITHIN_BALL),
    Mutant("no way below is too short", "integrators/emergence.cpp",
           "< least_radius * at.point().offset) return false;", "< 0) return false;", "test_integrators",
           NONE),
    Mutant("a way below may be too short in a channel", "integrators/emergence.cpp",
           "at_least(below.radius, least_radius * in.offset)", "below.radius", "test_integrators", NONE),
    Mutant("a body's base is not taken from what is reflected above it", "integrators/interaction.cpp",
           "at_least_zero(all.value - bsdf_->of_below(wo_local_, local))", "all.value", "test_integrators",
           SAME),
    Mutant("directions of the base count where it is a body", "integrators/interaction.cpp",
           "std::max(all.pdf - pdf * bsdf_->below(wo_local_).probability, 0.0f)", "all.pdf",
           "test_integrators", SAME),
    Mutant("the base absorbs before the body does", "integrators/interaction.cpp",
           ".value = passed / pi,", ".value = below.albedo / pi,", "test_integrators", SAME),
    Mutant("what comes out passes the coat as if there were none", "integrators/interaction.cpp",
           "return {bsdf_->from_below(local), pdf};", "return {white * (local.z > 0 ? 1 / pi : 0), pdf};",
           "test_integrators", LEAVING),
    Mutant("all that is diffuse goes below, whatever the weight", "core/lobes/principled.cpp",
           "seen.choice.diffuse * subsurface_weight_", "seen.choice.diffuse", "test_core", PART),
    Mutant("where a path comes out no light is looked for", "integrators/path_reference.cpp",
           "!leave(*emerged, draws.at_end())", "!scatter(*emerged, depth, draws.at_end(), path, observer)",
           "test_integrators", BEHIND),
    Mutant("to enter a body is a bounce, and to come out another", "integrators/path_reference.cpp",
           "if (path.is_below) return true;",
           "if (path.is_below) return path.bounces += one_bounce(next->kind), true;",
           "test_integrators", BOUNCE),
    Mutant("what comes out of a body is no diffuse light", "integrators/interaction.cpp",
           "if (is_emerging()) return {1, 1, 1};", "if (is_emerging()) return {};", "test_integrators",
           PARTS),
    Mutant("a path that stays in a body ends as others do", "integrators/path_log.cpp",
           "if (vertex.scattering->next->is_below) return PathEnd::below;", "", "test_integrators", REPLAY),
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
    Mutant("a sheet has light below it", "io/pbrt/subsurface_material.cpp",
           "if (!model.geometry_thin_walled) return", "return", "test_io", OPENPBR),
    Mutant("a texture of OpenPBR's weight is none", "io/pbrt/subsurface_material.cpp",
           "model.subsurface_weight == 0 && !has_texture", "model.subsurface_weight == 0", "test_io",
           OWN_TEXTURE),
    Mutant("a short radius is any number", "io/pbrt/subsurface_material.cpp",
           "std::clamp(r, longest * least_part, most)", "r", "test_io", RADIUS),
    Mutant("written pbrt has the base of OpenPBR's, whatever its part", "io/one_base.cpp",
           "const bool is_below = weight >= 0.5f;", "const bool is_below = false;",
           "test_io", WRITTEN),
    Mutant("written pbrt has the base for what comes out", "io/pbrt/writer_material.cpp",
           "is_body ? emerging_of_base(model, model.reflectance) : model.reflectance", "model.reflectance",
           "test_io", WRITTEN),
    Mutant("a replay does not say that a path enters a body", "cli/replay/text.cpp",
           'if (next.is_below) return "entering the body";', "", "test_cli", TOLD),
    Mutant("a wave's walks end at random as if they had not come out", "integrators/wave/path_ends.cpp",
           "  draw_roulette_of_walks();\n", "", "test_integrators", WAVES),
    Mutant("a wave's walks come out with the cones that they had", "integrators/wave/bodies.cpp",
           "  paths_.cone_width[i] = cone.width;\n", "", "test_integrators", WAVES),
    Mutant("a wave's walks seek light where they went in", "integrators/wave/bodies.cpp",
           "  show_receiver(other);\n", "", "test_integrators", WAVES),
    Mutant("a wave's bodies are what their bases are", "integrators/wave/other_surfaces.cpp",
           "    other.at.keep_above();\n", "", "test_integrators", WAVES),
    Mutant("a wave adds no light where walks come out", "integrators/wave/bodies.cpp",
           "    radiance_[sample] += term.radiance();\n", "", "test_integrators", WAVES),
    Mutant("a wave's walks come out as dense as they went in", "integrators/wave/bodies.cpp",
           "  paths_.eta_squared[i] *= end.eta_squared;\n", "", "test_integrators", WAVES),
    Mutant("rays of a walk end before it is scattered", "integrators/walk_below.cpp",
           "std::max(flight_->reach(body_.medium) - before_, 0.0f)",
           "std::max(0.5f * flight_->reach(body_.medium) - before_, 0.0f)", "test_integrators", PLATE),
    Mutant("a walk that begins nowhere sees no body", "integrators/walk_below.cpp",
           "  if (step_ == 0 && start_.left_if_open) return;",
           "  if (step_ == 1 && start_.left_if_open) return;", "test_integrators", INTO),
]
