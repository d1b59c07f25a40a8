// SPDX-License-Identifier: Apache-2.0
#include "io/ply/reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <tuple>
#include <utility>

#include "core/mesh_area.h"
#include "io/decimal.h"
#include "io/diagnostic.h"
#include "io/picture/srgb.h"
#include "io/ply/header.h"
#include "io/polygon.h"

namespace twinray {
namespace {

/// The numbers behind a header, one after the other.
class Numbers {
 public:
  Numbers(std::string_view bytes, const std::string& name, const PlyHeader& header)
      : bytes_(bytes), name_(name), format_(header.format), at_(header.size) {}

  std::size_t left() const { return bytes_.size() - at_; }

  double next(PlyType type) {
    if (format_ == PlyFormat::ascii) return next_word();
    const std::size_t size = size_of(type);
    if (left() < size) fail_cut();
    std::array<char, 8> raw;
    std::memcpy(raw.data(), bytes_.data() + at_, 8 <= left() ? 8 : size);
    at_ += size;
    if (format_ == PlyFormat::big_endian) std::reverse(raw.begin(), raw.begin() + std::ptrdiff_t(size));
    return value(raw, type);
  }

  /// What a list's length or an index is; throws Error for less than 0 and for more than `most`.
  std::uint64_t whole(PlyType type, std::uint64_t most, const char* what) {
    const double number = next(type);
    if (number >= 0 && number <= double(most) && number == std::floor(number)) return std::uint64_t(number);
    fail(fmt::format("{} {:g} is out of range; valid are whole numbers from 0 to {}", what, number, most));
  }

  [[noreturn]] void fail(const std::string& message) const {
    if (format_ == PlyFormat::ascii) throw error_at(place_of(name_, bytes_, last_), message);
    throw Error(fmt::format("{}: {} (before byte {})", name_, message, at_));
  }
  [[noreturn]] void fail_cut() const {
    throw Error(fmt::format("{}: the file ends too early, after {} bytes", name_, bytes_.size()));
  }

 private:
  template <typename Number>
  static double as(const std::array<char, 8>& raw) {
    Number number;
    std::memcpy(&number, raw.data(), sizeof number);
    return double(number);
  }

  static double value(const std::array<char, 8>& raw, PlyType type) {
    switch (type) {
      case PlyType::int8:
        return as<std::int8_t>(raw);
      case PlyType::uint8:
        return as<std::uint8_t>(raw);
      case PlyType::int16:
        return as<std::int16_t>(raw);
      case PlyType::uint16:
        return as<std::uint16_t>(raw);
      case PlyType::int32:
        return as<std::int32_t>(raw);
      case PlyType::uint32:
        return as<std::uint32_t>(raw);
      case PlyType::float32:
        return double(as<float>(raw));
      default:
        return as<double>(raw);
    }
  }

  double next_word() {
    const auto is_space = [](char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; };
    while (at_ < bytes_.size() && is_space(bytes_[at_])) ++at_;
    last_ = at_;
    while (at_ < bytes_.size() && !is_space(bytes_[at_])) ++at_;
    const std::string_view word = bytes_.substr(last_, at_ - last_);
    if (word.empty()) fail_cut();
    const Decimal<double> number = read_decimal<double>(word);
    if (number.fault == DecimalFault::no_number)
      fail(fmt::format("\"{}\" is not a number", word.substr(0, 32)));
    // Whoever needs a finite number says so; others are not asked for.
    return number.fault == DecimalFault::none ? number.value : std::numeric_limits<double>::infinity();
  }

  std::string_view bytes_;
  const std::string& name_;
  PlyFormat format_;
  std::size_t at_, last_ = 0;
};

/// Where a vertex has what.
struct VertexLayout {
  std::array<int, 3> position, normal, color;
  std::array<int, 2> uv, second_uv;
  float white = 1;  ///< The number that stands for 1 in a color: bytes go up to 255.

  explicit VertexLayout(const PlyElement& vertex) {
    position = {vertex.find("x"), vertex.find("y"), vertex.find("z")};
    normal = {vertex.find("nx"), vertex.find("ny"), vertex.find("nz")};
    color = {-1, -1, -1};
    for (const auto& [r, g, b] : {std::tuple{"red", "green", "blue"},
                                  {"diffuse_red", "diffuse_green", "diffuse_blue"},
                                  {"r", "g", "b"}})
      if (!has(color)) color = {vertex.find(r), vertex.find(g), vertex.find(b)};
    if (has(color)) white = whitest(vertex.properties[std::size_t(color[0])].type);
    uv = {-1, -1};
    for (const auto& [u, v] :
         {std::pair{"u", "v"}, {"s", "t"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}})
      if (!has(uv)) uv = {vertex.find(u), vertex.find(v)};
    second_uv = {vertex.find("u2"), vertex.find("v2")};
  }
  /// Whole numbers go up to the largest one of their type, others up to 1.
  static float whitest(PlyType type) {
    if (!is_whole(type)) return 1;
    return type == PlyType::int8 || type == PlyType::uint8 ? 255.0f : 65535.0f;
  }
  template <std::size_t n>
  static bool has(const std::array<int, n>& properties) {
    return std::all_of(properties.begin(), properties.end(), [](int property) { return property >= 0; });
  }
};

class Reader {
 public:
  Reader(std::string_view bytes, const std::string& name, PlyColors colors)
      : header_(read_ply_header(bytes, name)),
        numbers_(bytes, name, header_),
        name_(name),
        reads_colors_(colors == PlyColors::read) {}

