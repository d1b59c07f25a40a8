// SPDX-License-Identifier: Apache-2.0
#include "io/measured/tensor_file.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstring>
#include <utility>

#include "core/error.h"
#include "io/byte_cursor.h"

namespace twinray {
namespace {

/// With the zero behind it.
constexpr std::string_view tensor_magic("tensor_file\0", 12);
constexpr std::array<std::uint8_t, 2> tensor_version{1, 0};
/// Of the types 1 to 11: integers of both kinds by their size, then floats.
constexpr std::array<std::uint64_t, 12> type_sizes{0, 1, 1, 2, 2, 4, 4, 8, 8, 2, 4, 8};
constexpr std::size_t most_dimensions = 16;

static_assert(std::endian::native == std::endian::little);

template <typename T>
void put(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string text_of(const TensorFile::Shape& shape) { return fmt::format("{}", fmt::join(shape, " x ")); }

}  // namespace

TensorFile::TensorFile(std::string_view bytes, const std::string& name) : name_(name) {
  if (!bytes.starts_with(tensor_magic))
    throw Error(name + ": is not a tensor file, as measured materials are");
  ByteCursor file(bytes, name + ": the tensor file");
  file.take(tensor_magic.size(), "its header");
  const auto version = file.take<std::array<std::uint8_t, 2>>("its header");
  if (version != tensor_version)
    throw Error(fmt::format("{}: is a tensor file of version {}.{}; only version 1.0 is read", name,
                            version[0], version[1]));
  const auto count = file.take<std::uint32_t>("its header");
  constexpr const char* list = "its list of fields";
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto length = file.take<std::uint16_t>(list);
    const std::string field(file.take(length, list));
    const auto dimensions = file.take<std::uint16_t>(list);
    const auto type = file.take<std::uint8_t>(list);
    const auto offset = file.take<std::uint64_t>(list);
    if (type == 0 || type > std::uint8_t(Type::last)) fail(field, fmt::format("has no type {}", type));
    if (dimensions > most_dimensions)
      fail(field, fmt::format("has {} dimensions; at most {} are read", dimensions, most_dimensions));
    Shape shape;
    std::uint64_t size = type_sizes[type];
    for (int d = 0; d < int(dimensions); ++d) {
      shape.push_back(file.take<std::uint64_t>(list));
      if (shape.back() > 0 && size > bytes.size() / shape.back())
        fail(field, fmt::format("of {} numbers is larger than the file", text_of(shape)));
      size *= shape.back();
    }
    if (offset > bytes.size() || size > bytes.size() - offset)
      fail(field, "reaches beyond the end of the file");
    if (!fields_.try_emplace(field, Field{Type(type), std::move(shape), bytes.substr(offset, size)}).second)
      fail(field, "is there twice");
  }
}

void TensorFile::fail(const std::string& field, const std::string& what) const {
  throw Error(fmt::format("{}: the field \"{}\" {}", name_, field, what));
}

const TensorFile::Field& TensorFile::at(const std::string& field) const {
  const auto found = fields_.find(field);
  if (found == fields_.end()) fail(field, "is missing");
  return found->second;
}

const TensorFile::Shape& TensorFile::shape(const std::string& field, std::size_t dimensions) const {
  const Shape& shape = at(field).shape;
  if (shape.size() != dimensions)
    fail(field, fmt::format("has {} dimensions; it needs {}", shape.size(), dimensions));
  for (const std::uint64_t size : shape)
    if (size == 0) fail(field, "is empty");
  return shape;
}

std::vector<float> TensorFile::floats(const std::string& field) const {
  const Field& found = at(field);
  if (found.type != Type::float32) fail(field, "must have numbers of the type float, of 32 bits");
  std::vector<float> values(found.bytes.size() / sizeof(float));
  std::memcpy(values.data(), found.bytes.data(), values.size() * sizeof(float));
  return values;
}

std::uint8_t TensorFile::byte(const std::string& field) const {
  const Field& found = at(field);
  if (found.type != Type::byte || found.bytes.size() != 1) fail(field, "must be one byte");
  return std::uint8_t(found.bytes[0]);
}

void TensorFileWriter::add(const std::string& field, const TensorFile::Shape& shape,
                           const std::vector<float>& values) {
  fields_.push_back(
      {field, 10, shape,
       std::string(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float))});
}

void TensorFileWriter::add(const std::string& field, std::string_view bytes) {
  fields_.push_back({field, 1, {bytes.size()}, std::string(bytes)});
}

std::string TensorFileWriter::bytes() const {
  std::uint64_t offset = tensor_magic.size() + tensor_version.size() + sizeof(std::uint32_t);
  for (const Field& field : fields_) offset += 2 + field.name.size() + 2 + 1 + 8 + 8 * field.shape.size();
  std::string bytes(tensor_magic);
  put(bytes, tensor_version);
  put(bytes, std::uint32_t(fields_.size()));
  for (const Field& field : fields_) {
    put(bytes, std::uint16_t(field.name.size()));
    bytes += field.name;
    put(bytes, std::uint16_t(field.shape.size()));
    put(bytes, field.type);
    put(bytes, offset);
    for (const std::uint64_t size : field.shape) put(bytes, size);
    offset += field.bytes.size();
  }
  for (const Field& field : fields_) bytes += field.bytes;
  return bytes;
}

}  // namespace twinray
