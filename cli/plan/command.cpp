// SPDX-License-Identifier: Apache-2.0
#include "cli/plan/command.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <utility>

#include "cli/console.h"
#include "cli/film/saved_film.h"
#include "cli/json_names.h"
#include "cli/outputs.h"
#include "cli/render_command_line.h"
#include "cli/render_scene.h"
#include "cli/shell_text.h"
#include "io/output_file.h"
#include "io/picture/output_format.h"

namespace twinray {
namespace {

namespace fs = std::filesystem;

constexpr Range<std::uint32_t> job_counts{1, 100000};
/// In all: each is a line of the plan's list.
constexpr std::uint64_t most_parts = 1000000;
constexpr Range<double> minutes{0.01, 1e5};
constexpr Range<int> frame_numbers{0, 999999};
/// So long the machine is tried.
constexpr double pilot_seconds = 3;
const std::vector<std::string> plan_options{"--folder", "--jobs", "--part-minutes", "--frames"};

constexpr const char* writes_one_file =
    "all parts would write the same file; their films have samples, rays and seconds";
constexpr const char* shows_one_picture =
    "the parts of a plan are rendered many at a time; there is no growing picture to show";
/// Options of a render that its parts cannot have, and why.
constexpr std::pair<const char*, const char*> of_one_process[] = {{"--stats", writes_one_file},
                                                                  {"--metrics-file", writes_one_file},
                                                                  {"--serve", shows_one_picture},
                                                                  {"--tev", shows_one_picture}};

FrameRange parse_frames(const std::string& word) {
  const auto [first, last] = parse_range("--frames", word, frame_numbers, "1:100");
  if (first > last) throw UsageError(fmt::format("--frames: {} is more than {}", first, last));
  return {first, last};
}

void add_options(CLI::App& app, PlanArguments& arguments) {
  OptionGroup group(app, "Plan");
  group.add_word({"--folder", "DIR", "Where scripts, parts and logs go; it must not be there yet"},
                 arguments.folder);
  group.add_number({"--jobs", "N", "Parts of each frame"}, arguments.jobs, job_counts);
  group.add_number({"--part-minutes", "T", "Or as many that a part takes so long on this machine"},
                   arguments.part_minutes, minutes);
  group.add_flag("--by-tiles", arguments.by_tiles,
                 "Parts are ranges of tiles, not of samples: smaller films for many parts");
  group.add_words({"--frames", "FIRST:LAST", "Frames; %04d in the words of the render is their number"}, 1,
                  [&arguments](const Words& words) { arguments.frames = parse_frames(words[0]); });
}

void check(const PlanArguments& arguments) {
  const RenderArguments& render = arguments.render;
  if (arguments.folder.empty()) throw UsageError("--folder=DIR is missing");
  if (arguments.jobs.has_value() == arguments.part_minutes.has_value())
    throw UsageError("--jobs or --part-minutes is needed, and not both");
  const std::pair<const char*, bool> of_no_picture[] = {{"--replay", render.replay.has_value()},
                                                        {"--accel=check", render.check_with.has_value()},
                                                        {"--convert-textures", bool(render.convert_textures)},
                                                        {"--output=FILM", is_film_name(render.output)},
                                                        {"--checkpoint", !render.checkpoint.empty()}};
  for (const auto& [option, is_given] : of_no_picture)
    if (is_given)
      throw UsageError(fmt::format(
          "{}: a plan is for pictures alone, and makes films, checkpoints and their names itself", option));
  for (const auto& [option, why] : of_one_process)
    if (is_given(option, render)) throw UsageError(fmt::format("{}: {}", option, why));
  if (render.render.allocation == Allocation::error)
    throw UsageError("--allocation=error looks at the whole picture, which no part of a plan has");
  if (is_open_ended(render.render))
    throw UsageError(
        "a part has as many samples as the picture's others; --seconds, --until and --noise-target do not "
        "go with a plan");
}

/// The picture's name, with a place for the frame's number where there are frames.
std::string output_of(const PlanArguments& arguments, const Words& words) {
  const std::string given = word_of_option(words, output_options);
  const std::string output = given.empty() ? arguments.render.output : given;
  if (arguments.frames && !has_frame_number(output))
    throw UsageError(
        fmt::format("--frames: the picture's name needs a place for the number, as in \"%04d\"; {} "
                    "has none",
                    output));
  check_image_name(output);  // The last job alone would find out.
  if (output == "-") throw UsageError("--output=-: the last job of a plan writes its picture to a file");
  return output;
}

/// Frames of which the render's other words say nothing are the same picture.
void check_frames_differ(const PlanArguments& arguments, const Words& words) {
  const Words others = without_options(words, output_options);
  if (!arguments.frames || std::any_of(others.begin(), others.end(), has_frame_number)) return;
  const std::string same =
      "--frames: only the picture's name has a place for the number, so all frames are the same picture";
  if (arguments.render.load.strict) throw UsageError(same);
  console::warn(same);
}

/// Throws Error where a picture could not be written. The last job alone would find out.
void check_pictures(const FarmPlan& plan, const std::vector<std::string>& files) {
  for (std::uint32_t i = 0; i < plan.frame_count(); ++i) {
    const std::string picture =
        plan.frames ? with_frame_number(plan.output, plan.frames->first + int(i)) : plan.output;
    check_outputs({picture});
    check_not_read({picture}, files);
  }
}

void check_size(const FarmPlan& plan) {
  if (std::uint64_t(plan.parts) * plan.frame_count() > most_parts)
    throw Error(fmt::format("{} frames in {} parts each are more than the {} parts that a plan may have",
                            plan.frame_count(), plan.parts, most_parts));
}

/// Seconds of the whole picture on this machine, by a few samples of it.
double pilot(const RenderArguments& arguments, const LoadedScene& loaded) {
  RenderOptions options = arguments.render;
  options.adaptive.reset();  // The most that it may take.
  options.seconds = pilot_seconds;
  options.samples = Film::max_samples;
  const auto integrator = make_integrator(arguments, loaded.scene);
  const auto accelerator = build_accelerator(arguments.backend, loaded.scene.geometry, arguments.build);
  const RenderResult result = render(loaded.scene, *accelerator, *integrator, options);
  return result.seconds / result.samples * arguments.render.samples;
}

std::string program_path() {
  std::error_code error;
  return fs::read_symlink("/proc/self/exe", error).string();
}

/// Those that the job, and the films of its parts, are to keep.
void check_names(const FarmPlan& plan, const std::vector<std::string>& files) {
  check_json_names({plan.folder}, "a job's template");
  for (const char* part : {"\n", "{{"})
    if (plan.folder.find(part) != plan.folder.npos)
      throw Error(
          fmt::format("--folder: a line's end ends a command of a list, and {{{{ begins a word of a "
                      "job's template; {} has one of them",
                      shell_text({plan.folder})));
  check_json_names(plan.words, "a film");
  check_json_names(files, "a film");
}

/// What is written into the plan's folder: scripts with the mode of such.
struct PlanFile {
  std::string name, text;
  bool is_script = false;
};

Error is_there(const std::string& folder) {
  return Error(fmt::format("{}: it is there already; a plan needs a folder of its own", folder));
}

/// A new folder, with those that it lies in. Unless it is kept, it goes with all that is in it, and so do new
/// ones around it in which nothing else is.
class NewFolder {
 public:
  explicit NewFolder(const fs::path& path) : path_(path.has_filename() ? path : path.parent_path()) {
    std::error_code error;
    for (fs::path outer = path_.parent_path(); outer.has_relative_path() && !fs::exists(outer, error);
         outer = outer.parent_path())
      outer_.push_back(outer);
  }
  ~NewFolder() {
    std::error_code error;
    if (is_kept_) return;
    if (is_made_) fs::remove_all(path_, error);
    for (const fs::path& outer : outer_) fs::remove(outer, error);
  }
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;
  /// Throws Error where it cannot be made, or is there.
  void make() {
    std::error_code error;
    fs::create_directories(path_.parent_path(), error);
    if (!error) is_made_ = fs::create_directory(path_, error);
    if (error)
      throw Error(fmt::format("{}: this folder cannot be made: {}", path_.string(), error.message()));
    if (!is_made_) throw is_there(path_.string());
  }
  void keep() { is_kept_ = true; }

