// SPDX-License-Identifier: Apache-2.0
// Private: structures of arrays, in which a wave of paths is kept: number i of each column belongs to path i.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "core/vec.h"

namespace twinray {

/// How many paths grow together, at most: what is known of them, some 550 bytes each, stays in the second
/// cache.
inline constexpr std::size_t wave_size = 512;

/// Room behind the last path, so that full vectors can be read and written there.
inline constexpr std::size_t column_padding = 16;

template <typename T>
struct alignas(64) Column {
  T values[wave_size + column_padding];

  T& operator[](std::size_t i) { return values[i]; }
  const T& operator[](std::size_t i) const { return values[i]; }
};

using Floats = Column<float>;
using Words = Column<std::uint32_t>;

/// 64-bit words in halves.
struct Keys {
  Words low, high;

  void set(std::size_t i, std::uint64_t key) {
    low[i] = std::uint32_t(key);
    high[i] = std::uint32_t(key >> 32);
  }
  std::uint64_t at(std::size_t i) const { return std::uint64_t(high[i]) << 32 | low[i]; }
};

/// Vectors, or colours.
struct Columns3 {
  Floats x, y, z;

  template <typename Triple>
  void set(std::size_t i, const Triple& v) {
    const auto& [a, b, c] = v;
    x[i] = a;
    y[i] = b;
    z[i] = c;
  }
  /// Gives the first `size` of them one value in all components.
  void fill(std::size_t size, float value) {
    for (Floats* const column : {&x, &y, &z}) std::fill_n(column->values, size, value);
  }
  void clear(std::size_t size) { fill(size, 0); }
  template <typename Triple = Vec3>
  Triple at(std::size_t i) const {
    return {x[i], y[i], z[i]};
  }
};

}  // namespace twinray
