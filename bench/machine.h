// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <utility>
#include <vector>

namespace twinray::bench {

/// What a measurement was made with and on: names and values, each in words, in the order of the reports.
/// What cannot be known is "unknown".
std::vector<std::pair<std::string, std::string>> describe_machine();

}  // namespace twinray::bench
