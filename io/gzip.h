// SPDX-License-Identifier: Apache-2.0
// The one door to zlib: unpacks gzip files, and bytes in zlib's own form.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace twinray {

/// Whether the bytes begin as those of a gzip file do.
bool is_gzip(std::string_view bytes);

/// What a gzip file (of one or several members) holds. `name` stands for the file in messages. Throws Error
/// where it is damaged or cut off, or grows beyond max_input_bytes, or beyond gzip_small_bytes and more than
/// gzip_most_growth times.
std::string unpack_gzip(std::string_view bytes, const std::string& name);

/// Unpacks bytes in zlib's form (RFC 1950) that fill `room`. Throws Error where they do not, or are damaged.
void unpack_zlib(std::string_view packed, std::span<char> room, const std::string& name);

/// The bytes of an input file, unpacked where they are gzip. Throws Error.
std::string read_unpacked(const std::string& path);

inline constexpr std::uint64_t gzip_small_bytes = std::uint64_t(1) << 26, gzip_most_growth = 100;

}  // namespace twinray
