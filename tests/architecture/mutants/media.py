# SPDX-License-Identifier: Apache-2.0
"""Defects of media that scatter light."""
from mutant import Mutant

WEIGHTS = "the weights of flights have the mean that light has, whatever their channel is chosen by"
ROUNDED = "a draw that is rounded up to all chances goes by no channel that the path does not have"
BOUNDED = "no channel of a flight weighs more than the reciprocal of its chance"
DENSITY = "a phase function is a density over all directions, of the mean cosine that it is made for"
CHOSEN = "a phase function chooses directions by its density"
WHITE = "a body that scatters all light cannot be told from a white sky, by every way of finding light"
FURNACE = "in a furnace a body that scatters all light is white"
ONCE = "light that is scattered once is what the integral along the ray says"
AIR = "an atmosphere is around the camera and all shapes, but not within what has an inside of its own"
LAYERS = "where a path is scattered by a medium first, layers have no surface, and the picture is covered"
PARTS = "light that media scatter is transmitted light, and the parts of a picture add up to it"
LIMITS = "how often media scatter is bounded as light that goes through surfaces is"
PATCHES = "a point in a medium sees patches on all sides of it alike"
LAMPS = "a point in a medium is lit by lamps on all sides of it alike"
DIMMED = "a medium that scatters dims what goes straight on, and is found where it is"
REFUSED = "interiors that cannot be are refused"
FLIGHT = "a way with a flight is scattered where that ends, in media that scatter alone"
READ = "what a medium scatters, and where to, is that of its statement or of a measured one"
OUTSIDE = "a medium that is named outside of the camera is the atmosphere, though it is made later"
AROUND = "what pbrt's shapes around the camera have outside is the atmosphere"
ENCLOSED = "closed shapes enclose what is within them, and nothing else"
LIES_IN = "written pbrt: each body says what it lies in, and the camera what it stands in"
THIN = "no way is too short or too long for a flight"
OPENPBR = "OpenPBR's clear surface scatters within, and loses at least what it scatters"
REPLAYED = "a replay says where a medium has scattered the path"

GRID = "what a grid has along a ray is the integral of its trilinear density"
REACHED = "a grid is reached where so much lies before, and no further than where there is so much"
AXES = "rays along the axes, in the planes of a grid, and beside it end well"
COLUMN = "a column of an even medium is as long as the way, and one of a grid as dense"
UNEVEN = "a medium of a density that is the same all around is even"
UNIFORM = "a uniformgrid is a medium whose density lies in its box, in the space of its statement"
MANY = "waves have the bits of paths that choose from many lights by power, and from lights without any"
SEARCHED = "a ray in a medium is searched as far as its path goes"
WAVES = "waves of paths have the bits and the rays of paths one after the other"
BEYOND = "a ray that is cut behind a way is no shorter than the way, and hardly longer"

