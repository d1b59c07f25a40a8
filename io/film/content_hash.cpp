// SPDX-License-Identifier: Apache-2.0
#include "io/film/content_hash.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <fmt/format.h>

#include <fstream>
#include <memory>
#include <vector>

#include "core/error.h"

namespace twinray {
namespace {

constexpr std::size_t block_bytes = std::size_t(1) << 20;

struct FreeState {
  void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
};

}  // namespace

std::uint64_t content_hash(std::span<const std::byte> bytes) {
  return XXH3_64bits(bytes.data(), bytes.size());
}

std::string file_hash(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw Error(fmt::format("{}: cannot be read", path));
  const std::unique_ptr<XXH3_state_t, FreeState> state(XXH3_createState());
  XXH3_128bits_reset(state.get());
  std::vector<char> block(block_bytes);
  while (file.read(block.data(), std::streamsize(block.size())) || file.gcount() > 0)
    XXH3_128bits_update(state.get(), block.data(), std::size_t(file.gcount()));
  if (file.bad()) throw Error(fmt::format("{}: cannot be read to its end", path));
  const XXH128_hash_t hash = XXH3_128bits_digest(state.get());
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

}  // namespace twinray
