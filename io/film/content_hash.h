// SPDX-License-Identifier: Apache-2.0
// The one door to xxHash (Collet): whether bytes are those that they were. No protection against forgery.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace twinray {

/// XXH3 of 64 bits.
std::uint64_t content_hash(std::span<const std::byte> bytes);

/// XXH3 of 128 bits of a file's bytes, as 32 hexadecimal digits. Throws Error where it cannot be read.
std::string file_hash(const std::string& path);

}  // namespace twinray
