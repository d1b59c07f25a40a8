// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <utility>
#include <vector>

namespace twinray {

/// What a measured time depends on, as names and values: date, processor, threads, memory, governor, load,
/// system; "unknown" for what the system does not tell.
std::vector<std::pair<std::string, std::string>> describe_machine();

}  // namespace twinray
