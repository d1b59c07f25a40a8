// SPDX-License-Identifier: Apache-2.0
#include "core/columns.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "core/error.h"

namespace twinray {
namespace {

/// So many bytes at once stay in the first cache.
constexpr std::size_t block_bytes = 16384;

/// Calls visit(first value, end, byte) for blocks of values and each word of a value, which begins at that
/// byte of it. The loop over the values is left to the visitor: compilers make lanes of it.
template <typename Visit>
void for_each_word(std::size_t count, std::size_t value_bytes, const Visit& visit) {
  const std::size_t block = std::max<std::size_t>(1, block_bytes / value_bytes);
  for (std::size_t first = 0; first < count; first += block)
    for (std::size_t byte = 0; byte < value_bytes; byte += column_word_bytes)
      visit(first, std::min(first + block, count), byte);
}

void take_apart(const std::byte* values, std::size_t value_bytes, std::byte* column, std::size_t count) {
  for_each_word(count, value_bytes, [=](std::size_t first, std::size_t end, std::size_t byte) {
    for (std::size_t i = first; i < end; ++i) {
      std::uint32_t word = 0;
      std::memcpy(&word, values + i * value_bytes + byte, column_word_bytes);
      for (std::size_t k = 0; k < column_word_bytes; ++k)
        column[(byte + k) * count + i] = std::byte(word >> (8 * k));
    }
  });
}

void put_together(const std::byte* column, std::byte* values, std::size_t value_bytes, std::size_t count) {
  for_each_word(count, value_bytes, [=](std::size_t first, std::size_t end, std::size_t byte) {
    for (std::size_t i = first; i < end; ++i) {
      std::uint32_t word = 0;
      for (std::size_t k = 0; k < column_word_bytes; ++k)
        word |= std::uint32_t(column[(byte + k) * count + i]) << (8 * k);
      std::memcpy(values + i * value_bytes + byte, &word, column_word_bytes);
    }
  });
}

}  // namespace

void ColumnWriter::put(std::span<const std::byte> values, std::size_t value_bytes) {
  const std::size_t begin = bytes_.size();
  bytes_.resize(begin + values.size());
  take_apart(values.data(), value_bytes, bytes_.data() + begin, values.size() / value_bytes);
}

void ColumnReader::check_left(std::size_t count, std::size_t value_bytes) const {
  if (left_.size() / value_bytes < count) throw Error("it ends early");
}

void ColumnReader::take(std::span<std::byte> values, std::size_t value_bytes) {
  check_left(values.size() / value_bytes, value_bytes);
  put_together(left_.data(), values.data(), value_bytes, values.size() / value_bytes);
  left_ = left_.subspan(values.size());
}

}  // namespace twinray
