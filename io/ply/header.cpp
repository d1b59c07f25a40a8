// SPDX-License-Identifier: Apache-2.0
#include "io/ply/header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "io/byte_order_mark.h"
#include "io/diagnostic.h"

namespace twinray {
namespace {

struct TypeName {
  std::string_view name;
  PlyType type;
};
constexpr std::array<TypeName, 16> type_names{{{"char", PlyType::int8},
                                               {"uchar", PlyType::uint8},
                                               {"short", PlyType::int16},
                                               {"ushort", PlyType::uint16},
                                               {"int", PlyType::int32},
                                               {"uint", PlyType::uint32},
                                               {"float", PlyType::float32},
                                               {"double", PlyType::float64},
                                               {"int8", PlyType::int8},
                                               {"uint8", PlyType::uint8},
                                               {"int16", PlyType::int16},
                                               {"uint16", PlyType::uint16},
                                               {"int32", PlyType::int32},
                                               {"uint32", PlyType::uint32},
                                               {"float32", PlyType::float32},
                                               {"float64", PlyType::float64}}};

/// A line of the header, word by word.
class Line {
 public:
  Line(std::string_view bytes, const std::string& name, std::size_t begin)
      : bytes_(bytes), name_(name), at_(begin), end_(std::min(bytes.find('\n', begin), bytes.size())) {}

  std::size_t behind() const { return std::min(end_ + 1, bytes_.size()); }
  bool has_end() const { return end_ < bytes_.size(); }
  /// "" at its end.
  std::string_view word() {
    while (at_ < end_ && is_blank(bytes_[at_])) ++at_;
    last_ = at_;
    while (at_ < end_ && !is_blank(bytes_[at_])) ++at_;
    return bytes_.substr(last_, at_ - last_);
  }
  /// Throws the error with the place of the last word.
  [[noreturn]] void fail(const std::string& message) const {
    throw error_at(place_of(name_, bytes_, last_), message);
  }

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

  std::string_view bytes_;
  const std::string& name_;
  std::size_t at_, end_, last_ = at_;
};

PlyType read_type(Line& line) {
  const std::string_view word = line.word();
  for (const TypeName& type : type_names)
    if (type.name == word) return type.type;
  line.fail(
      fmt::format("\"{}\" is not a type of numbers; valid are char, uchar, short, ushort, int, uint, "
                  "float and double",
                  word.substr(0, 32)));
}

void read_format(Line& line, PlyHeader& header) {
  const std::string_view word = line.word();
  if (word == "ascii")
    header.format = PlyFormat::ascii;
  else if (word == "binary_little_endian")
    header.format = PlyFormat::little_endian;
  else if (word == "binary_big_endian")
    header.format = PlyFormat::big_endian;
  else
    line.fail(
        fmt::format("there is no format \"{}\"; valid are ascii, binary_little_endian and "
                    "binary_big_endian",
                    word.substr(0, 32)));
}

void read_element(Line& line, PlyHeader& header) {
  PlyElement element{std::string(line.word()), 0, {}};
  const std::string_view count = line.word();
  const auto [stop, error] = std::from_chars(count.data(), count.data() + count.size(), element.count);
  if (error != std::errc() || stop != count.data() + count.size() || count.empty())
    line.fail(
        fmt::format("\"{}\" is not the number of an element: \"element NAME NUMBER\"", count.substr(0, 32)));
  header.elements.push_back(std::move(element));
}

void read_property(Line& line, PlyHeader& header) {
  if (header.elements.empty()) line.fail("a property stands before the first element");
  PlyProperty property;
  Line ahead = line;
  if (ahead.word() == "list") {
    line.word();
    property.is_list = true;
    property.count_type = read_type(line);
    if (!is_whole(property.count_type)) line.fail("the length of a list is a whole number");
  }
  property.type = read_type(line);
  property.name = line.word();
  if (property.name.empty()) line.fail("a property without a name");
  header.elements.back().properties.push_back(std::move(property));
}

}  // namespace

std::size_t size_of(PlyType type) {
  constexpr std::array<std::size_t, 8> sizes{1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[std::size_t(type)];
}

bool is_whole(PlyType type) { return type != PlyType::float32 && type != PlyType::float64; }

int PlyElement::find(std::string_view property) const {
  for (std::size_t i = 0; i < properties.size(); ++i)
    if (properties[i].name == property) return int(i);
  return -1;
}

std::uint64_t PlyElement::least_bytes(PlyFormat format) const {
  std::uint64_t bytes = 0;
  for (const PlyProperty& property : properties)
    bytes += format == PlyFormat::ascii ? 2 : size_of(property.is_list ? property.count_type : property.type);
  return bytes;
}

PlyHeader read_ply_header(std::string_view bytes, const std::string& name) {
  PlyHeader header;
  Line first(bytes, name, mark_size(bytes));
  if (first.word() != "ply") first.fail("not a PLY file: its first line must be \"ply\"");
  std::size_t begin = first.behind();
  bool has_format = false;
  while (true) {
    Line line(bytes, name, begin);
    const std::string_view word = line.word();
    if (!line.has_end() && word.empty()) line.fail("the header does not end: \"end_header\" is missing");
    begin = line.behind();
    if (word == "end_header") break;
    if (word == "format")
      has_format = true, read_format(line, header);
    else if (word == "element")
      read_element(line, header);
    else if (word == "property")
      read_property(line, header);
    else if (word == "comment")
      header.names_picture |= line.word() == "TextureFile";
    else if (word != "obj_info" && !word.empty())
      line.fail(fmt::format("\"{}\" is not a word of a PLY header", word.substr(0, 32)));
  }
  if (!has_format) first.fail("the header has no \"format\" line");
  header.size = begin;
  return header;
}

}  // namespace twinray
