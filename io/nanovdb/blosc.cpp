// SPDX-License-Identifier: Apache-2.0
#include "io/nanovdb/blosc.h"

#include <blosc.h>

#include "core/error.h"

namespace twinray {

void unpack_blosc(std::string_view packed, std::span<char> room, const std::string& name) {
  std::size_t size = 0;
  constexpr int threads = 1;
  // The header says how long the packed bytes are: it is believed only where that is so.
  const bool is_unpacked =
      blosc_cbuffer_validate(packed.data(), packed.size(), &size) == 0 && size == room.size() &&
      blosc_decompress_ctx(packed.data(), room.data(), room.size(), threads) == int(room.size());
  if (!is_unpacked) throw Error(name + ": what Blosc has packed is damaged");
}

}  // namespace twinray
