// SPDX-License-Identifier: Apache-2.0
#include "cli/film/resume_command.h"

#include <algorithm>
#include <filesystem>
#include <memory>

#include "cli/console.h"
#include "cli/film/saved_film.h"
#include "cli/render_command.h"
#include "cli/render_command_line.h"
#include "io/film/film_file.h"
#include "io/generated/generated.h"

namespace twinray {
namespace {

void check_scene(const RenderArguments& arguments, const FilmNotes& notes) {
  std::error_code error;
  if (generated::is_generated(arguments.scene) || std::filesystem::exists(arguments.scene, error)) return;
  throw Error(
      fmt::format("{}: there is no such file; the render was begun in {}", arguments.scene, notes.folder));
}

bool ends_with(const Words& words, const Words& last) {
  return words.size() >= last.size() && std::equal(last.rbegin(), last.rend(), words.rbegin());
}

/// Whether a checkpoint of this name is kept in `file`, or would be its newer one.
bool is_kept_in(const std::string& checkpoint, const std::string& file) {
  const auto place = [](const std::string& name) {
    std::error_code error;  // Where the folder is gone, or cannot be looked into, the name alone counts.
    return std::filesystem::weakly_canonical(name, error);
  };
  return place(checkpoint) == place(file) || place(earlier_film_name(checkpoint)) == place(file);
}

/// Options that may be given several times. Where they stand behind a film's name they replace all of its
/// own.
const std::vector<std::string> repeated_options{"--light-group"};

/// The words of a film, and those behind its name, which count more. A job that calls itself again and again
/// says the same each time: once is enough.
Words words_to_resume(const Words& of_film, const std::string& file, const Words& further) {
  Words words = of_film;
  // A film that was moved, or copied, goes on where it is now.
  const std::string checkpoint = word_of_option(words, {"--checkpoint"});
  if (!checkpoint.empty() && !is_kept_in(checkpoint, file)) {
    words = without_options(words, {"--checkpoint"});
    words.insert(words.end(), {"--checkpoint", file});
  }
  if (ends_with(words, further)) return words;
  if (!word_of_option(further, repeated_options).empty()) words = without_options(words, repeated_options);
  words.insert(words.end(), further.begin(), further.end());
  return words;
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
  const Words all = words_to_resume(notes.words, file, Words(words.begin() + 1, words.end()));
  RenderArguments arguments = parse_render_arguments(all);
  check_scene(arguments, notes);
  arguments.resumed = file;
  return render_command(arguments, all);
}

}  // namespace twinray
