// SPDX-License-Identifier: Apache-2.0
#include "cli/crosscheck/agreement_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <utility>

#include "cli/console.h"
#include "cli/options/options.h"
#include "cli/progress.h"
#include "core/error.h"
#include "io/scene_file.h"

namespace twinray {
namespace {

namespace fs = std::filesystem;

struct SceneFile {
  std::string label, path;
};

struct Row {
  std::string label;
  SceneAgreement found;
};

void add(const SceneAgreement& part, SceneAgreement& sum) {
  sum.renders += part.renders;
  sum.pixels += part.pixels;
  sum.rays += part.rays;
  sum.brute_force_pixels = part.brute_force_pixels;
  sum.differences.insert(sum.differences.end(), part.differences.begin(), part.differences.end());
}

/// All scene files of a folder, in the order of their names; labels are relative to `top`.
template <typename Iterator>
std::vector<SceneFile> scene_files(const fs::path& folder, const fs::path& top) {
  std::vector<SceneFile> files;
  if (folder.empty() || !fs::is_directory(folder)) return files;
  for (const fs::directory_entry& entry : Iterator(folder)) {
    if (entry.is_regular_file() && is_scene_file(entry.path().string()))
      files.push_back({entry.path().lexically_relative(top).string(), entry.path().string()});
  }
  std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return a.label < b.label; });
  return files;
}

/// Where the well-known scenes are: the environment's TWINRAY_SCENES, else the build's, else where
/// scenes/fetch puts them.
fs::path well_known_folder() {
  if (const char* chosen = std::getenv("TWINRAY_SCENES"); chosen && *chosen) {
    if (!fs::is_directory(chosen)) throw Error(fmt::format("TWINRAY_SCENES is not a folder: {}", chosen));
    return chosen;
  }
  const fs::path of_build = TWINRAY_SCENES;
  return of_build.empty() ? fs::path(TWINRAY_OWN_SCENES) / "well-known" : of_build;
}

std::vector<SceneFile> chosen_scenes(const std::vector<std::string>& named) {
  std::vector<SceneFile> files;
  for (const std::string& path : named) files.push_back({path, path});
  if (!named.empty()) return files;
  const fs::path own = TWINRAY_OWN_SCENES, well_known = well_known_folder();
  files = scene_files<fs::directory_iterator>(own, own.parent_path());
  for (SceneFile& file : scene_files<fs::recursive_directory_iterator>(well_known, well_known))
    files.push_back(std::move(file));
  if (files.empty()) throw Error(fmt::format("there is no scene in {}; name one", own.string()));
  return files;
}

/// The scene as its file's camera sees it, or all of it.
Scene seen_as(Scene scene, View view, const AgreementOptions& options) {
  scene.camera = camera_of(scene, view, options.width, options.height);
  return scene;
}

std::vector<Row> compare_all(const std::vector<SceneFile>& files, const AgreementArguments& arguments) {
  std::vector<Row> rows;
  ProgressLine line = progress_line(!arguments.quiet);
  for (const SceneFile& file : files) {
    const Scene scene = load_with_warnings(file.path).scene;
    SceneAgreement found;
    for (const View view : arguments.views) {
      const auto progress = [&](std::size_t done, std::size_t all) {
        line.show(fmt::format("scene {} of {} | {}, view {} | {} of {} renders", rows.size() + 1,
                              files.size(), file.label, view_name(view), done, all));
      };
      SceneAgreement part =
          compare_engines(seen_as(scene, view, arguments.options), arguments.options, progress);
      for (std::string& difference : part.differences)
        difference = fmt::format("view {}, {}", view_name(view), difference);
      add(part, found);
    }
    rows.push_back({file.label, std::move(found)});
  }
  line.finish();
  return rows;
}

void print_table(const std::vector<Row>& rows, const AgreementOptions& options) {
  std::size_t widest = 5;
  for (const Row& row : rows) widest = std::max(widest, row.label.size());
  console::print("{:{}}  {:>7}  {:>9}  {:>11}  {:>11}  {:>9}\n", "scene", widest, "renders", "pixels", "rays",
                 "brute force", "different");
  for (const Row& row : rows) {
    const SceneAgreement& found = row.found;
    console::print("{:{}}  {:>7}  {:>9}  {:>11}  {:>8} px  {:>9}  {}\n", row.label, widest, found.renders,
                   found.pixels, found.rays, found.brute_force_pixels, found.differences.size(),
                   found.differences.empty() ? "same bits" : "NOT THE SAME");
  }
  console::print(
      "Each picture has {} x {} pixels, {} samples each; of large scenes brute force renders the middle.\n",
      options.width, options.height, options.samples);
}

/// Prints which renders differ, and the verdict; whether all agree.
bool print_verdict(const std::vector<Row>& rows) {
  std::size_t renders = 0, different = 0;
  std::uint64_t rays = 0;
  for (const Row& row : rows) {
    renders += row.found.renders;
    rays += row.found.rays;
    different += row.found.differences.size();
    for (const std::string& difference : row.found.differences)
      console::print("{}: {}\n", row.label, difference);
  }
  const std::string what = fmt::format("{} renders of {} scenes ({} rays)", renders, rows.size(), rays);
  if (different == 0)
    console::print("{}: all the same, bit for bit\n", what);
  else
    console::print("{}: {} differ\n", what, different);
  return different == 0;
}

/// The options as they are read.
struct AgreementRequest {
  AgreementArguments arguments;
  bool plant_difference = false;
};

void add_options(CLI::App& app, AgreementRequest& request) {
  AgreementArguments& arguments = request.arguments;
  AgreementOptions& options = arguments.options;
  add_scenes(app, arguments.scenes,
             "Scene files; without any, all of the source tree and of the folder\nTWINRAY_SCENES");
  OptionGroup group(app, "Options");
  add_resolution(group, options.width, options.height, "Width and height in pixels");
  group.add_number({"-s,--samples", "N", "Samples per pixel"}, options.samples, sample_counts);
  group.add_number({"--seed", "N", "Another seed, other rays"}, options.seed, seeds);
  group.add_choice<std::vector<View>>(
      "--view", arguments.views,
      {{"file", {View::file}}, {"whole", {View::whole}}, {"both", {View::file, View::whole}}},
      "As the file's camera sees it, all of it, or both");
  group.add_flag("--plant-difference", request.plant_difference,
                 "Add an engine with another triangle test: the command must then fail");
  group.add_flag("-q,--quiet", arguments.quiet, "Print the verdict only, and what differs");
}

}  // namespace

std::function<AgreementArguments()> add_agreement_options(CLI::App& app) {
  const auto request = std::make_shared<AgreementRequest>();
  add_options(app, *request);
  return [request] {
    AgreementArguments arguments = request->arguments;
    if (request->plant_difference) arguments.options.engines.push_back(differing_engine());
    return arguments;
  };
}

int agreement_command(const AgreementArguments& arguments) {
  const std::vector<Row> rows = compare_all(chosen_scenes(arguments.scenes), arguments);
  if (!arguments.quiet) print_table(rows, arguments.options);
  return print_verdict(rows) ? 0 : 1;
}

}  // namespace twinray
