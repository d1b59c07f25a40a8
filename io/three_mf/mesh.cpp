// SPDX-License-Identifier: Apache-2.0
#include "io/three_mf/mesh.h"

#include <fmt/format.h>

#include <array>
#include <map>
#include <tuple>

#include "io/decimal.h"
#include "io/used_elements.h"

namespace twinray {
namespace {

float coordinate(const XmlElement& vertex, const char* name) {
  const std::string text = vertex.required_attribute(name);
  const auto [value, fault] = read_decimal<float>(text);
  if (fault != DecimalFault::none)
    throw error_at(vertex.attribute_place(name),
                   fmt::format("\"{}\" is no coordinate; valid are finite numbers", text));
  return value;
}

std::vector<Vec3> read_vertices(const XmlElement& vertices) {
  std::vector<Vec3> positions;
  for (const XmlElement& vertex : vertices.children("vertex"))
    positions.push_back({coordinate(vertex, "x"), coordinate(vertex, "y"), coordinate(vertex, "z")});
  return positions;
}

Triangle read_corners(const XmlElement& triangle, std::size_t vertices) {
  Triangle corners;
  std::size_t k = 0;
  for (const char* const name : {"v1", "v2", "v3"}) {
    corners[k] = triangle.required_index_attribute(name);
    if (corners[k++] >= vertices)
      throw error_at(
          triangle.attribute_place(name),
          fmt::format("the index {} is out of range; there are {} vertices", corners[k - 1], vertices));
  }
  return corners;
}

/// What the corners of a triangle wear.
using Worn = std::array<std::optional<ThreeMfProperty>, 3>;

Worn read_worn(const XmlElement& triangle, const ThreeMfProperties& properties, const ThreeMfDefault& own) {
  const bool names_group = triangle.attribute("pid").has_value();
  if (!names_group && !(own.group && triangle.attribute("p1")))
    return {own.property, own.property, own.property};
  const std::uint32_t group = names_group ? triangle.required_index_attribute("pid") : *own.group;
  const std::uint32_t p1 = triangle.index_attribute("p1", 0);
  const auto find = [&](std::uint32_t index) { return properties.find(triangle, {group, index}); };
  return {find(p1), find(triangle.index_attribute("p2", p1)), find(triangle.index_attribute("p3", p1))};
}

/// Pieces by what they wear, in the order in which they come.
class Pieces {
 public:
  Pieces(std::string name, const std::vector<Vec3>& positions)
      : name_(std::move(name)), positions_(positions) {}

  void add(const Triangle& corners, const Worn& worn) {
    if (worn[0] && worn[1] && worn[2] &&
        (worn[0]->color != worn[1]->color || worn[0]->color != worn[2]->color))
      add_painted(corners, worn);
    else
      piece_of(worn[0]).mesh.triangles.push_back(corners);
  }
  std::vector<ThreeMfPiece> take() {
    for (ThreeMfPiece& piece : pieces_) {
      piece.mesh.name = name_;
      if (!piece.mesh.positions.empty()) continue;
      take_used(
          positions_.size(), [&](std::uint32_t i) { return positions_[i]; }, piece.mesh.triangles,
          piece.mesh.positions);
    }
    return std::move(pieces_);
  }

 private:
  /// The name, and whether there is a property; its colour.
  using Key = std::tuple<std::string, bool, float, float, float>;

  ThreeMfPiece& piece_of(const std::optional<ThreeMfProperty>& property) {
    const ThreeMfProperty& p = property.value_or(ThreeMfProperty{});
    const auto [entry, is_new] =
        numbers_.try_emplace({p.name, property.has_value(), p.color.r, p.color.g, p.color.b}, pieces_.size());
    if (is_new) pieces_.push_back({{}, property, {}});
    return pieces_[entry->second];
  }
  /// With corners of its own, for a vertex may have another colour in the next triangle.
  void add_painted(const Triangle& corners, const Worn& worn) {
    if (!painted_) {
      painted_ = pieces_.size();
      pieces_.emplace_back();
    }
    ThreeMfPiece& piece = pieces_[*painted_];
    const auto first = std::uint32_t(piece.mesh.positions.size());
    piece.mesh.triangles.push_back({first, first + 1, first + 2});
    for (std::size_t k = 0; k < 3; ++k) {
      piece.mesh.positions.push_back(positions_[corners[k]]);
      piece.colors.push_back(worn[k]->color);
    }
  }

  std::string name_;
  const std::vector<Vec3>& positions_;
  std::vector<ThreeMfPiece> pieces_;
  std::map<Key, std::size_t> numbers_;
  std::optional<std::size_t> painted_;
};

}  // namespace

std::vector<ThreeMfPiece> read_pieces(const XmlElement& mesh, const std::string& name,
                                      const ThreeMfProperties& properties, const ThreeMfDefault& own) {
  const std::vector<Vec3> positions = read_vertices(mesh.required_child("vertices"));
  Pieces pieces(name, positions);
  for (const XmlElement& triangle : mesh.required_child("triangles").children("triangle"))
    pieces.add(read_corners(triangle, positions.size()), read_worn(triangle, properties, own));
  return pieces.take();
}

}  // namespace twinray
