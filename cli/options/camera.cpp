// SPDX-License-Identifier: Apache-2.0
// How a scene is seen: lens, projection and what of it is in view. Values of two numbers are one word each,
// "A,B".
#include <array>

#include "cli/options/render.h"

namespace twinray {
namespace {

constexpr Range<float> lengths{0, 1e12f};
constexpr Range<double> moments{-1e9, 1e9};  // In seconds.
constexpr Range<float> parts_of_frame{-100, 100};
constexpr Range<float> frame_heights{1e-12f, 1e12f};
constexpr Range<int> blade_counts{3, 64};
constexpr Range<float> angles{-360, 360};

/// "A:B" in two; the second part is empty where there is no colon.
std::array<std::string, 2> halves(const std::string& word, char separator) {
  const std::size_t at = word.find(separator);
  if (at == word.npos) return {word, ""};
  return {word.substr(0, at), word.substr(at + 1)};
}

std::array<float, 2> pair_of(const std::string& option, const std::string& word, const Range<float>& range) {
  const auto [first, second] = halves(word, ',');
  if (second.empty()) throw UsageError(fmt::format("{}: \"{}\" is not two numbers A,B", option, word));
  return {parse_number(option, first, range), parse_number(option, second, range)};
}

struct ProjectionWord {
  Projection projection;
  bool needs_size, has_size;
  Range<float> sizes;
};
constexpr ProjectionWord projection_words[] = {
    {Projection::perspective, true, true, {1e-3f, 179.9f}},
    {Projection::orthographic, false, true, frame_heights},
    {Projection::latitude_longitude, false, false, {}},
    {Projection::fisheye, false, true, {1e-3f, 360}},
    {Projection::equal_area, false, false, {}},
};

AskedProjection parse_projection(const std::string& word) {
  const auto [name, size] = halves(word, ':');
  const bool has_size = name.size() < word.size();
  for (const ProjectionWord& known : projection_words) {
    if (projection_name(known.projection) != name) continue;
    if (has_size && !known.has_size) throw UsageError(fmt::format("--projection: {} takes no number", name));
    if (!has_size && known.needs_size)
      throw UsageError(fmt::format("--projection: {0} needs the degrees of its height, as in {0}:40", name));
    AskedProjection asked{.projection = known.projection, .size = {}};
    if (has_size) asked.size = parse_number("--projection", size, known.sizes);
    return asked;
  }
  throw UsageError(
      fmt::format("--projection: there is no \"{}\"; valid are perspective:DEGREES, orthographic, "
                  "orthographic:HEIGHT, latitude-longitude, fisheye, fisheye:DEGREES, equal-area",
                  word));
}

Lens parse_lens(const std::string& word) {
  const auto [radius, distance] = pair_of("--lens", word, lengths);
  if (radius > 0 && !(distance > 0))
    throw UsageError("--lens: what is in focus must lie at a distance of more than 0");
  return {radius, radius > 0 ? distance : 1};
}

Aperture parse_aperture(const std::string& word) {
  const auto [blades, degrees] = halves(word, ':');
  Aperture aperture{.blades = parse_number("--aperture-blades", blades, blade_counts)};
  if (blades.size() < word.size()) {
    const float turns = parse_number("--aperture-blades", degrees, angles) / 360;
    aperture.turns = turns < 0 ? turns + 1 : turns;
  }
  return aperture;
}

void parse_clip(const std::string& word, RenderArguments& arguments) {
  arguments.load.clip_as_file = word == "file";
  arguments.changes.clip.reset();
  if (word == "file" || word == "none") return;
  if (word.find(',') == word.npos)
    throw UsageError(fmt::format("--clip: there is no \"{}\"; valid are none, file, NEAR,FAR", word));
  const auto [near, far] = pair_of("--clip", word, lengths);
  if (!(near < far)) throw UsageError(fmt::format("--clip: {} is not less than {}", near, far));
  arguments.changes.clip = ClipPlanes{near, far};
}

/// A moment, or the shutter's time and how many samples see the same moment of it.
void parse_time(const std::string& word, RenderArguments& arguments) {
  const auto [times, samples] = halves(word, ':');
  const auto [begin, end] = halves(times, ',');
  arguments.load.time = parse_number("--time", begin, moments);
  arguments.shutter.reset();
  arguments.samples_per_moment = 0;
  if (times.size() == begin.size() && times.size() < word.size())
    throw UsageError(
        fmt::format("--time: {} is one moment; END is missing before the samples of each", begin));
  if (times.size() == begin.size()) return;
  arguments.shutter = {*arguments.load.time, parse_number("--time", end, moments)};
  if (!(arguments.shutter->length() > 0))
    throw UsageError(fmt::format("--time: {} is not less than {}", begin, end));
  if (times.size() < word.size())
    arguments.samples_per_moment = parse_number("--time", samples, sample_counts);
}

}  // namespace

void add_camera_options(CLI::App& app, RenderRequest& request) {
  OptionGroup group(app, option_groups::picture);
  RenderArguments& arguments = request.arguments;
  CameraChanges& changes = arguments.changes;
  group.add_words(
      {"--clip", "none|file|NEAR,FAR", "Clip planes: of the scene's file, or depths (none)", "none"}, 1,
      [&arguments](const Words& words) { parse_clip(words[0], arguments); });
  group.add_word({"-c,--camera", "FILE", "Camera settings file of CS184's program"}, arguments.camera_file);
  group.add_word({"--camera-name", "NAME", "A camera of the scene file, by name or id; ? lists them"},
                 arguments.load.camera_name);
  group.add_words({"--time", "T[,END[:N]]", "When what moves is seen; N samples of each moment (at rest)"}, 1,
                  [&arguments](const Words& words) { parse_time(words[0], arguments); });
  group.add_words({"--projection", "TYPE[:N]", "perspective:FOV orthographic fisheye latitude-longitude ..."},
                  1, [&changes](const Words& words) { changes.projection = parse_projection(words[0]); });
  group.add_words({"--lens", "RADIUS,DISTANCE", "Depth of field: a lens, and how far away is in focus"}, 1,
                  [&changes](const Words& words) { changes.lens = parse_lens(words[0]); });
  group.add_words({"--aperture-blades", "N[:DEGREES]", "The lens is a polygon of N corners, turned"}, 1,
                  [&changes](const Words& words) { changes.aperture = parse_aperture(words[0]); });
  group.add_words({"--lens-shift", "X,Y", "Moves the frame by parts of its width and height"}, 1,
                  [&changes](const Words& words) {
                    const auto [x, y] = pair_of("--lens-shift", words[0], parts_of_frame);
                    changes.shift = Vec2{x, y};
                  });
}

}  // namespace twinray
