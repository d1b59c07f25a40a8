# SPDX-License-Identifier: Apache-2.0
"""Sandbox, limits, and whether pictures are what they claim to be."""
from mutant import Mutant

PIXEL = "one pixel that was changed is found, and where it is"
SAME = "pictures are what their metadata say, in every format that keeps bits"
BESIDE = "what a picture says beside its command must be what that asks for"
CHANGED = "a scene that has changed since is named"
REFUSED = "pictures of which nothing can be said are refused, each with the reason"
WAYS = "no path of a scene leads out of its folder in a sandbox"
FILES = "a closed process opens, makes and removes no other file"
CALLS = "a closed process starts none, signals none and has no network, and its threads work"
MEMORY = "a render that needs more memory than it may have says so before it begins, or ends in an error"
TIME = "a time limit ends a render like a signal, also while it loads"

MUTANTS = [
    Mutant("pixels of all but the first channel are not compared", "cli/verify/picture_channels.cpp",
           "for (const Pair& pair : pairs) {", "for (const Pair& pair : {pairs.front()}) {",
           "test_cli", PIXEL),
    Mutant("a tile of a crop is looked for where it lies in the frame", "cli/verify/tile_check.cpp",
           "in_picture(tiles[i], window)", "tiles[i]", "test_cli", SAME),
    Mutant("denoised pixels are compared", "cli/verify/picture_channels.cpp",
           "if (is_denoised && channel_of(picture, noisy_name(name)) != absent) continue;", "",
           "test_cli", SAME),
    Mutant("a render that its noise ended goes on", "cli/verify/claim.cpp",
           "render.samples = claim.samples;", "", "test_cli", SAME),
    Mutant("costs are those of another engine", "cli/verify/command.cpp",
           "arguments.integrator == IntegratorKind::cost ||", "", "test_cli", SAME),
    Mutant("the seed that a picture says is not compared", "cli/verify/claim_check.cpp",
           '"twinray:seed", ', "", "test_cli", BESIDE),
    Mutant("any engine may have made a picture", "cli/verify/claim_check.cpp",
           "if (!arguments.is_auto && !is_among(engine, claim.engine))", "if (false)", "test_cli", BESIDE),
    Mutant("files are not looked at", "cli/verify/command.cpp",
           "if (!difference.empty()) throw", "if (false) throw", "test_cli", CHANGED),
    Mutant("a file more is none", "cli/input_files.cpp",
           "if (!files.contains(name))", "if (false)", "test_cli",
           "files are others where one has changed, is gone, or is new"),
    Mutant("pictures beside the picture are taken for it", "cli/verify/claim.cpp",
           '!shown.empty()', "false", "test_cli", REFUSED),
    Mutant("a tile may be chosen twice", "cli/verify/tile_check.cpp",
           "numbers[i + random() % (numbers.size() - i)]", "numbers[random() % numbers.size()]", "test_cli",
           "tiles are chosen by the seed, each once"),
    Mutant("files stay open", "cli/sandbox/sandbox.cpp",
           "if (!close_files(places))", "if (false)", "test_cli", WAYS),
    Mutant("all that lies beside the scene's folder is open", "cli/sandbox/render_sandbox.cpp",
           "places.push_back(folder_of(arguments.scene));",
           "places.push_back(folder_of(arguments.scene) + \"/..\");",
           "test_cli", WAYS),
    Mutant("all that lies above the program is open", "cli/sandbox/sandbox.cpp",
           'places{"/usr",', 'places{fs::read_symlink("/proc/self/exe").parent_path() / "..", "/usr",',
           "test_cli", "what lies above the program stays closed in a sandbox, too"),
    Mutant("the library of pictures is loaded too late", "cli/sandbox/sandbox.cpp",
           "  load_libraries();", "", "test_cli",
           "what lies above the program stays closed in a sandbox, too"),
    Mutant("the library that has Assimp is loaded too late", "cli/sandbox/sandbox.cpp",
           "  attempt(load_scene_importer);", "", "test_cli",
           "a scene that Assimp reads is read in a sandbox, where no process can be begun"),
    Mutant("what is written can be read", "cli/sandbox/files.cpp",
           "allow(rules.number(), place, writing & known)",
           "allow(rules.number(), place, (reading | writing) & known)",
           "test_cli", FILES),
    Mutant("files can be cut off", "cli/sandbox/files.cpp",
           "if (version >= 3) rights |= right_truncate;", "", "test_cli", FILES),
    Mutant("processes can be begun", "cli/sandbox/system_calls.cpp",
           'deny(filter, "clone3", ENOSYS);', "", "test_cli", CALLS),
    Mutant("the network stays open", "cli/sandbox/system_calls.cpp",
           "if (network == Network::closed)", "if (network != Network::closed)", "test_cli", CALLS),
    Mutant("a server in a sandbox has no network", "cli/sandbox/render_sandbox.cpp",
           "if (arguments.viewer || arguments.server)", "if (arguments.viewer)", "test_cli",
           "a page of the picture is served from a sandbox"),
    Mutant("pictures are verified outside of the sandbox", "cli/verify/command.cpp",
           "if (!asked.sandbox) return;", "return;", "test_cli",
           "a picture is verified in a sandbox, with a scene of the places that are named alone"),
    Mutant("a scene in a sandbox is not read where it is said to be now", "cli/verify/command.cpp",
           "{asked.picture, asked.scene}", "{asked.picture}", "test_cli",
           "a picture is verified in a sandbox, with a scene of the places that are named alone"),
    Mutant("a picture of another size is compared", "cli/verify/command.cpp",
           "picture.width != window.width() || picture.height != window.height()", "false", "test_cli",
           "another version is warned of, and another size is refused"),
    Mutant("gaps of a merged picture are none", "cli/verify/claim.cpp",
           "!missing.empty()", "false", "test_cli", REFUSED),
    Mutant("memory has no limit", "cli/options/limits.cpp",
           "if (limits.megabytes) limit_memory", "if (false) limit_memory", "test_cli", MEMORY),
    Mutant("what is left of the memory is not asked for", "core/memory.cpp",
           "tighten(limit, left_of_data(root),", "if (false) tighten(limit, left_of_data(root),",
           "test_cli", MEMORY),
    Mutant("time is not limited", "cli/options/limits.cpp",
           "if (limits.seconds) limit_time", "if (false) limit_time", "test_cli", TIME),
]