  PlyMesh read() {
    ply_.mesh.name = name_;
    for (const PlyElement& element : header_.elements) {
      check_room(element);
      if (element.name == "vertex")
        read_vertices(element);
      else if (element.name == "face")
        read_faces(element);
      else
        for (std::uint64_t i = 0; i < element.count; ++i) skip(element);
      has_strips_ |= element.name == "tristrips";
    }
    if (has_strips_) leave_out("strips of triangles (\"tristrips\")");
    if (header_.names_picture) leave_out("pictures (\"comment TextureFile\")");
    if (!has_vertices_) throw Error(name_ + ": the PLY file has no element \"vertex\"");
    if (!has_faces_)
      throw Error(name_ + ": the PLY file has no element \"face\"" +
                  (has_strips_ ? "; strips of triangles (\"tristrips\") are not read"
                               : ", so it holds points alone"));
    finish();
    return std::move(ply_);
  }

 private:
  void check_room(const PlyElement& element) const {
    const std::uint64_t each = element.least_bytes(header_.format);
    if (element.count > 0 && each == 0)
      throw Error(fmt::format("{}: the elements \"{}\" have no properties", name_, element.name));
    // The last number of an ASCII file needs no space behind it.
    if (each > 0 && element.count > (numbers_.left() + 1) / each)
      throw Error(
          fmt::format("{}: the header promises {} elements \"{}\", and the file is too short for them", name_,
                      element.count, element.name));
    if (element.count > 0xffffffff)
      throw Error(fmt::format("{}: {} elements \"{}\" are more than {}", name_, element.count, element.name,
                              0xffffffff));
  }

  void skip_property(const PlyProperty& property) {
    const std::uint64_t count =
        property.is_list ? numbers_.whole(property.count_type, numbers_.left(), "the length of a list") : 1;
    for (std::uint64_t k = 0; k < count; ++k) numbers_.next(property.type);
  }

  void skip(const PlyElement& element) {
    for (const PlyProperty& property : element.properties) skip_property(property);
  }

  void read_vertices(const PlyElement& vertex) {
    if (has_vertices_) throw Error(name_ + ": the PLY file has two elements \"vertex\"");
    has_vertices_ = true;
    const VertexLayout layout(vertex);
    if (!VertexLayout::has(layout.position))
      throw Error(name_ + ": the vertices need the properties x, y and z");
    const bool has_normal = VertexLayout::has(layout.normal), has_uv = VertexLayout::has(layout.uv),
               has_second_uv = VertexLayout::has(layout.second_uv),
               has_color = reads_colors_ && VertexLayout::has(layout.color);
    Mesh& mesh = ply_.mesh;
    mesh.positions.reserve(vertex.count);
    if (has_normal) mesh.normals.reserve(vertex.count);
    if (has_uv) mesh.uvs.reserve(vertex.count);
    if (has_second_uv) mesh.second_uvs.reserve(vertex.count);
    if (has_color) ply_.colors.reserve(vertex.count);
    std::vector<float> row(vertex.properties.size());
    const auto at = [&](int property) { return row[std::size_t(property)]; };
    for (std::uint64_t i = 0; i < vertex.count; ++i) {
      read_row(vertex, row);
      mesh.positions.push_back({at(layout.position[0]), at(layout.position[1]), at(layout.position[2])});
      if (!is_finite(mesh.positions.back()))
        numbers_.fail(fmt::format("the position of vertex {} is not finite", i));
      if (has_normal)
        mesh.normals.push_back({at(layout.normal[0]), at(layout.normal[1]), at(layout.normal[2])});
      if (has_uv) mesh.uvs.push_back({at(layout.uv[0]), at(layout.uv[1])});
      if (has_second_uv) mesh.second_uvs.push_back({at(layout.second_uv[0]), at(layout.second_uv[1])});
      if (has_color) ply_.colors.push_back(color_of(layout, row));
    }
  }

