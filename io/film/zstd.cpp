// SPDX-License-Identifier: Apache-2.0
#include "io/film/zstd.h"

#include <fmt/format.h>
#include <zstd.h>

#include "core/error.h"

namespace twinray {
namespace {

/// The fastest of the ordinary ones: sums of samples are mostly noise, which no level makes smaller.
constexpr int level = 1;

}  // namespace

std::vector<std::byte> pack_zstd(std::span<const std::byte> bytes) {
  std::vector<std::byte> packed(ZSTD_compressBound(bytes.size()));
  const std::size_t size = ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), level);
  if (ZSTD_isError(size)) throw Error(fmt::format("Zstandard: {}", ZSTD_getErrorName(size)));
  packed.resize(size);
  return packed;
}

std::vector<std::byte> unpack_zstd(std::span<const std::byte> packed, std::size_t bytes) {
  std::vector<std::byte> unpacked(bytes);
  const std::size_t size = ZSTD_decompress(unpacked.data(), bytes, packed.data(), packed.size());
  if (ZSTD_isError(size)) throw Error(fmt::format("its packing is damaged: {}", ZSTD_getErrorName(size)));
  if (size != bytes) throw Error(fmt::format("{} bytes where {} should be", size, bytes));
  return unpacked;
}

}  // namespace twinray
