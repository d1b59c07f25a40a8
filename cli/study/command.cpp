// SPDX-License-Identifier: Apache-2.0
#include "cli/study/command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <memory>
#include <set>

#include "cli/console.h"
#include "cli/interrupt.h"
#include "cli/options/common.h"
#include "cli/study/notes.h"
#include "cli/study/page.h"
#include "cli/study/picture_folder.h"
#include "cli/study/plan.h"
#include "core/error.h"
#include "io/output_file.h"

namespace twinray {
namespace {

namespace fs = std::filesystem;

/// The options as they are read.
struct StudyRequest {
  StudyArguments arguments;
  bool is_quick = false, is_full = false;
  std::vector<int> resolution;  ///< Empty: that of the scale.
};

void add_options(CLI::App& app, StudyRequest& request) {
  StudyArguments& arguments = request.arguments;
  add_folder(app, arguments.scenes, "The folder of the scenes (.dae), with the folders below it");
  OptionGroup group(app, "Options");
  group.add_word({"-o,--output", "DIR", "Where page and pictures go; what is there already stays"},
                 arguments.output);
  group.add_flag("--quick", request.is_quick, "Half a minute on two cores: small pictures, few samples");
  group.add_flag("--full", request.is_full, "As in the write-ups: 480 x 360 pixels, up to 2048 samples");
  group.add_numbers({"-r,--resolution", "W H", "Width and height in pixels (by the scale)"}, 2,
                    request.resolution, frame_sides);
  group.add_word({"--notes", "FILE.md", "Words to put beside the pictures, in Markdown"}, arguments.notes);
  add_threads(group, arguments.threads);
  group.add_flag("-q,--quiet", arguments.quiet, "Print errors and warnings only");
}

StudyArguments resolved(const StudyRequest& request) {
  StudyArguments arguments = request.arguments;
  if (arguments.output.empty())
    throw UsageError("--output is missing: the folder that page and pictures go to");
  if (request.is_quick && request.is_full) throw UsageError("--quick and --full exclude each other");
  if (request.is_quick) arguments.scale = study::quick;
  if (request.is_full) arguments.scale = study::full;
  if (!request.resolution.empty()) {
    arguments.scale.width = request.resolution[0];
    arguments.scale.height = request.resolution[1];
  }
  return arguments;
}

void make_folder(const std::string& path) {
  std::error_code error, no_status;
  fs::create_directory(path, error);
  if (!fs::is_directory(path, no_status))
    throw Error(fmt::format("{}: this folder cannot be made: {}", path,
                            fs::exists(path, no_status) ? "there is a file of that name" : error.message()));
}

/// What the user must know of the scenes, once.
void name_scenes(const study::SceneFolder& folder, const std::vector<study::Part>& parts) {
  for (const study::UnreadableScene& scene : folder.unreadable)
    console::warn(fmt::format("{}: left out, for it cannot be read:\n{}", scene.path, scene.reason));
  for (const study::Part& part : parts)
    if (!part.missing.empty())
      console::warn(
          fmt::format("part {}: not in {}: {}", part.number, folder.path, fmt::join(part.missing, ", ")));
}

/// Makes what is not there yet, part by part; the page shows what there is after each.
class Maker {
 public:
  Maker(const StudyArguments& arguments, const study::Study& study)
      : arguments_(arguments), study_(study), page_(arguments.output + "/index.html") {
    for (const study::Part& part : study.parts)
      for (const study::Picture& picture : pictures_of(part)) names_.insert(picture.name);
  }

  int make_all() {
    name_outdated();
    for (const study::Part& part : study_.parts) {
      for (const study::Picture& picture : pictures_of(part))
        if (const int code = make(picture); code != 0) return code;
      write_page();
    }
    if (!arguments_.quiet)
      console::print("{} of {} pictures were there already\nPage           {}\n", kept_, names_.size(),
                     page_);
    return 0;
  }

 private:
  /// Why pictures that are there are made again.
  void name_outdated() const {
    std::set<std::string> outdated;
    for (const study::Part& part : study_.parts)
      for (const study::Picture& picture : pictures_of(part))
        if (study_.pictures.is_outdated(picture)) outdated.insert(picture.name);
    if (!outdated.empty() && !arguments_.quiet)
      console::print(
          "{} of {} pictures are there, but are made again: their command (with -t, -r and the scale), their "
          "scene or the program was another\n",
          outdated.size(), names_.size());
  }
  int make(const study::Picture& picture) {
    if (!done_.insert(picture.name).second) return 0;
    if (study_.pictures.finished(picture)) {
      ++kept_;
      return 0;
    }
    if (const int code = study_.pictures.make(picture); code != 0) return code;
    if (const auto record = study_.pictures.finished(picture); record && !arguments_.quiet)
      console::print("{:>4} of {}  {}  {}\n", done_.size(), names_.size(), picture.name,
                     study::seconds_text(record->render_seconds));
    return 0;
  }
  void write_page() const {
    const InterruptGuard guard({page_});
    write_file(page_, study::study_page(study_));
  }

  const StudyArguments& arguments_;
  const study::Study& study_;
  std::string page_;
  std::set<std::string> names_, done_;
  std::size_t kept_ = 0;
};

}  // namespace

std::function<StudyArguments()> add_study_options(CLI::App& app) {
  const auto request = std::make_shared<StudyRequest>();
  add_options(app, *request);
  return [request] { return resolved(*request); };
}

int study_command(const StudyArguments& arguments) {
  const study::Notes notes = arguments.notes.empty() ? study::Notes{} : study::read_notes(arguments.notes);
  for (const std::string& warning : notes.warnings) console::warn(warning);
  const study::SceneFolder folder = study::read_scene_folder(arguments.scenes);
  make_folder(arguments.output);
  make_folder(arguments.output + "/pictures");
  check_outputs({arguments.output + "/index.html"});
  const std::vector<study::Part> parts = study::plan_study({folder, arguments.scale});
  name_scenes(folder, parts);
  const study::PictureFolder pictures(arguments.output + "/pictures", arguments.scale, arguments.threads);
  const study::Study study{folder, arguments.scale, parts, notes, pictures};
  if (const int code = Maker(arguments, study).make_all(); code != 0) return code;
  return folder.unreadable.empty() ? 0 : 1;
}

}  // namespace twinray
