// SPDX-License-Identifier: Apache-2.0
// Numbers as bytes, for files. Of a column of numbers come first all their first bytes, then all their second
// ones, and so on: bytes that are alike stand together, and compress well.
#pragma once
#include <bit>
#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

namespace twinray {

/// Values are of whole words: each is taken apart, and put together, a word at a time.
inline constexpr std::size_t column_word_bytes = 4;

/// What a column may hold: each value has one form, and no byte in it is left over.
template <typename T>
concept ColumnValue = sizeof(T) % column_word_bytes == 0 && std::is_trivially_copyable_v<T> &&
                      (std::has_unique_object_representations_v<T> || std::is_floating_point_v<T>);

/// The same bytes on every machine.
static_assert(std::endian::native == std::endian::little);

class ColumnWriter {
 public:
  template <ColumnValue T>
  void put(std::span<const T> values) {
    put(std::as_bytes(values), sizeof(T));
  }
  /// A column of one.
  template <ColumnValue T>
  void put_value(const T& value) {
    put(std::span(&value, 1));
  }
  const std::vector<std::byte>& bytes() const { return bytes_; }

 private:
  void put(std::span<const std::byte> values, std::size_t value_bytes);

  std::vector<std::byte> bytes_;
};

/// Takes the columns of a writer in their order. Each function throws Error where fewer bytes are left.
class ColumnReader {
 public:
  explicit ColumnReader(std::span<const std::byte> bytes) : left_(bytes) {}

  template <ColumnValue T>
  void take(std::span<T> values) {
    take(std::as_writable_bytes(values), sizeof(T));
  }
  template <ColumnValue T>
  T take_value() {
    T value{};
    take(std::span(&value, 1));
    return value;
  }
  /// A column of so many. Takes no memory for what is not there.
  template <ColumnValue T>
  std::vector<T> take_column(std::size_t count) {
    check_left(count, sizeof(T));
    std::vector<T> values(count);
    take(std::span(values));
    return values;
  }
  bool is_at_end() const { return left_.empty(); }

 private:
  void check_left(std::size_t count, std::size_t value_bytes) const;
  void take(std::span<std::byte> values, std::size_t value_bytes);

  std::span<const std::byte> left_;
};

}  // namespace twinray
