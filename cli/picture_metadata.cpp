// SPDX-License-Identifier: Apache-2.0
#include "cli/picture_metadata.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include "cli/console.h"
#include "cli/shell_text.h"
#include "cli/version.h"
#include "core/error.h"
#include "io/decimal.h"
#include "io/picture/camera_matrices.h"

namespace twinray {

std::string time_stamp(const std::string& seconds_since_1970) {
  constexpr std::int64_t end_of_year_9999 = 253402300799;
  std::int64_t seconds = -1;
  const char* const end = seconds_since_1970.data() + seconds_since_1970.size();
  const auto [next, error] = std::from_chars(seconds_since_1970.data(), end, seconds);
  if (error != std::errc{} || next != end || seconds < 0 || seconds > end_of_year_9999)
    throw Error(fmt::format("SOURCE_DATE_EPOCH: \"{}\" is not a time; valid are 0 to {}, seconds since 1970",
                            seconds_since_1970, end_of_year_9999));
  return fmt::format("{:%Y:%m:%d %H:%M:%S}", fmt::gmtime(std::time_t(seconds)));
}

namespace {

/// What a scene's file says of the light that is white on displays.
constexpr const char* daylight_key = "twinray:daylight_kelvin";

/// What keeps a picture from converging to the scene's light; empty: nothing.
std::string biases_of(const PathOptions& path) {
  std::vector<std::string> biases;
  if (std::isfinite(path.clamp)) biases.push_back(fmt::format("clamp {}", path.clamp));
  if (path.regularize) biases.push_back("regularize");
  return fmt::format("{}", fmt::join(biases, ", "));
}

}  // namespace

ImageMetadata option_metadata(const RenderArguments& arguments, const std::vector<std::string>& words) {
  ImageMetadata metadata{{"Software", version_name()},
                         {"twinray:scene", arguments.scene},
                         {"twinray:options", shell_text(words)},
                         {"twinray:seed", fmt::format("{}", arguments.render.seed)},
                         {"twinray:engine", engine_name(arguments)},
                         {"twinray:samples", fmt::format("{}", arguments.render.samples)},
                         {"twinray:filter", filter_text(arguments.render.filter)}};
  if (const std::string biases = biases_of(arguments.path); !biases.empty())
    metadata.emplace_back("twinray:biased_by", biases);
  if (arguments.display.daylight_kelvin)
    metadata.emplace_back(daylight_key, fmt::format("{}", *arguments.display.daylight_kelvin));
  return metadata;
}

std::optional<double> daylight_of(const ImageMetadata& metadata) {
  const auto [kelvin, fault] = read_decimal<double>(value_of(metadata, daylight_key));
  const bool is_one =
      fault == DecimalFault::none && kelvin >= least_white_kelvin && kelvin <= most_white_kelvin;
  return is_one ? std::optional(kelvin) : std::nullopt;
}

ImageMetadata picture_metadata(const RenderArguments& arguments, const std::vector<std::string>& words) {
  ImageMetadata metadata = option_metadata(arguments, words);
  if (console::speaker() != "twinray") metadata.emplace_back("twinray:program", console::speaker());
  if (const char* time = std::getenv("SOURCE_DATE_EPOCH"); time && *time)
    metadata.emplace_back("DateTime", time_stamp(time));
  return metadata;
}

PictureNotes picture_notes(const RenderArguments& arguments, const std::vector<std::string>& words,
                           const Scene& scene, const InputFiles& inputs) {
  const RenderOptions& options = arguments.render;
  const PixelRect window = window_of(options);
  ImageMetadata metadata = picture_metadata(arguments, words);
  metadata.emplace_back("twinray:inputs", input_text(inputs));
  const ImageFrame frame{window.x0, window.y0, options.width, options.height,
                         camera_matrices(fit_frame(scene.camera, options.width, options.height))};
  if (window != PixelRect{0, 0, options.width, options.height})
    metadata.emplace_back(frame_key, frame_value(frame));
  return {std::move(metadata), frame, scene_names(scene, film_contents(options, scene))};
}

std::set<std::string> engines_in(const std::string& names) {
  constexpr std::string_view between = ", ";
  std::set<std::string> engines;
  for (std::size_t begin = 0, end = 0; end != names.npos; begin = end + between.size()) {
    end = names.find(between, begin);
    engines.insert(names.substr(begin, end - begin));
  }
  engines.erase("");
  return engines;
}

std::set<std::string> engines_of(const ImageMetadata& metadata) {
  return engines_in(value_of(metadata, "twinray:engine"));
}

void set_engines(ImageMetadata& metadata, const std::set<std::string>& engines) {
  set_value(metadata, "twinray:engine", fmt::format("{}", fmt::join(engines, ", ")));
}

ImageMetadata metadata_showing(const char* what, const PictureNotes& notes) {
  ImageMetadata metadata = notes.metadata;
  set_value(metadata, "twinray:shows", what);
  return metadata;
}

}  // namespace twinray