 private:
  fs::path path_;
  std::vector<fs::path> outer_;  ///< Those that are not there yet, the innermost first.
  bool is_made_ = false, is_kept_ = false;
};

/// Where not all of it can be written nothing of it stays, so that it can be tried again.
void write(const FarmPlan& plan) {
  const fs::path folder = plan.folder;
  NewFolder made(folder);
  made.make();
  std::error_code error;
  for (const char* inner : {"parts", "logs", "slurm", "openjd"})
    if (fs::create_directory(folder / inner, error); error)
      throw Error(fmt::format("{}: this folder cannot be made: {}", plan.folder, error.message()));
  const PlanFile files[] = {{"render-part", render_script(plan), true},
                            {"merge-parts", merge_script(plan), true},
                            {"commands.txt", command_list(plan)},
                            {"slurm/render.sbatch", slurm_render_job(plan)},
                            {"slurm/merge.sbatch", slurm_merge_job(plan)},
                            {"slurm/submit", slurm_submit_script(plan), true},
                            {"openjd/template.json", open_job_template(plan)}};
  for (const auto& [name, text, is_script] : files) {
    write_file((folder / name).string(), text);
    if (is_script)
      fs::permissions(folder / name, fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec,
                      fs::perm_options::add);
  }
  made.keep();
}

std::string time_of_part(double seconds) {
  return seconds < 60 ? fmt::format("{:.1f} seconds", seconds) : fmt::format("{:.1f} minutes", seconds / 60);
}

void say(const FarmPlan& plan, const std::optional<double>& seconds) {
  const std::string folder = shell_text({plan.folder});
  console::print("Plan           {} {} in {} {}{}\n", plan.units, plan.is_by_tiles ? "tiles" : "samples",
                 plan.parts, plan.parts == 1 ? "part" : "parts",
                 plan.frames ? fmt::format(", for each of {} frames", plan.frame_count()) : "");
  if (seconds)
    console::print("A part         {} on a machine as this one\n", time_of_part(*seconds / plan.parts));
  console::print("Here           parallel -j1 < {0}/commands.txt && {0}/merge-parts\n", folder);
  console::print("Slurm          {}/slurm/submit --time=60\n", folder);
  console::print("OpenJD         openjd run {}/openjd/template.json\n", folder);
}

/// Whatever a job engine may take amiss becomes a dash.
std::string job_name(const std::string& scene) {
  std::string name = "twinray-" + fs::path(scene).stem().string();
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '_') c = '-';
  return name;
}

}  // namespace

