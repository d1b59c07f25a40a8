// SPDX-License-Identifier: Apache-2.0
#include "core/columns.h"

#include <algorithm>

#include "core/error.h"

namespace twinray {
namespace {

/// So many values at once stay in the first cache.
constexpr std::size_t block_bytes = 16384;

/// Calls visit(place of a byte in the values, its place in the column) for all of them.
template <typename Visit>
void for_each_byte(std::size_t count, std::size_t value_bytes, const Visit& visit) {
  const std::size_t block = std::max<std::size_t>(1, block_bytes / value_bytes);
  for (std::size_t first = 0; first < count; first += block) {
    const std::size_t end = std::min(first + block, count);
    for (std::size_t byte = 0; byte < value_bytes; ++byte)
      for (std::size_t i = first; i < end; ++i) visit(i * value_bytes + byte, byte * count + i);
  }
}

}  // namespace

void ColumnWriter::put(std::span<const std::byte> values, std::size_t value_bytes) {
  const std::size_t begin = bytes_.size();
  bytes_.resize(begin + values.size());
  const auto column = std::span(bytes_).subspan(begin);
  for_each_byte(values.size() / value_bytes, value_bytes,
                [&](std::size_t from, std::size_t to) { column[to] = values[from]; });
}

void ColumnReader::check_left(std::size_t count, std::size_t value_bytes) const {
  if (left_.size() / value_bytes < count) throw Error("it ends early");
}

void ColumnReader::take(std::span<std::byte> values, std::size_t value_bytes) {
  check_left(values.size() / value_bytes, value_bytes);
  for_each_byte(values.size() / value_bytes, value_bytes,
                [&](std::size_t to, std::size_t from) { values[to] = left_[from]; });
  left_ = left_.subspan(values.size());
}

}  // namespace twinray
