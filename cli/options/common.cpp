// SPDX-License-Identifier: Apache-2.0
#include "cli/options/common.h"

#include "accel/engines.h"
#include "cli/console.h"
#include "cli/sandbox/sandbox.h"

namespace twinray {
namespace {

constexpr Range<double> memory_megabytes{64, 1e9};
constexpr const char* no_places = ":";

const Choices<View> views{{"file", View::file}, {"whole", View::whole}};
const Choices<InstanceUse> instance_uses{
    {"auto", InstanceUse::automatic}, {"keep", InstanceUse::keep}, {"copy", InstanceUse::copy}};

}  // namespace

std::string view_name(View view) {
  for (const auto& [name, value] : views)
    if (value == view) return name;
  return "unknown";
}

Camera camera_of(const Scene& scene, View view, int width, int height) {
  if (view == View::file) return scene.camera;
  return view_whole(fit_frame(scene.camera, width, height), scene.geometry->bounds());
}

void add_resolution(OptionGroup& group, int& width, int& height, const std::string& description) {
  group.add_pair({"-r,--resolution", "W H", fmt::format("{} ({} {})", description, width, height)}, width,
                 height, frame_sides);
}

void add_resolution(OptionGroup& group, std::optional<RenderDefaults::Resolution>& resolution,
                    const std::string& description) {
  group.add_words({"-r,--resolution", "W H", description}, 2, [&resolution](const Words& words) {
    resolution = {parse_number("--resolution", words[0], frame_sides),
                  parse_number("--resolution", words[1], frame_sides)};
  });
}

void add_view(OptionGroup& group, View& view) {
  group.add_choice("--view", view, views, "As the file's camera sees it, or all of it");
}

Choices<std::string> engine_choices() {
  Choices<std::string> choices{{"auto", "auto"}};
  for (const Backend backend : available_backends())
    choices.emplace_back(backend_name(backend), backend_name(backend));
  return choices;
}

void add_instances(OptionGroup& group, LoadOptions& load) {
  group.add_choice("--instances", load.instances, instance_uses,
                   "What is shown often: stored once, or copied");
}

std::string instances_words(InstanceUse use) {
  for (const auto& [name, value] : instance_uses)
    if (value == use && use != LoadOptions{}.instances) return fmt::format(" --instances={}", name);
  return {};
}

void add_threads(OptionGroup& group, int& threads) {
  group.add_words({"-t,--threads", "N", "Threads (all of the machine)"}, 1, [&threads](const Words& words) {
    threads = parse_number("--threads", words.front(), thread_counts);
  });
}

void add_sandbox(OptionGroup& group, const std::string& description, std::string& word) {
  group.add_optional_word({"--sandbox", "[=PLACE:...]", description}, no_places, word);
}

std::optional<std::vector<std::string>> sandbox_places(const std::string& word) {
  if (word.empty()) return std::nullopt;
  return places_in(word);
}

void add_limits(OptionGroup& group, const std::string& time_description, ProcessLimits& limits) {
  group.add_number({"--memory", "MB", "Of the process, at most (all there is)"}, limits.megabytes,
                   memory_megabytes);
  group.add_number({"--time-limit", "T", time_description}, limits.seconds, time_limits);
}

LoadedScene load_with_warnings(const std::string& path, const LoadOptions& options) {
  LoadedScene loaded = load_scene(path, options);
  for (const Diagnostic& warning : loaded.warnings) console::warn(warning.text());
  return loaded;
}

}  // namespace twinray
