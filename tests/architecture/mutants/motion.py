# SPDX-License-Identifier: Apache-2.0
"""Defects of what moves while the shutter is open."""
from mutant import Mutant

TIMES = "of any aligned block of moments one lies in each part of the shutter's time"
SEEDS = "over many seeds a moment is at any time of the shutter as likely"
STILL = "each moment's samples are those that its still scene has"
GOES_ON = "a picture of motion that goes on has the bits of one that was made at once"
TARGET = "no noise target is reached by the samples of few moments"
REFUSED = "motion goes with as many samples of each pixel, and a moment has a sample at least"
TURNS = "a rotation's quaternion is the rotation again, through every angle and about every axis"
SHORTER = "between two rotations the shorter way is taken evenly"
BETWEEN = "transforms are stretched, turned and moved evenly from one to the other"
SIZES = "size and mirrors do not matter to what is in between"
FLAT = "where a transform flattens, its numbers change evenly"
SHAPES = "pbrt's shapes move evenly from where they begin, and stand before and after"
UNDONE = "what pbrt's file undoes for both ends stands still"
CAMERA = "pbrt's camera moves in the world, and so does its space"
SHUTTER = "the shutter of pbrt's camera is told where something moves, and only there"
CLOSED = "a shutter of pbrt's that closes before it opens, or at once, is an error"
ENGINES = "a picture of motion has the same bits by every engine, on any number of threads"
VERIFIED = "a picture of motion is verified"
REPLAYED = "each sample is replayed at its own moment"
OWN = "a file's own shutter is told, and gives way to a time"
NEEDS = "what needs a still scene says so of motion"
WORDS = "a time is one moment, or two and samples of each, and nothing else"
OPENS = "without a time pbrt's scene is that of the moment at which the shutter opens"
CHANGED = "a scene whose file changes while it is rendered is an error, with its time"
USUAL = "each sample sees its own moment, but where reading and building a scene takes long"
HANDED = "where a moment cannot be had, the samples before it are handed over"
FAILED = "a render that fails at a later moment leaves its samples in the checkpoint"
KNOWN = "known pictures are read once for each use of them"
CAMERAS = "a camera that is not the file's stays while the scene moves"

