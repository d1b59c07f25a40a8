// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace twinray {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
enum class PlyFormat { ascii, little_endian, big_endian };

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  bool is_list = false;
  PlyType count_type = PlyType::uint8;  ///< Of a list.
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  /// The index of the property; -1 where there is none.
  int find(std::string_view property) const;
  /// The fewest bytes that one takes in a file of this format.
  std::uint64_t least_bytes(PlyFormat format) const;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;
  std::vector<PlyElement> elements;
  std::size_t size = 0;        ///< Bytes up to the data.
  bool names_picture = false;  ///< A comment says which one, as MeshLab writes it.
};

/// Of a binary file.
std::size_t size_of(PlyType type);
bool is_whole(PlyType type);

/// Reads the header of a file. Throws Error with line and column where it is none.
PlyHeader read_ply_header(std::string_view bytes, const std::string& name);

}  // namespace twinray
