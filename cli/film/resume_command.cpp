// SPDX-License-Identifier: Apache-2.0
#include "cli/film/resume_command.h"

#include <algorithm>
#include <filesystem>
#include <memory>

#include "cli/console.h"
#include "cli/film/saved_film.h"
#include "cli/outputs.h"
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

bool is_same_place(const std::string& a, const std::string& b) {
  const auto place = [](const std::string& name) {
    std::error_code error;  // Where the folder is gone, or cannot be looked into, the name alone counts.
    return std::filesystem::weakly_canonical(name, error);
  };
  return place(a) == place(b);
}

/// Whether a checkpoint of this name is kept in `file`, or would be its newer one.
bool is_kept_in(const std::string& checkpoint, const std::string& file) {
  return is_same_place(checkpoint, file) || is_same_place(earlier_film_name(checkpoint), file);
}

/// Options that may be given several times. Where they stand behind a film's name they replace all of its
/// own.
const std::vector<std::string> repeated_options{"--light-group"};

/// Options of how a picture is made and shown, which say nothing of a sample that is made again.
const std::vector<std::string> options_of_pictures{
    "--output",  "-o",      "-f",           "--checkpoint",   "--checkpoint-seconds",
    "--threads", "-t",      "--stats",      "--metrics-file", "--progress",
    "--seconds", "--until", "--time-limit", "--exposure",     "--tone"};

Words with_option(Words words, const std::vector<std::string>& names, const std::string& value) {
  words = without_options(words, names);
  words.insert(words.end(), {names.front(), value});
  return words;
}

/// The words of a film as they are where it is now: it may have been moved, or copied. What there is of a
/// render goes on being kept in it. One that is itself what was asked for is so again.
Words words_here(const Words& of_film, const std::string& file, const Words& further) {
  if (!word_of_option(further, {"--checkpoint"}).empty()) return of_film;
  const std::string own = word_of_option(of_film, output_options),
                    other = word_of_option(further, output_options),
                    checkpoint = word_of_option(of_film, {"--checkpoint"});
  if (!other.empty() && is_same_place(other, file)) return without_options(of_film, {"--checkpoint"});
  if (is_kept_in(checkpoint, file)) return of_film;
  if (other.empty() && checkpoint.empty() && is_film_name(own)) {
    const bool is_here = is_same_place(own, file) || is_same_place(partial_name(own), file);
    return is_here ? of_film : with_option(of_film, output_options, file);
  }
  return with_option(of_film, {"--checkpoint"}, file);
}

/// The words of a film, and those behind its name, which count more. A job that calls itself again and again
/// says the same each time: once is enough.
Words words_to_resume(const Words& of_film, const std::string& file, const Words& further) {
  const bool is_replay = std::any_of(further.begin(), further.end(), [](const std::string& word) {
    return word == "--replay" || word.starts_with("--replay=");
  });
  Words words =
      is_replay ? without_options(of_film, options_of_pictures) : words_here(of_film, file, further);
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