MUTANTS = [
    Mutant("a grid's cells are integrated by their middles", "core/density_grid.cpp",
           "return half * (density(middle - half * node) + density(middle + half * node));",
           "return half * node * 0 + 2 * half * density(middle);", "test_core", GRID),
    Mutant("a grid's box ends at the middles of its outer cells", "core/density_grid.cpp",
           "const double low = 0.5, high = size_[k] + 0.5;",
           "const double low = 1, high = size_[k];", "test_core", GRID),
    Mutant("a ray beside a grid's box that is parallel to its sides is in it", "core/density_grid.cpp",
           "if (!(o >= low && o <= high)) return;", "", "test_core", AXES),
    Mutant("a grid's lengths are those of the ray's parameter", "core/density_grid.cpp",
           "return sum * scale;", "return sum;", "test_core", GRID),
    Mutant("a grid is reached by what lies in one cell", "core/density_grid.cpp",
           "passed += whole;", "", "test_core", REACHED),
    Mutant("a column of a grid begins at the ray's origin", "integrators/medium_column.h",
           "(end.t - ray_.t_min) * length", "end.t * length", "test_integrators", COLUMN),
    Mutant("media that are not even are even", "integrators/medium_column.h",
           "medium.density == no_density ? nullptr", "medium.density >= 0 ? nullptr",
           "test_integrators", UNEVEN),
    Mutant("a uniformgrid lies in the world's space", "io/pbrt/medium.cpp",
           "return (to_world * Transform", "return (Transform",
           "test_io", UNIFORM),
    Mutant("the rest of a channel's draw is not even", "integrators/channels.h",
           "std::min(u / channel_of(chance, channel), 1 - 0x1p-24f)",
           "std::min(u, 1 - 0x1p-24f)", "test_integrators", WEIGHTS),
    Mutant("a flight forgets the depth that it has spent", "integrators/flight.cpp",
           "depth_ = std::max(depth_ - own * passed, 0.0f);", "", "test_integrators", WEIGHTS),
    Mutant("a flight is weighted by its own channel alone", "integrators/flight.cpp",
           "if (!has_ended_) return left_ / sum_of(chance_ * left_);",
           "if (!has_ended_) return left_ / channel_of(left_, channel_);", "test_integrators", BOUNDED),
    Mutant("what media absorb is not in the density of a flight's end", "integrators/flight.cpp",
           "sum_of(chance_ * medium_.extinction() * left_)", "sum_of(chance_ * medium_.scattering * left_)",
           "test_integrators", WEIGHTS),
    Mutant("a flight may go by a channel that is dark", "integrators/channels.h",
           "while (channel > 0 && channel_of(chance, channel) == 0) --channel;", "", "test_integrators",
           ROUNDED),
    Mutant("media that absorb alone end a flight", "integrators/way.h",
           "    if (flight && medium && scatters(*medium))\n      is_scattered",
           "    if (flight && medium)\n      is_scattered",
           "test_integrators", FLIGHT),
    Mutant("a flight's distance is a ray's parameter", "integrators/way.h",
           "flight->distance() / length(ray.direction)", "flight->distance()", "test_integrators", FLIGHT),
    Mutant("a phase function of a negative anisotropy is that of a positive one", "core/phase_function.cpp",
           "const float turned = g_ < 0 ? 1 + cosine : 1 - cosine;", "const float turned = 1 - cosine;",
           "test_core",
           DENSITY),
    Mutant("a phase function scatters back what it should scatter forward", "core/phase_function.cpp",
           "return {sine * turn.cos, sine * turn.sin, -cosine};",
           "return {sine * turn.cos, sine * turn.sin, cosine};",
           "test_core", CHOSEN),
    Mutant("a medium's phase function has a cosine", "integrators/interaction.h",
           "return phase_ ? 1 : std::fabs(sample.wi.z); }", "return std::fabs(sample.wi.z); }",
           "test_integrators",
           FURNACE),
    Mutant("light samples see a medium's phase function from behind", "integrators/interaction.cpp",
           "phase_->evaluate(-local.z)", "phase_->evaluate(local.z)", "test_integrators", ONCE),
    Mutant("a point in a medium is gathered at as at a surface", "core/light_patch.h",
           "return is_in_medium() ? length(towards) : dot(normal, towards);",
           "return dot(normal, towards);",
           "test_core", PATCHES),
    Mutant("of many lights a point in a medium sees none", "core/light_tree.cpp",
           "receiver.is_in_medium() ? 1 : dot(receiver.normal, direction)",
           "dot(receiver.normal, direction)",
           "test_core", LAMPS),
    Mutant("what scatters does not dim what goes straight on", "core/material.h",
           "return absorption + scattering; }", "return absorption; }", "test_core", DIMMED),
    Mutant("of a medium that is hidden light is scattered", "core/interiors.cpp",
           "&materials[interiors.prevailing(materials)].interior", "&materials[0].interior", "test_core",
           DIMMED),
    Mutant("a scattering below 0 is taken", "core/scene.cpp",
           "!is_finite(scattering) || std::min({scattering.r, scattering.g, scattering.b}) < 0",
           "!is_finite(scattering)", "test_core", REFUSED),
    Mutant("an anisotropy of 1 is taken", "core/scene.cpp",
           "!(std::fabs(material.interior.anisotropy) <= PhaseFunction::most_anisotropy)",
           "!(std::fabs(material.interior.anisotropy) <= 1)", "test_core", REFUSED),
    Mutant("a furnace's media scatter nothing", "integrators/furnace.cpp",
           "if (has_flights_) way", "if (false) way", "test_integrators", FURNACE),
    Mutant("a camera in a body has no atmosphere around that", "integrators/camera_interiors.cpp",
           "StraightOn through(scene_, around_all());", "StraightOn through(scene_, {});",
           "test_integrators",
           AIR),
    Mutant("an atmosphere is left out where no shape has an inside", "integrators/camera_interiors.cpp",
           "if (bodies_.is_empty() && scene_.atmosphere == no_material) return;",
           "if (bodies_.is_empty()) return;",
           "test_integrators", AIR),
    Mutant("a path that a medium scatters first covers nothing", "integrators/path_reference.cpp",
           "alpha_record(end.is_beyond_scene(), has_environment_)",
           "alpha_record(end.hit.is_miss(), has_environment_)",
           "test_integrators", LAYERS),
    Mutant("light that media scatter backwards is glossy", "integrators/interaction.h",
           "return phase_ || to_local(wi).z < 0; }", "return to_local(wi).z < 0; }", "test_integrators",
           PARTS),
    Mutant("media scatter without limits", "integrators/scattering.cpp",
           "if (at.is_in_medium() || sample.wi.z < 0)", "if (sample.wi.z < 0)", "test_integrators", LIMITS),
    Mutant("pbrt's media scatter evenly", "io/pbrt/medium.cpp",
           "std::clamp(parameters.real(\"g\", 0, {-1, 1}), -most, most)",
           "0 * most * parameters.real(\"g\", 0, {-1, 1})",
           "test_io", READ),
    Mutant("a measured medium has no scale", "io/pbrt/medium.cpp",
           ".scattering = scale * (preset ? preset->scattering : scattering)}",
           ".scattering = preset ? preset->scattering : scale * scattering}", "test_io", READ),
    Mutant("the medium inside of pbrt's camera is around it", "io/pbrt/scene.cpp",
           "states_.now().medium_outside);\n        states_.name_camera",
           "states_.now().medium_inside);\n        states_.name_camera",
           "test_io", OUTSIDE),
    Mutant("what is outside of shapes around the camera is forgotten", "io/pbrt/builder.cpp",
           "if (size > largest && encloses(shape, camera_))", "if (size < 0)", "test_io", AROUND),
    Mutant("of several shapes around the camera the innermost has the atmosphere outside",
           "io/pbrt/builder.cpp",
           "medium = filling.outside, largest = size;", "medium = filling.outside;", "test_io", AROUND),
    Mutant("a point is in what a ray from it leaves and enters again", "io/encloses.cpp",
           "return crossings % 2 == 1;", "return crossings > 0;", "test_io", ENCLOSED),
    Mutant("extinctions that no float has distances for are none", "integrators/flight.cpp",
           "return own >= least_extinction ?", "return own > 0 ?",
           "test_integrators",
           THIN),
    Mutant("written pbrt: bodies lie in the atmosphere alone", "io/pbrt/writer_media.cpp",
           "is_direct ? around(some_point(own), shape) : atmosphere_",
           "is_direct ? atmosphere_ : atmosphere_",
           "test_io", LIES_IN),
    Mutant("written pbrt: the camera stands in no body", "io/pbrt/writer_media.cpp",
           "around(scene.camera.position, direct.end());", "atmosphere_;", "test_io", LIES_IN),
    Mutant("OpenPBR's clear surface absorbs less than nothing", "io/pbrt/material.cpp",
           "const float short_of = std::max(0.0f, -std::min({lost.r, lost.g, lost.b}));",
           "const float short_of = 0;",
           "test_io", OPENPBR),
    Mutant("a replay says of a medium's point that it has a cosine", "cli/replay/text.cpp",
           "  if (!at.is_in_medium())\n    text +=", "  if (at.point().offset >= 0)\n    text +=",
           "test_cli", REPLAYED),
    Mutant("a wave takes points in media for misses", "integrators/wave/media.cpp",
           "way.is_scattered ? Hit{.t = way.t_scattered(), .mesh = context_.medium()} : way.hit", "way.hit",
           "test_integrators", WAVES),
    Mutant("a wave's paths go on through the media that they are in", "integrators/wave/media.cpp",
           "  if (context_.has_flights) way.flight = wave_.flights[i];\n", "", "test_integrators", WAVES),
    Mutant("a wave's paths go on through the media that they come into", "integrators/wave/media.cpp",
           "if (context_.has_flights && !way.flight)", "if (false)", "test_integrators", WAVES),
    Mutant("a wave's rays end where they were needed", "integrators/wave/media.cpp",
           "    way.ray.t_max = std::numeric_limits<float>::infinity();\n", "", "test_integrators", WAVES),
    Mutant("a wave's paths in media keep the rays of those that end", "integrators/wave/path_ends.cpp",
           "wave_.rays[k] = wave_.rays[wave_.kept[k]]", "wave_.rays[k] = wave_.rays[k]", "test_integrators",
           WAVES),
    Mutant("lanes take points in media for surfaces, before patches", "integrators/wave/receivers-inl.h",
           "return select(receivers.is_in_medium, hn::Sqrt(dot(towards, towards)), cosine);",
           "return cosine;", "test_integrators", WAVES),
    Mutant("lanes take points in media for surfaces, before many lights",
           "integrators/wave/light_tree-inl.h",
           "select(receiver.is_in_medium, splat(1), dot(receiver.normal, direction))",
           "dot(receiver.normal, direction)", "test_integrators", MANY),
    Mutant("a wave shows no normal of media", "integrators/wave/layers.cpp",
           "is_in_medium(i) ? surfaces_.point.normal.at(i) : surfaces_.shading.at(i)",
           "surfaces_.shading.at(i)", "test_integrators", WAVES),
    Mutant("rays in media end before their paths do", "integrators/way.h",
           "t_beyond(ray, flight->reach(*medium))", "t_beyond(ray, 0.5f * flight->reach(*medium))",
           "test_integrators", SEARCHED),
    Mutant("a ray in a medium is a rounding too short", "integrators/medium_column.h",
           "1 + 0x1p-20f", "1", "test_integrators", BEYOND),
]
