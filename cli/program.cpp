// SPDX-License-Identifier: Apache-2.0
// The subcommands, each with its options and what is done with them.
#include "cli/program.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string_view>
#include <system_error>

#include "cli/compare/command.h"
#include "cli/convert_command.h"
#include "cli/crosscheck/agreement_command.h"
#include "cli/crosscheck/command.h"
#include "cli/cs184/program.h"
#include "cli/error/command.h"
#include "cli/film/film_keeper.h"
#include "cli/film/merge_command.h"
#include "cli/film/resume_command.h"
#include "cli/info_command.h"
#include "cli/interrupt.h"
#include "cli/options/options.h"
#include "cli/plan/command.h"
#include "cli/relight/command.h"
#include "cli/render_command.h"
#include "cli/render_command_line.h"
#include "cli/stats/command.h"
#include "cli/study/command.h"
#include "cli/verify/command.h"
#include "io/diagnostic.h"

namespace twinray {
namespace {

Action add_render(CLI::App& app) {
  return [read = add_render_options(app)](const Words& words) { return render_command(read(), words); };
}
Action add_agreement(CLI::App& app) {
  return [read = add_agreement_options(app)](const Words&) { return agreement_command(read()); };
}
Action add_crosscheck(CLI::App& app) {
  return [read = add_crosscheck_options(app)](const Words&) { return crosscheck_command(read()); };
}
Action add_error(CLI::App& app) {
  return [read = add_error_options(app)](const Words& words) { return error_command(read(), words); };
}
Action add_compare(CLI::App& app) {
  return [read = add_compare_options(app)](const Words& words) { return compare_command(read(), words); };
}
Action add_relight(CLI::App& app) {
  return [read = add_relight_options(app)](const Words& words) { return relight_command(read(), words); };
}
Action add_resume(CLI::App& app) {
  return [read = add_resume_options(app)](const Words& words) { return resume_command(read(), words); };
}
Action add_merge(CLI::App& app) {
  return [read = add_merge_options(app)](const Words&) { return merge_command(read()); };
}
Action add_plan(CLI::App& app) {
  return [read = add_plan_options(app)](const Words& words) { return plan_command(read(), words); };
}
Action add_stats(CLI::App& app) {
  return [read = add_stats_options(app)](const Words&) { return stats_command(read()); };
}
Action add_info(CLI::App& app) {
  return [read = add_info_options(app)](const Words&) { return info_command(read()); };
}
Action add_convert(CLI::App& app) {
  return [read = add_convert_options(app)](const Words&) { return convert_command(read()); };
}
Action add_study(CLI::App& app) {
  return [read = add_study_options(app)](const Words&) { return study_command(read()); };
}

Action add_verify(CLI::App& app) {
  return [read = add_verify_options(app)](const Words&) { return verify_command(read()); };
}

const std::vector<Subcommand> subcommands{
    {"render", add_render,
     "Renders a scene by path tracing; with --cs184 as CS184's program does (docs/cs184.md).", "Run",
     "Others: agreement compare convert crosscheck error info merge plan relight resume stats study "
     "verify"},
    {"agreement", add_agreement,
     "Renders scenes small by every engine, split method, integrator, sampler and number of threads,\n"
     "and compares all pictures and ray counts bit for bit. Exit code 1 if any differs."},
    {"compare", add_compare,
     "Compares two pictures: mean squared error, relative and signed, FLIP, and where they differ most.\n"
     "Measures of --fail-above: mse, rmse, relative-mse, flip (docs/compare.md)."},
    {"crosscheck", add_crosscheck,
     "Shoots the same rays through several engines and judges every difference."},
    {"error", add_error,
     "Renders a scene by several sets of options, and compares with a converged picture: error over samples\n"
     "and over CPU seconds, and whether pictures are biased (docs/error.md)."},
    {"relight", add_relight,
     "Mixes the lights of a picture anew, which was rendered with --layers=light-groups: each group's light\n"
     "times a number or a color (docs/layers.md)."},
    {"resume", add_resume,
     "Renders on from a checkpoint, by the options that it was begun with; threads, engine, outputs and the\n"
     "number of samples may be other ones (docs/films.md)."},
    {"merge", add_merge,
     "Puts the films of parts of a picture together, to the bits of one render: a picture, or a film again\n"
     "(docs/films.md)."},
    {"plan", add_plan,
     "Divides a picture, or the frames of a shot, among many machines: writes the jobs for Slurm, Open Job\n"
     "Description, or a list of commands, which render parts and merge them (docs/farm.md).",
     "Run", "", words_of_first_frame},
    {"stats", add_stats,
     "Builds every engine and split method over a scene and shoots the rays of its paths, recorded once,\n"
     "through each: build time, tree, and what camera, shadow and bounce rays take."},
    {"info", add_info,
     "Says what is in a scene: shapes, materials, lights with their power, pictures with their sizes, and "
     "the\n"
     "memory that a render of it takes (docs/scenes.md)."},
    {"study", add_study,
     "Makes the write-up of CS184's assignment from a folder of its scenes: one page with every picture, "
     "its\n"
     "command, times, rays per second, tests per ray and error. Goes on where it was stopped."},
    {"convert", add_convert,
     "Writes a scene for other programs, in the format that the ending of OUT says: pbrt-v4 (.pbrt), glTF\n"
     "(.gltf, .glb), or JSON for scripts (.json), with meshes and pictures in files beside it. Names what\n"
     "the format cannot say (docs/convert.md)."},
    {"verify", add_verify,
     "Renders some tiles of a picture again, by the command and the files that its metadata names, and says\n"
     "whether its pixels have the same bits (docs/unattended.md)."}};

bool is_subcommand(const std::string& word) {
  return std::any_of(subcommands.begin(), subcommands.end(),
                     [&](const Subcommand& subcommand) { return word == subcommand.name; });
}

/// Throws UsageError where the first word is no file, and almost a subcommand.
void check_command(const std::string& word) {
  std::error_code error;
  if (word.find_first_of("-./:") != word.npos || std::filesystem::exists(word, error)) return;
  std::vector<std::string_view> names;
  for (const Subcommand& subcommand : subcommands) names.push_back(subcommand.name);
  names.push_back("help");
  if (const std::string nearest = nearest_name(word, names); !nearest.empty())
    throw UsageError(
        fmt::format("there is no command {}, and no such file; did you mean {}?", word, nearest));
}

std::string usage_of(const std::string& name) {
  if (name == "render") return "twinray [render] SCENE.dae [options]; all options: twinray --help";
  if (name == "study")
    return "twinray study FOLDER --output DIR [options]; all options: twinray study --help";
  if (name == "convert")
    return "twinray convert SCENE.dae OUT.json|.pbrt|.gltf|.glb [options]; all options: twinray convert "
           "--help";
  if (name == "compare")
    return "twinray compare PICTURE REFERENCE [options]; all options: twinray compare --help";
  if (name == "relight") return "twinray relight PICTURE.exr [options]; all options: twinray relight --help";
  if (name == "resume") return "twinray resume FILE [options]; all options: twinray --help";
  if (name == "merge")
    return "twinray merge FILM... --output OUT [options]; all options: twinray merge --help";
  if (name == "verify") return "twinray verify PICTURE [options]; all options: twinray verify --help";
  if (name == "plan")
    return "twinray plan SCENE.dae --folder DIR --jobs N [options]; all options: twinray plan --help";
  const char* scene = name == "agreement" ? "[SCENE.dae]..." : "SCENE.dae";
  return fmt::format("twinray {0} {1} [options]; all options: twinray {0} --help", name, scene);
}

/// Without "help" in front: the options that say the same.
Words without_help(Words words) {
  std::error_code error;
  const bool is_help = !words.empty() && words.front() == "help" && !std::filesystem::exists("help", error);
  if (!is_help) return words;
  words.erase(words.begin());
  words.push_back("--help");
  return words;
}

/// Whether the same words can be said again after an interruption, and nothing is lost: a render's with a
/// checkpoint, and resume's.
bool can_be_tried_again(const Words& words) {
  if (words.empty()) return false;
  if (words.front() == "resume") return true;
  const bool is_of_render = words.front() == "render" || !is_subcommand(words.front());
  return is_of_render && !word_of_option(words, {"--checkpoint"}).empty();
}

}  // namespace

Invocation read_invocation(std::span<const char* const> arguments) {
  Invocation invocation;
  if (!arguments.empty()) {
    invocation.path = arguments.front();
    invocation.words.assign(arguments.begin() + 1, arguments.end());
  }
  Words& words = invocation.words;
  invocation.is_cs184 = std::filesystem::path(invocation.path).filename() == "pathtracer";
  if (!invocation.is_cs184 && (words.empty() || words.front() == "render" || !is_subcommand(words.front()))) {
    invocation.is_cs184 = std::erase(words, "--cs184") > 0;
    if (invocation.is_cs184) invocation.path += " --cs184";
    if (invocation.is_cs184 && !words.empty() && words.front() == "render") words.erase(words.begin());
  }
  invocation.name = invocation.is_cs184 ? "pathtracer" : "twinray";
  return invocation;
}

int run_program(const Invocation& invocation) {
  Words words = without_help(invocation.words);
  // Until the render has its own: options are to be understood first, and a film to be opened.
  std::optional<InterruptGuard> guard;
  if (can_be_tried_again(words)) guard.emplace(Words{}, try_again_code);
  if (invocation.is_cs184) return run_cs184(invocation.path, words);
  const bool is_of_render = words.empty() || !is_subcommand(words.front());
  if (is_of_render) words.insert(words.begin(), "render");
  try {
    if (is_of_render && words.size() > 1) check_command(words[1]);
    return run_subcommand(subcommands, words);
  } catch (const UsageError& error) {
    throw UsageError(fmt::format("{}\nusage: {}", error.what(), usage_of(words.front())));
  }
}

}  // namespace twinray
