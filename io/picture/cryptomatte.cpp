// SPDX-License-Identifier: Apache-2.0
#include "io/picture/cryptomatte.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <nlohmann/json.hpp>

#include "io/utf8.h"

namespace twinray {
namespace {

/// One block of four bytes, mixed.
std::uint32_t mixed(std::uint32_t block) { return std::rotl(block * 0xcc9e2d51u, 15) * 0x1b873593u; }

std::uint32_t byte_at(std::string_view text, std::size_t i) { return static_cast<unsigned char>(text[i]); }

/// The bytes from `first` on, four at most, the first one lowest.
std::uint32_t block_at(std::string_view text, std::size_t first) {
  std::uint32_t block = 0;
  for (std::size_t i = std::min(first + 4, text.size()); i-- > first;) block = block << 8 | byte_at(text, i);
  return block;
}

}  // namespace

std::uint32_t murmur_hash(std::string_view name) {
  std::uint32_t hash = 0;
  const std::size_t whole = name.size() / 4 * 4;
  for (std::size_t i = 0; i < whole; i += 4)
    hash = std::rotl(hash ^ mixed(block_at(name, i)), 13) * 5 + 0xe6546b64u;
  if (whole < name.size()) hash ^= mixed(block_at(name, whole));
  hash ^= std::uint32_t(name.size());
  hash = (hash ^ hash >> 16) * 0x85ebca6bu;
  hash = (hash ^ hash >> 13) * 0xc2b2ae35u;
  return hash ^ hash >> 16;
}

std::uint32_t cryptomatte_id(const std::string& name) {
  const std::uint32_t hash = murmur_hash(as_utf8(name));
  const std::uint32_t exponent = hash >> 23 & 255;
  // Zeros, denormals, infinities and what is not a number would not survive every program.
  return exponent == 0 || exponent == 255 ? hash ^ 1u << 23 : hash;
}

ImageMetadata cryptomatte_metadata(const std::string& kind, std::span<const std::string> names) {
  nlohmann::json manifest = nlohmann::json::object();
  for (const std::string& name : names) manifest[as_utf8(name)] = fmt::format("{:08x}", cryptomatte_id(name));
  const std::string prefix =
      fmt::format("cryptomatte/{}/", fmt::format("{:08x}", murmur_hash(kind)).substr(0, 7));
  return {{prefix + "name", kind},
          {prefix + "hash", "MurmurHash3_32"},
          {prefix + "conversion", "uint32_to_float32"},
          {prefix + "manifest", manifest.dump()}};
}

void write_ranks(std::span<MatteCoverage> coverages, std::span<float> ranks) {
  std::sort(coverages.begin(), coverages.end(), [](const MatteCoverage& a, const MatteCoverage& b) {
    return a.coverage != b.coverage ? a.coverage > b.coverage : a.id < b.id;
  });
  std::fill(ranks.begin(), ranks.end(), 0.0f);
  for (std::size_t i = 0; i < std::min(coverages.size(), ranks.size() / 2); ++i) {
    ranks[2 * i] = std::bit_cast<float>(coverages[i].id);
    ranks[2 * i + 1] = coverages[i].coverage;
  }
}

}  // namespace twinray
