// SPDX-License-Identifier: Apache-2.0
#include "cli/status/metrics_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "cli/console.h"
#include "cli/outputs.h"
#include "cli/render_outputs.h"
#include "core/error.h"
#include "io/destination.h"
#include "io/film/film_file.h"
#include "io/output_file.h"

namespace twinray {
namespace {

constexpr std::chrono::steady_clock::duration usual_interval = std::chrono::seconds(5);
/// Writing takes at most one part in so many of the time.
constexpr int metrics_rarity = 100;

/// A file's name may hold bytes that are no letters.
std::string only_letters(const std::string& text) {
  using nlohmann::json;
  return json::parse(json(text).dump(-1, ' ', false, json::error_handler_t::replace)).get<std::string>();
}

std::string label(const char* name, const std::string& value) {
  std::string text;
  for (const char c : only_letters(value)) {
    if (c == '\\' || c == '"') text += '\\';
    text += c == '\n' ? std::string("\\n") : std::string(1, c);
  }
  return fmt::format("{}=\"{}\"", name, text);
}

std::string head(const char* name, const char* description) {
  return fmt::format("# HELP twinray_{0} {1}.\n# TYPE twinray_{0} gauge\n", name, description);
}

constexpr const char* step_description = "1 for what the render is doing";

/// Whether two names are of one place; one that cannot be written is of none.
bool is_same(const std::string& a, const std::string& b) {
  try {
    return is_same_place(destination_of(a), destination_of(b));
  } catch (const Error&) {
    return false;
  }
}

/// What else the render may write or read, as far as its command line tells.
std::vector<std::string> other_names(const RenderArguments& arguments) {
  RenderOutputs outputs = named_outputs(arguments);
  outputs.metrics.clear();
  std::vector<std::string> names = outputs.names();
  for (const std::string& name : outputs.names()) names.push_back(partial_name(name));
  if (!arguments.checkpoint.empty()) names.push_back(earlier_film_name(arguments.checkpoint));
  for (const std::string& read : {arguments.scene, arguments.environment, arguments.camera_file})
    if (!read.empty()) names.push_back(read);
  return names;
}

/// Whether metrics could be written to a file of this name, and nothing else has it.
bool is_name_free(const RenderArguments& arguments) {
  const std::string& path = arguments.metrics_file;
  try {
    check_outputs({path});
    if (destination_of(path).kind != Destination::Kind::file) return false;
    for (const std::string& other : other_names(arguments))
      if (is_same(path, other)) return false;
    return true;
  } catch (const Error&) {  // The render is refused for it.
    return false;
  }
}

/// Whether nothing is there but metrics, nor is anything else to be written there.
bool is_free_for_metrics(const RenderArguments& arguments) {
  const std::string& path = arguments.metrics_file;
  if (!is_name_free(arguments)) return false;
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return true;
  const std::string begin = head("step", step_description);
  std::string there(begin.size(), '\0');
  return std::filesystem::is_regular_file(path, error) &&
         std::ifstream(path, std::ios::binary).read(there.data(), std::streamsize(there.size())) &&
         there == begin;
}

}  // namespace

MetricsFile::MetricsFile(const RenderArguments& arguments)
    : path_(arguments.metrics_file),
      scene_(arguments.scene),
      output_(arguments.output),
      may_write_(is_free_for_metrics(arguments)) {}

std::string metrics_text(const RenderStatus& status, const std::string& scene, const std::string& output) {
  const std::string labels = label("scene", scene) + "," + label("output", output);
  std::string text = head("step", step_description);
  for (const RenderStatus::Step step : render_steps())
    text += fmt::format("twinray_step{{{},{}}} {}\n", labels, label("step", step_name(step)),
                        step == status.step ? 1 : 0);
  for (const StatusNumber& number : status_numbers(status))
    if (number.value)
      text += head(number.name, number.description) +
              fmt::format("twinray_{}{{{}}} {}\n", number.name, labels, *number.value);
  return text;
}

void MetricsFile::report(const RenderStatus& status) {
  using Step = RenderStatus::Step;
  may_write_ |= status.step != Step::loading && status.step != Step::failed;
  if (!may_write_) return;
  const Clock::time_point begin = Clock::now();
  try {
    write_file(path_, metrics_text(status, scene_, output_));
  } catch (const Error& error) {
    console::warn(fmt::format("no metrics: {}", error.what()));
  }
  const Clock::time_point end = Clock::now();
  next_ = end + std::max(usual_interval, metrics_rarity * (end - begin));
}

}  // namespace twinray
