// SPDX-License-Identifier: Apache-2.0
// Whole files as they lie on disk.
#pragma once
#include <cstdint>
#include <string>

namespace twinray {

/// The most bytes of an input file, and of what a compressed one may grow to.
inline constexpr std::uint64_t max_input_bytes = std::uint64_t(1) << 30;

/// Throws Error, which begins with the path, where it is no regular file, nor a link to one; `needed` says
/// what it is to be: "film".
void check_regular_file(const std::string& path, const char* needed);

/// The bytes of a file. Throws Error, which begins with the path, where it does not exist, is a directory,
/// cannot be read or has more than max_input_bytes; `needed` is what a directory is not: "scene file".
std::string read_input_file(const std::string& path, const char* needed);

}  // namespace twinray
