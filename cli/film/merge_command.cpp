// SPDX-License-Identifier: Apache-2.0
#include "cli/film/merge_command.h"

#include <algorithm>
#include <memory>
#include <set>
#include <sstream>

#include "cli/console.h"
#include "cli/denoising.h"
#include "cli/film/film_parts.h"
#include "cli/interrupt.h"
#include "cli/json_names.h"
#include "cli/options/common.h"
#include "cli/outputs.h"
#include "cli/render_command_line.h"
#include "cli/render_outputs.h"
#include "cli/shell_text.h"
#include "core/memory.h"
#include "io/input_file.h"

namespace twinray {
namespace {

void add_options(CLI::App& app, MergeArguments& arguments) {
  add_files(app, "FILM", arguments.films,
            "The films of all parts, in any order; @LIST: those that this file names, one a line");
  OptionGroup group(app, "Options");
  group.add_word({"-o,--output", "FILE", "The picture, or a .film of all samples"}, arguments.output);
  group.add_flag("--allow-gaps", arguments.allow_gaps,
                 "Make a picture of what there is; its metadata says what is missing");
  add_threads(group, arguments.threads);
  group.add_flag("-q,--quiet", arguments.quiet, "Print errors and warnings only");
}

/// A command line has room for some 40,000 names: @LIST stands for those in a file.
Words film_names(const Words& words) {
  Words names;
  for (const std::string& word : words) {
    if (!word.starts_with('@')) {
      names.push_back(word);
      continue;
    }
    std::istringstream lines(read_input_file(word.substr(1), "list of films"));
    const std::size_t before = names.size();
    for (std::string line; std::getline(lines, line);) {
      if (line.ends_with('\r')) line.pop_back();  // A list may come from Windows.
      if (!line.empty()) names.push_back(line);
    }
    if (names.size() == before) throw Error(fmt::format("{}: this list names no film", word.substr(1)));
  }
  return names;
}

/// Options that say which part a film is, and where it and its checkpoint go.
const std::vector<std::string> part_options{"--sample-range", "--tile-range", "--of", "--checkpoint",
                                            "--output",       "-o",           "-f",   "--checkpoint-seconds"};

/// The words of a part's command line without those that are the part's alone.
Words words_of_whole(const Words& of_part) {
  Words words = without_options(of_part, part_options);
  std::erase(words, "--resume");
  return words;
}

/// Options that say what is made of the samples. The parts may have different ones.
const std::vector<std::string> picture_options{
    "--exposure", "--white-balance",        "--tone",           "--ocio-view", "--ocio-display",
    "--denoise",  "--denoise-light-groups", "--exr-compression"};

RenderWords picture_words(const Words& words) {
  RenderWords found;
  for (auto& [name, values] : parse_render_words(words))
    if (std::find(picture_options.begin(), picture_options.end(), name) != picture_options.end())
      found.emplace(name, values);
  return found;
}

/// The first film's options make the picture: where others are different, which.
void warn_of_differences(const std::string& first, const FilmParts& parts) {
  std::set<Words> seen{words_of_whole(parts.notes.words)};
  const RenderWords taken = picture_words(parts.notes.words);
  for (const FilmPart& part : parts.parts)
    if (seen.insert(words_of_whole(part.words)).second)
      if (const std::string text = option_difference(picture_words(part.words), taken, "there");
          !text.empty())
        console::warn(fmt::format("{}: {}; the options of {} make the picture", part.path, text, first));
}

/// What the whole picture's command line would ask for.
RenderArguments arguments_of(const Words& words, const FilmNotes& notes) {
  RenderArguments arguments = parse_render_arguments(words);
  arguments.render.samples = notes.samples;
  arguments.render.width = notes.identity.width;
  arguments.render.height = notes.identity.height;
  arguments.render.window = notes.identity.window;
  arguments.display.daylight_kelvin = daylight_of(notes.picture.metadata);
  return arguments;
}

PictureNotes notes_of(const FilmParts& parts, const Words& words) {
  PictureNotes notes = parts.notes.picture;
  set_value(notes.metadata, "twinray:options", shell_text(words));
  set_engines(notes.metadata, parts.engines);
  // What the films have that are merged now was perhaps missing before.
  std::erase_if(notes.metadata, [](const auto& entry) { return entry.first == "twinray:missing"; });
  if (!parts.missing.empty())
    set_value(notes.metadata, "twinray:missing", fmt::format("{}", fmt::join(parts.missing, ", ")));
  return notes;
}

/// Of a film of all parts together.
FilmNotes film_notes_of(const FilmParts& parts, const Words& words) {
  FilmNotes notes = parts.notes;
  notes.words = words;
  notes.picture = notes_of(parts, words);
  notes.range.reset();
  notes.tiles.reset();
  const std::uint32_t begin = parts.parts.front().begin, end = parts.parts.back().end;
  if (parts.missing.empty()) return notes;
  if (parts.are_tiles())
    notes.tiles = {begin, end};
  else
    notes.range = {begin, end};
  return notes;
}

void write_merged_picture(const RenderOutputs& outputs, const RenderArguments& arguments,
                          const RenderState& state, PictureNotes notes) {
  std::optional<DenoisedPicture> denoised;
  if (arguments.denoiser && state.halves) {
    const Denoising denoising(*arguments.denoiser, arguments.render.threads);
    denoised = denoising.denoise(*state.halves);
    set_value(notes.metadata, "twinray:denoiser", denoised->denoiser);
  }
  write_pictures(outputs, arguments, {state.film, denoised ? &*denoised : nullptr}, notes);
}

/// A film with gaps amid its range would be taken for one without.
void check_film_output(const MergeArguments& arguments, const FilmParts& parts) {
  if (is_film_name(arguments.output) && parts.has_inner_gap())
    throw Error(fmt::format("{}: {} are missing amid it; a film is of a range without gaps", arguments.output,
                            parts.missing.front()));
}

void say_what_was_merged(const MergeArguments& arguments, const FilmParts& parts) {
  for (const std::string& path : parts.repeated)
    console::warn(fmt::format("{}: the same samples as in another film; they count once", path));
  const bool is_part = is_film_name(arguments.output);
  if (!is_part)
    for (const std::string& missing : parts.missing) console::warn(fmt::format("{} are missing", missing));
  if (arguments.quiet) return;
  console::print("Films          {}\n{:<15}{}\n", parts.parts.size(), output_word(arguments.output),
                 arguments.output);
  if (is_part && !parts.missing.empty())
    console::print("Not in it      {}\n", fmt::join(parts.missing, ", "));
}

}  // namespace

std::function<MergeArguments()> add_merge_options(CLI::App& app) {
  const auto arguments = std::make_shared<MergeArguments>();
  add_options(app, *arguments);
  return [arguments] {
    if (arguments->output.empty()) throw UsageError("--output=FILE is missing");
    return *arguments;
  };
}

int merge_command(const MergeArguments& given) {
  MergeArguments asked = given;
  asked.films = film_names(given.films);
  // A film of some parts is a part of the whole itself.
  const bool may_lack = asked.allow_gaps || is_film_name(asked.output);
  const FilmParts parts = read_film_parts(asked.films, may_lack ? Gaps::allowed : Gaps::refused);
  check_film_output(asked, parts);
  warn_of_differences(asked.films.front(), parts);
  const FilmNotes& first = parts.notes;
  Words words = without_options(words_of_whole(first.words), {"--samples", "-s"});
  words.insert(words.end(), {"--samples", fmt::format("{}", first.samples), "--output", asked.output});
  RenderArguments arguments = arguments_of(words, first);
  arguments.render.threads = asked.threads;
  const RenderOutputs outputs = render_outputs(arguments);
  check_json_names(given_names({outputs.film}), "a film");
  const InterruptGuard guard(outputs.names());
  prepare_outputs(outputs.names(), asked.films);
  const RenderState state = merged(parts, asked.threads);
  if (outputs.film.empty())
    write_merged_picture(outputs, arguments, state, notes_of(parts, words));
  else
    write_film(outputs.film, film_notes_of(parts, words), state, asked.threads);
  say_what_was_merged(asked, parts);
  return 0;
}

}  // namespace twinray
