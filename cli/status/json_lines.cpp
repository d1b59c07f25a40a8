// SPDX-License-Identifier: Apache-2.0
#include "cli/status/json_lines.h"

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "cli/console.h"
#include "cli/version.h"

namespace twinray {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(double value) {
  constexpr double exact_integers = 9007199254740992;  // 2^53
  const bool is_integer = std::abs(value) < exact_integers && value == std::floor(value);
  return is_integer ? Json(std::int64_t(value)) : Json(value);
}

}  // namespace

bool JsonLines::is_due() const { return Clock::now() - last_ >= std::chrono::seconds(1); }

void JsonLines::report(const RenderStatus& status) {
  last_ = Clock::now();
  Json json{{"step", step_name(status.step)}};
  if (std::exchange(is_first_, false)) {
    json["program"] = version_name();
    json["scene"] = scene_;
    json["output"] = output_;
  }
  for (const StatusNumber& number : status_numbers(status))
    json[number.name] = number.value ? json_of(*number.value) : Json(nullptr);
  console::print_error("{}\n", json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace twinray
