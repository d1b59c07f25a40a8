// SPDX-License-Identifier: Apache-2.0
#include "integrators/motion.h"

#include "core/hash.h"

namespace twinray {
namespace {

std::uint32_t reversed(std::uint32_t bits) {
  std::uint32_t result = 0;
  for (int i = 0; i < 32; ++i) result |= ((bits >> i) & 1u) << (31 - i);
  return result;
}

}  // namespace

double shutter_part(std::uint32_t moment, std::uint64_t seed) {
  const auto offset = std::uint32_t(mix(seed * hash_step + stream_step) >> 32);
  return double(reversed(moment) + offset) * 0x1p-32;
}

}  // namespace twinray