Words words_of_first_frame(const Words& words) {
  const std::string frames = word_of_option(words, {"--frames"});
  if (frames.empty()) return words;
  const int first = parse_frames(frames).first;
  Words read = words;
  for (std::string& word : read) word = with_frame_number(word, first);
  return read;
}

std::function<PlanArguments()> add_plan_options(CLI::App& app) {
  const auto arguments = std::make_shared<PlanArguments>();
  add_options(app, *arguments);
  return [arguments, read = add_render_options(app)] {
    arguments->render = read();
    check(*arguments);
    return *arguments;
  };
}

int plan_command(const PlanArguments& arguments, const Words& words) {
  const std::string folder = word_of_option(words, {"--folder"});
  if (fs::exists(folder)) throw is_there(folder);
  FarmPlan plan;
  plan.output = output_of(arguments, words);
  plan.words = without_options(without_options(words, plan_options), output_options);
  std::erase(plan.words, "--by-tiles");
  plan.frames = arguments.frames;
  RenderArguments render = arguments.render;
  render.quiet = true;
  render.load.files = std::make_shared<std::vector<std::string>>();
  RenderTalk nobody;
  const LoadedScene loaded = load_for_render(render, nobody);
  choose_engine(*loaded.scene.geometry, render);
  plan.name = job_name(render.scene);
  plan.program = program_path();
  plan.called_in = fs::current_path().string();
  plan.folder = fs::absolute(folder).lexically_normal().string();
  plan.samples = render.render.samples;
  plan.is_by_tiles = arguments.by_tiles || render.render.adaptive.has_value();
  plan.units = plan.is_by_tiles ? tile_grid(window_of(render.render), tile_size).count() : plan.samples;
  check_names(plan, *render.load.files);
  check_pictures(plan, *render.load.files);
  std::optional<double> seconds;
  if (arguments.part_minutes) seconds = pilot(render, loaded);
  const double wanted = seconds ? std::ceil(*seconds / (60 * *arguments.part_minutes)) : *arguments.jobs;
  plan.parts = std::uint32_t(std::clamp(wanted, 1.0, double(plan.units)));
  check_size(plan);
  check_frames_differ(arguments, words);
  write(plan);
  if (!arguments.render.quiet) say(plan, seconds);
  return 0;
}

}  // namespace twinray
