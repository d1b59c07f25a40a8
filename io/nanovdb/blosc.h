// SPDX-License-Identifier: Apache-2.0
// The one door to Blosc.
#pragma once
#include <span>
#include <string>
#include <string_view>

namespace twinray {

/// Unpacks what fills `room`. `name` stands for the file in messages. Throws Error where it does not, or is
/// damaged.
void unpack_blosc(std::string_view packed, std::span<char> room, const std::string& name);

}  // namespace twinray
