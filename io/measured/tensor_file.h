// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace twinray {

/// The container of the material database of EPFL's Realistic Graphics Lab: named arrays of numbers, little
/// endian. What it gives throws Error, with the file's name and the field's, where it is not as asked.
class TensorFile {
 public:
  /// `bytes` are the file's, and must outlive this; `name` stands for it in messages. Throws Error where it
  /// is none, or is cut off.
  TensorFile(std::string_view bytes, const std::string& name);

  using Shape = std::vector<std::uint64_t>;

  bool has(const std::string& field) const { return fields_.count(field) > 0; }
  /// Of a field of so many dimensions, each at least 1.
  const Shape& shape(const std::string& field, std::size_t dimensions) const;
  /// Of a field of numbers of 32 bits.
  std::vector<float> floats(const std::string& field) const;
  /// Of a field of one byte.
  std::uint8_t byte(const std::string& field) const;
  [[noreturn]] void fail(const std::string& field, const std::string& what) const;

 private:
  enum class Type : std::uint8_t { byte = 1, float32 = 10, last = 11 };
  struct Field {
    Type type;
    Shape shape;
    std::string_view bytes;
  };
  const Field& at(const std::string& field) const;

  std::string name_;
  std::map<std::string, Field> fields_;
};

/// Writes such a file.
class TensorFileWriter {
 public:
  void add(const std::string& field, const TensorFile::Shape& shape, const std::vector<float>& values);
  void add(const std::string& field, std::string_view bytes);
  std::string bytes() const;

 private:
  struct Field {
    std::string name;
    std::uint8_t type;
    TensorFile::Shape shape;
    std::string bytes;
  };
  std::vector<Field> fields_;
};

}  // namespace twinray
