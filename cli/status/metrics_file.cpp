// SPDX-License-Identifier: Apache-2.0
#include "cli/status/metrics_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/console.h"
#include "core/error.h"
#include "io/output_file.h"

namespace twinray {
namespace {

constexpr std::chrono::steady_clock::duration usual_interval = std::chrono::seconds(5);
/// Writing takes at most one part in so many of the time.
constexpr int rarity = 100;

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

}  // namespace

std::string metrics_text(const RenderStatus& status, const std::string& scene, const std::string& output) {
  const std::string labels = label("scene", scene) + "," + label("output", output);
  std::string text = head("step", "1 for what the render is doing");
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
  const Clock::time_point begin = Clock::now();
  try {
    write_file(path_, metrics_text(status, scene_, output_));
  } catch (const Error& error) {
    console::warn(fmt::format("no metrics: {}", error.what()));
  }
  const Clock::time_point end = Clock::now();
  next_ = end + std::max(usual_interval, rarity * (end - begin));
}

}  // namespace twinray
