// SPDX-License-Identifier: Apache-2.0
#include "cli/film/resume_command.h"

#include <filesystem>
#include <memory>

#include "cli/console.h"
#include "cli/film/saved_film.h"
#include "cli/render_command.h"
#include "cli/render_command_line.h"
#include "io/generated/generated.h"

namespace twinray {
namespace {

void check_scene(const RenderArguments& arguments, const FilmNotes& notes) {
  std::error_code error;
  if (generated::is_generated(arguments.scene) || std::filesystem::exists(arguments.scene, error)) return;
  throw Error(
      fmt::format("{}: there is no such file; the render was begun in {}", arguments.scene, notes.folder));
}

}  // namespace

std::function<std::string()> add_resume_options(CLI::App& app) {
  const auto file = std::make_shared<std::string>();
  add_file(app, "FILE", *file,
           "A checkpoint, or another film that is not done; options of render may follow");
  leave_other_words(app);
  return [file] { return *file; };
}

int resume_command(const std::string& file, const Words& words) {
  if (words.front() != file) throw UsageError("FILE stands before all options");
  const FilmNotes notes = notes_to_resume(file);
  Words all = notes.words;
  all.insert(all.end(), words.begin() + 1, words.end());
  RenderArguments arguments = parse_render_arguments(all);
  check_scene(arguments, notes);
  arguments.resumed = file;
  return render_command(arguments, all);
}

}  // namespace twinray