  /// What scanners and editors write is encoded as sRGB has it.
  static Rgb color_of(const VertexLayout& layout, const std::vector<float>& row) {
    const auto channel = [&](std::size_t c) {
      const float value = row[std::size_t(layout.color[c])] / layout.white;
      return value > 0 ? decode_srgb(std::min(value, 1.0f)) : 0;
    };
    return {channel(0), channel(1), channel(2)};
  }

  void read_row(const PlyElement& element, std::vector<float>& row) {
    for (std::size_t k = 0; k < row.size(); ++k) {
      const PlyProperty& property = element.properties[k];
      if (property.is_list)
        skip_property(property);
      else
        row[k] = float(numbers_.next(property.type));
    }
  }

  /// Told once, of however many elements.
  void leave_out(const char* what) {
    std::vector<std::string>& list = ply_.left_out;
    if (std::find(list.begin(), list.end(), what) == list.end()) list.push_back(what);
  }

  void read_faces(const PlyElement& face) {
    if (!has_vertices_) throw Error(name_ + ": faces stand before the vertices that they name");
    has_faces_ = true;
    const int indices =
        face.find("vertex_indices") >= 0 ? face.find("vertex_indices") : face.find("vertex_index");
    if (indices < 0 || !face.properties[std::size_t(indices)].is_list)
      throw Error(name_ + ": the faces need the list \"vertex_indices\"");
    if (face.find("red") >= 0 || face.find("diffuse_red") >= 0) leave_out("colors of faces");
    if (face.find("texcoord") >= 0) leave_out("texture coordinates of faces' corners");
    ply_.mesh.triangles.reserve(ply_.mesh.triangles.size() + face.count);
    for (std::uint64_t i = 0; i < face.count; ++i)
      for (std::size_t k = 0; k < face.properties.size(); ++k)
        if (int(k) == indices)
          read_face(face.properties[k]);
        else
          skip_property(face.properties[k]);
  }

  void read_face(const PlyProperty& list) {
    const std::size_t vertices = ply_.mesh.positions.size();
    const std::uint64_t count =
        numbers_.whole(list.count_type, max_polygon_corners, "the number of a face's corners");
    corners_.clear();
    for (std::uint64_t k = 0; k < count; ++k) {
      if (vertices == 0) throw Error(name_ + ": faces, and no vertices that they could name");
      corners_.push_back(std::uint32_t(numbers_.whole(list.type, vertices - 1, "the index")));
    }
    const std::size_t before = ply_.mesh.triangles.size();
    if (count < 3)
      ++ply_.flat_faces;
    else if (count == 3 || (count == 4 && !is_folded()))
      for (std::size_t k = 2; k < count; ++k)
        ply_.mesh.triangles.push_back({corners_[0], corners_[k - 1], corners_[k]});
    else
      cut_polygon();
    if (count == 4) ply_.quads += triangles_with_area(before) == 2;
  }

  /// Of those from a number on.
  std::ptrdiff_t triangles_with_area(std::size_t first) const {
    const std::vector<Triangle>& all = ply_.mesh.triangles;
    return std::count_if(all.begin() + std::ptrdiff_t(first), all.end(), [this](const Triangle& triangle) {
      return area_vector(ply_.mesh, triangle).area() > 0;
    });
  }

  /// Whether the diagonal from the first corner to the third lies outside of a face of four: what it cuts off
  /// then faces the other way.
  bool is_folded() const {
    const auto corner = [this](std::size_t i) { return ply_.mesh.positions[corners_[i]]; };
    const Vec3 diagonal = corner(2) - corner(0);
    return dot(cross(corner(1) - corner(0), diagonal), cross(diagonal, corner(3) - corner(0))) < 0;
  }

  void cut_polygon() {
    std::vector<Vec3> positions;
    for (const std::uint32_t corner : corners_) positions.push_back(ply_.mesh.positions[corner]);
    for (const auto& [a, b, c] : triangulate(positions))
      ply_.mesh.triangles.push_back({corners_[a], corners_[b], corners_[c]});
  }

  void finish() {
    Mesh& mesh = ply_.mesh;
    if (!mesh.normals.empty()) mesh.normal_indices = mesh.triangles;
    if (!mesh.uvs.empty()) mesh.uv_indices = mesh.triangles;
    if (!mesh.second_uvs.empty()) mesh.second_uv_indices = mesh.triangles;
  }

  PlyHeader header_;
  Numbers numbers_;
  const std::string& name_;
  const bool reads_colors_;
  PlyMesh ply_;
  std::vector<std::uint32_t> corners_;
  bool has_vertices_ = false, has_faces_ = false, has_strips_ = false;
};

}  // namespace

PlyMesh read_ply(std::string_view bytes, const std::string& name, PlyColors colors) {
  return Reader(bytes, name, colors).read();
}

}  // namespace twinray
