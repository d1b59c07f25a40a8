// SPDX-License-Identifier: Apache-2.0
// What a render keeps while it goes on, and which part of a picture it is.
#include "cli/film/film_keeper.h"
#include "cli/options/render.h"

namespace twinray {
namespace {

constexpr Range<double> intervals{1e-3, 1e6};

/// Of samples or tiles: one at least.
template <typename PartRange>
PartRange parse_part(const char* option, const std::string& word) {
  constexpr Range<std::uint32_t> numbers{0, std::numeric_limits<std::uint32_t>::max()};
  const auto [begin, end] = parse_range(option, word, numbers, "0:16");
  if (begin >= end) throw UsageError(fmt::format("{}: {} is not less than {}", option, begin, end));
  return {begin, end};
}

void check_part(const char* option, const RenderArguments& arguments) {
  if (arguments.replay) return;
  if (!is_film_name(arguments.output))
    throw UsageError(
        fmt::format("{}: a part of a picture is kept as a film, to be merged; {} does not end in "
                    ".film",
                    option, arguments.output));
  if (is_open_ended(arguments.render))
    throw UsageError(
        fmt::format("{}: a part has as many samples as the picture's others; --seconds and "
                    "--noise-target do not go with it",
                    option));
  if (arguments.render.allocation == Allocation::error)
    throw UsageError(
        fmt::format("{}: --allocation=error looks at the whole picture, and has no parts", option));
}

}  // namespace

void add_film_options(CLI::App& app, RenderRequest& request) {
  OptionGroup group(app, "Parts and checkpoints (docs/films.md)");
  RenderArguments& arguments = request.arguments;
  group.add_word({"--checkpoint", "FILE", "Keep the render there, for `twinray resume FILE`"},
                 arguments.checkpoint);
  group.add_flag("--resume", request.resume, "Go on with the checkpoint where there is one");
  group.add_number({"--checkpoint-seconds", "T", "Between checkpoints (60, or 100 times what one takes)"},
                   arguments.checkpoint_seconds, intervals);
  group.add_words({"--sample-range", "A:B", "Render samples A to B - 1 alone, into a .film for merge"}, 1,
                  [&request](const Words& words) {
                    request.arguments.render.range = parse_part<SampleRange>("--sample-range", words[0]);
                  });
  group.add_number({"--of", "N", "The samples per pixel of the whole, as --samples"}, request.of,
                   sample_counts);
  group.add_words({"--tile-range", "A:B", "Render tiles A to B - 1 alone: 16 x 16 pixels, row by row"}, 1,
                  [&request](const Words& words) {
                    request.arguments.render.tiles = parse_part<TileRange>("--tile-range", words[0]);
                  });
}

void resolve_film(const RenderRequest& request, RenderArguments& arguments) {
  RenderOptions& render = arguments.render;
  if (request.of && is_given("--samples", arguments) && *request.of != render.samples)
    throw UsageError(fmt::format("--of: {} samples, and --samples says {}", *request.of, render.samples));
  if (request.resume && arguments.checkpoint.empty())
    throw UsageError("--resume goes with --checkpoint, which says what to go on with");
  if (request.resume && has_film(arguments.checkpoint)) arguments.resumed = arguments.checkpoint;
  if (request.of) render.samples = *request.of;
  if (render.range) check_part("--sample-range", arguments);
  if (render.tiles) check_part("--tile-range", arguments);
  if (render.range && render.tiles) throw UsageError("--sample-range and --tile-range exclude each other");
  if (render.range && render.adaptive)
    throw UsageError("--sample-range: --adaptive looks at all samples of a pixel; --tile-range goes with it");
  if (arguments.check_with && uses_films(arguments))
    throw UsageError("--accel=check compares all rays of one render: it makes and resumes no films");
}

}  // namespace twinray
