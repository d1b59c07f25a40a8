// SPDX-License-Identifier: Apache-2.0
// The one door to Zstandard: packs and unpacks bytes.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

namespace twinray {

/// Packs bytes, quickly.
std::vector<std::byte> pack_zstd(std::span<const std::byte> bytes);

/// Unpacks what becomes exactly so many bytes. Throws Error where it is damaged, or becomes others.
std::vector<std::byte> unpack_zstd(std::span<const std::byte> packed, std::size_t bytes);

}  // namespace twinray