MUTANTS = [
    Mutant("moments are in the order of time", "integrators/motion.cpp",
           "<< (31 - i)", "<< i", "test_integrators", TIMES),
    Mutant("all seeds have the same moments", "integrators/motion.cpp",
           "mix(seed * hash_step", "mix(0 * seed", "test_integrators", SEEDS),
    Mutant("a moment has one sample more", "integrators/motion.h",
           "(moment_of(sample) + 1) * samples_per_moment", "(moment_of(sample) + 1) * samples_per_moment + 1",
           "test_integrators", STILL),
    Mutant("the first moment stays", "integrators/render.cpp",
           "if (maker_ && moment == moment_) return;", "if (maker_) return;", "test_integrators", STILL),
    Mutant("a render that goes on begins with the first moment", "integrators/render.cpp",
           "stand_or_fail(options_.motion->moment_of(begin));",
           "stand_or_fail(options_.motion->moment_of(begin - state_.samples));",
           "test_integrators", GOES_ON),
    Mutant("a noise target counts samples of the same moment", "integrators/render.cpp",
           "samples / alike < least_samples_of_target", "samples < least_samples_of_target",
           "test_integrators", TARGET),
    Mutant("what moves has its samples spread", "integrators/render_options.cpp",
           "options.motion && options.allocation == Allocation::error", "false", "test_integrators", REFUSED),
    Mutant("what moves is sampled adaptively", "integrators/render_options.cpp",
           "options.motion && options.adaptive", "false && options.adaptive", "test_integrators", REFUSED),
    Mutant("a quaternion's signs are those of the transpose", "core/quaternion.cpp",
           "xw = m[2][1] - m[1][2]", "xw = m[1][2] - m[2][1]", "test_core", TURNS),
    Mutant("a half turn has no axis", "core/quaternion.cpp",
           "return unit(multiples[largest]);", "return unit(multiples[3]);", "test_core", TURNS),
    Mutant("rotations are mixed, not turned", "core/quaternion.cpp",
           "if (!(cosine < nearly_one))", "if (true)", "test_core", SHORTER),
    Mutant("what is in between is not stretched by both", "core/quaternion.cpp",
           "sum_of(a->stretch, b->stretch, 1 - t, t)", "a->stretch", "test_core", BETWEEN),
    Mutant("what is in between is not moved", "core/quaternion.cpp",
           "result.m[row][3] = between.m[row][3];", "result.m[row][3] = from.m[row][3];",
           "test_core", BETWEEN),
    Mutant("a mirror is taken for a rotation", "core/quaternion.cpp",
           "linear.determinant() < 0 ? -1 : 1", "linear.determinant() < 0 ? 1 : 1", "test_core", SIZES),
    Mutant("what is large is turned a little", "core/quaternion.cpp",
           "most_steps = 60", "most_steps = 2", "test_core", BETWEEN),
    Mutant("what flattens stays until the end", "core/quaternion.cpp",
           "if (!a || !b) return between;", "if (!a || !b) return from;", "test_core", FLAT),
    Mutant("what moves in pbrt's file goes on after its end", "io/pbrt/state.cpp",
           "*time_ < last_ ?", "true ?", "test_io", SHAPES),
    Mutant("pbrt's motion begins at 0", "io/pbrt/state.cpp",
           "(*time_ - first_) / (last_ - first_)", "*time_ / (last_ - first_)", "test_io", SHAPES),
    Mutant("pbrt's end moves the beginning", "io/pbrt/state.cpp",
           "if (now_.is_start_active) motion.start", "if (true) motion.start", "test_io", SHAPES),
    Mutant("what has moved in pbrt's file moves on", "io/pbrt/state.cpp",
           "if (motion.start == motion.end) {", "if (false) {", "test_io", SHUTTER),
    Mutant("what is placed in pbrt's file moves, or has moved", "io/pbrt/state.h",
           "moves_ = moves_ || now_.space.motion;", "moves_ = now_.space.motion.has_value();",
           "test_io", SHUTTER),
    Mutant("a named space of pbrt's stands still", "io/pbrt/state.cpp",
           "systems_[statement.words[0]] = now_.space;",
           "systems_[statement.words[0]] = {(now_.space.motion ? now_.space.motion->start : "
           "now_.space.transform), {}};",
           "test_io", UNDONE),
    Mutant("pbrt's camera moves by the inverse way", "io/pbrt/state.cpp",
           "interpolated(*start, *end, part())",
           "interpolated(space.motion->start, space.motion->end, part()).inverse()",
           "test_io", CAMERA),
    Mutant("pbrt's scene without a time is that of the beginning", "io/pbrt/scene.cpp",
           "states_.open_shutter(camera_.shutter.open);", "states_.open_shutter(0 * camera_.shutter.open);",
           "test_io", OPENS),
    Mutant("all scenes have as many samples of a moment", "cli/shutter.cpp",
           "<= few_primitives ? 1 : 4", "<= few_primitives ? 1 : 1", "test_cli", USUAL),
    Mutant("a scene may change while it is rendered", "cli/moving_scene.cpp",
           "if (state_of(file.path) != file)", "if (false)", "test_cli", CHANGED),
    Mutant("pbrt's shutter may close before it opens", "io/pbrt/camera.cpp",
           "if (!(open < close))", "if (open == close)", "test_io", CLOSED),
    Mutant("a picture of motion is verified by a still one", "cli/verify/tile_check.cpp",
           "arguments.shutter ? render_motion(arguments, loaded, tiles)",
           "false ? render_motion(arguments, loaded, tiles)", "test_cli", VERIFIED),
    Mutant("moments are verified by the first one", "cli/verify/tile_check.cpp",
           "moving.of_sample(begin)", "moving.of_sample(0 * begin)", "test_cli", VERIFIED),
    Mutant("a render that fails at a moment keeps nothing", "integrators/render.cpp",
           "if (options_.failed) at_present(options_.failed);", "", "test_integrators", HANDED),
    Mutant("no checkpoint of a render that fails", "cli/render_keeping.cpp",
           "if (keeper_->save(state)) talk_.checkpointed();\n    };", "};", "test_cli", FAILED),
    Mutant("a space that was named before the shutter opens stays", "io/pbrt/state.cpp",
           "move(*space.motion);  // It", "now_.space = space;  // It", "test_io", OPENS),
    Mutant("all samples are replayed at one moment", "cli/moving_scene.cpp",
           "shutter_part(sample / arguments", "shutter_part(0 * sample / arguments", "test_cli", REPLAYED),
    Mutant("the shutter opens when it closes", "cli/options/camera.cpp",
           "arguments.shutter = {*arguments.load.time, parse_number(\"--time\", end, moments)};",
           "arguments.shutter = {*arguments.load.time, *arguments.load.time + 1};",
           "test_cli", WORDS),
    Mutant("samples of a moment are asked for in vain", "cli/options/camera.cpp",
           "arguments.samples_per_moment = parse_number(\"--time\", samples, sample_counts);",
           "parse_number(\"--time\", samples, sample_counts);", "test_cli", WORDS),
    Mutant("a file's shutter is open at any time", "cli/shutter.cpp",
           "if (arguments.load.time) return arguments.shutter;",
           "if (arguments.shutter) return arguments.shutter;", "test_cli", OWN),
    Mutant("convert says nothing of motion", "cli/convert_command.cpp",
           "if (loaded.defaults.shutter && ", "if (false && ", "test_cli", OWN),
    Mutant("a shutter and an adaptive picture agree", "cli/render_command_line.cpp",
           "  check_shutter(arguments);\n", "", "test_cli", NEEDS),
    Mutant("normal maps that are missing are magenta", "io/picture/known_pictures.h",
           "meaning.channels, is_normal_map);", "meaning.channels, false);", "test_io", KNOWN),
    Mutant("the default camera follows what moves", "cli/render_scene.cpp",
           "return !summary.camera.empty() && ", "return ", "test_cli", CAMERAS),
    Mutant("pbrt's subdivided surfaces are outside in", "io/pbrt/mesh.cpp",
           "normal = -normal;", "normal = normal * 1;", "test_io",
           "loopsubdiv is divided as often as it says, and its vertices are on the limit surface"),
    Mutant("pbrt's dots have what is called inside", "io/pbrt/texture.cpp",
           "DotsTexture{outside.index, inside.index,", "DotsTexture{inside.index, outside.index,", "test_io",
           "corners are mixed over the unit square, and dots lie on another texture"),
    Mutant("a shape between the same media of pbrt's is filled", "io/pbrt/builder.cpp",
           "divides_media = state.medium_inside != state.medium_outside", "divides_media = true", "test_io",
           "a shape with the same medium on both sides divides nothing, as in pbrt"),
    Mutant("cubes of pbrt's have a mapping", "io/pbrt/texture.cpp",
           "  if (parameters.integer(\"dimension\", 2, {2, 3}) == 3)\n",
           "  read_mapping(statement);\n  if (parameters.integer(\"dimension\", 2, {2, 3}) == 3)\n",
           "test_io", "parameters that a mapping has not are unused"),
    Mutant("pbrt's tangents are not told of", "io/pbrt/mesh.cpp",
           "parameters.find(\"S\"))", "parameters.find(\"S\"); false)", "test_io",
           "tangents of a pbrt mesh are named, since they are not rendered"),
]
