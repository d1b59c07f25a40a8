// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/primitive.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <charconv>
#include <iterator>

#include "io/gltf/attributes.h"
#include "io/gltf/document.h"
#include "io/gltf/draco.h"
#include "io/gltf/formats.h"
#include "io/gltf/schema.h"
#include "io/gltf/slot.h"
#include "io/gltf/uv_area.h"

namespace twinray {
namespace {

/// Corners of triangles, three each, of a list of vertices: lists, strips and fans (section 3.7.2.1 of the
/// specification).
std::vector<Triangle> triangles_of(const std::vector<std::uint32_t>& corners, int mode) {
  std::vector<Triangle> triangles;
  const std::size_t count = corners.size();
  if (mode == TINYGLTF_MODE_TRIANGLES) {
    triangles.reserve(count / 3);
    for (std::size_t i = 0; i + 2 < count; i += 3)
      triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
    return triangles;
  }
  for (std::size_t i = 0; i + 2 < count; ++i)
    if (mode == TINYGLTF_MODE_TRIANGLE_FAN)
      triangles.push_back({corners[i + 1], corners[i + 2], corners[0]});
    else
      triangles.push_back({corners[i], corners[i + 1 + i % 2], corners[i + 2 - i % 2]});
  return triangles;
}

/// The vertex attributes of a primitive, wherever they are.
class PrimitiveAttributes {
 public:
  PrimitiveAttributes(GltfDocument& document, const tinygltf::Primitive& primitive, std::string pointer)
      : document_(document), primitive_(primitive), pointer_(std::move(pointer)) {
    if (primitive.extensions.count(draco_extension) > 0) draco_ = decode_draco(document, primitive, pointer_);
  }

  bool has(const std::string& name) const { return primitive_.attributes.count(name) > 0; }
  std::string pointer_of(const std::string& name) const {
    return fmt::format("{}/attributes/{}", pointer_, name);
  }

  GltfNumbers numbers(const std::string& name) {
    const int accessor = primitive_.attributes.at(name);
    const GltfFormat& format = vertex_format(name);
    if (!draco_ || !draco_->attributes.contains(name)) return read_numbers(document_, accessor, format);
    require_format(document_, accessor, format);
    require_finite(document_, accessor, format, draco_->attributes[name]);
    return draco_->attributes[name];
  }

  /// Those that only what moves the vertices asks for.
  std::map<std::string, GltfNumbers> of_joints() const {
    std::map<std::string, GltfNumbers> found;
    if (draco_)
      std::copy_if(draco_->attributes.begin(), draco_->attributes.end(), std::inserter(found, found.end()),
                   [](const auto& each) {
                     return each.first.starts_with("JOINTS_") || each.first.starts_with("WEIGHTS_");
                   });
    return found;
  }

  /// Draco has triangles in place of strips.
  int mode() const { return draco_ ? TINYGLTF_MODE_TRIANGLES : primitive_.mode; }

  /// The corners of all triangles, in order.
  std::vector<std::uint32_t> corners(std::size_t positions) {
    std::vector<std::uint32_t> corners;
    if (draco_) {
      corners = draco_->indices;
    } else if (const int accessor = indices(); accessor >= 0) {
      corners = read_indices(document_, accessor);
      check_restart(corners, largest_index(document_, accessor), positions);
    } else {
      corners.resize(positions);
      for (std::size_t i = 0; i < positions; ++i) corners[i] = std::uint32_t(i);
    }
    for (std::size_t i = 0; i < corners.size(); ++i)
      if (corners[i] >= positions)
        document_.context().fail(pointer_ + "/indices",
                                 fmt::format("the index {} (number {}) is out of range; valid are 0 to {}",
                                             corners[i], i, positions - 1));
    return corners;
  }

 private:
  void check_restart(const std::vector<std::uint32_t>& corners, std::uint32_t largest,
                     std::size_t positions) const {
    const auto found = std::find(corners.begin(), corners.end(), largest);
    if (found != corners.end())
      document_.context().fail(
          pointer_ + "/indices",
          fmt::format(
              "the index {} (number {}) is the largest of its type, which names no vertex (elsewhere it "
              "restarts a strip); valid are 0 to {}",
              largest, found - corners.begin(), std::min<std::size_t>(positions, largest) - 1));
  }

  /// The accessor; -1: none.
  int indices() const {
    const GltfExtension moved(primitive_.extensions, moved_indices, pointer_);
    return moved ? int(moved.number("indices", -1)) : primitive_.indices;
  }

  GltfDocument& document_;
  const tinygltf::Primitive& primitive_;
  std::string pointer_;
  std::optional<DracoMesh> draco_;
};

class PrimitiveBuilder {
 public:
  PrimitiveBuilder(GltfDocument& document, const tinygltf::Primitive& source, const std::string& pointer)
      : document_(document), source_(source), attributes_(document, source, pointer) {
    made_.pointer = pointer;
    made_.material = source.material;
  }

  GltfPrimitive build() {
    made_.positions = vectors("POSITION");
    const std::vector<std::uint32_t> corners = attributes_.corners(made_.positions.size());
    if (attributes_.mode() == TINYGLTF_MODE_TRIANGLES && corners.size() % 3 != 0)
      document_.context().warn(made_.pointer,
                               fmt::format("{} corners are not three a triangle; the last {} are left out",
                                           corners.size(), corners.size() % 3));
    made_.triangles = triangles_of(corners, attributes_.mode());
    made_.unpacked = attributes_.of_joints();
    if (attributes_.has("NORMAL")) made_.normals = vectors("NORMAL");
    if (attributes_.has("COLOR_0")) made_.colors = numbers("COLOR_0");
    for (const auto& [name, accessor] : source_.attributes) read_uvs(name);
    if (attributes_.has("TANGENT")) read_tangents();
    return std::move(made_);
  }

 private:
  /// One row for each position.
  GltfNumbers numbers(const std::string& name) {
    GltfNumbers numbers = attributes_.numbers(name);
    if (name != "POSITION" && numbers.count != made_.positions.size())
      document_.context().fail(attributes_.pointer_of(name),
                               fmt::format("{} values for {} positions; there must be as many", numbers.count,
                                           made_.positions.size()));
    return numbers;
  }

  std::vector<Vec3> vectors(const std::string& name) {
    const GltfNumbers list = numbers(name);
    std::vector<Vec3> vectors(list.count);
    for (std::size_t i = 0; i < list.count; ++i) vectors[i] = list.vec3(i);
    return vectors;
  }

  /// Where tangents point is the texture coordinates' matter; a file that has it otherwise is told so.
  void read_tangents() {
    const GltfNumbers list = numbers("TANGENT");
    std::vector<Vec3> tangents;
    for (std::size_t i = 0; i < list.count; ++i) {
      tangents.push_back(list.vec3(i));
      made_.handedness.push_back(list.at(i, 3) < 0 ? -1.0f : 1.0f);
    }
    for (const auto& [set, uvs] : made_.uvs)
      if (are_turned(tangents, uvs)) made_.turned_uvs.insert(set);
  }

  /// Whether tangents point elsewhere than where u grows, by more than 30 degrees in a twentieth of the
  /// triangles: programs that make them of texture coordinates smooth them.
  bool are_turned(const std::vector<Vec3>& tangents, const std::vector<Vec2>& uvs) const {
    constexpr float most = 0.75f;  // The square of 30 degrees' cosine.
    std::size_t turned = 0;
    for (const Triangle& triangle : made_.triangles) {
      const auto& [a, b, c] = triangle;
      const Vec3 p = made_.positions[b] - made_.positions[a], q = made_.positions[c] - made_.positions[a];
      const float pv = uvs[b].y - uvs[a].y, qv = uvs[c].y - uvs[a].y;
      const Vec3 along = (p * qv - q * pv) * (uv_area(uvs, triangle) < 0 ? -1.0f : 1.0f);
      const float cosine = dot(along, tangents[a]);
      if (length_squared(along) == 0) continue;
      turned +=
          !(cosine > 0 && cosine * cosine >= most * length_squared(along) * length_squared(tangents[a]));
    }
    return turned > made_.triangles.size() / 20;
  }

  /// A material names sets up to 255. The format's v runs downwards, ours upwards.
  void read_uvs(const std::string& name) {
    constexpr std::string_view prefix = "TEXCOORD_";
    if (!name.starts_with(prefix) || !fault_of_attribute("primitive", name).empty()) return;
    std::uint8_t set = 0;
    const char* const end = name.data() + name.size();
    if (std::from_chars(name.data() + prefix.size(), end, set).ec != std::errc{}) return;
    const GltfNumbers list = numbers(name);
    std::vector<Vec2>& uvs = made_.uvs[set];
    uvs.reserve(list.count);
    for (std::size_t i = 0; i < list.count; ++i) {
      const Vec2 uv = list.vec2(i);
      const bool is_good = std::isfinite(uv.x) && std::isfinite(uv.y);
      uvs.push_back(is_good ? Vec2{uv.x, 1 - uv.y} : Vec2{0, 0});
      if (!is_good)
        document_.context().warn(attributes_.pointer_of(name),
                                 "texture coordinates that are not finite are 0");
    }
  }

  GltfDocument& document_;
  const tinygltf::Primitive& source_;
  PrimitiveAttributes attributes_;
  GltfPrimitive made_;
};

}  // namespace

std::optional<GltfPrimitive> read_primitive(GltfDocument& document, int mesh, int primitive) {
  const tinygltf::Primitive& source =
      document.model().meshes[std::size_t(mesh)].primitives[std::size_t(primitive)];
  const std::string pointer = fmt::format("/meshes/{}/primitives/{}", mesh, primitive);
  if (source.mode < TINYGLTF_MODE_TRIANGLES) {
    document.context().warn(pointer, source.mode == TINYGLTF_MODE_POINTS
                                         ? "points are not rendered; this primitive is left out"
                                         : "lines are not rendered; this primitive is left out");
    return std::nullopt;
  }
  if (source.attributes.count("POSITION") == 0) {
    document.context().warn(pointer, "this primitive has no POSITION, and is left out");
    return std::nullopt;
  }
  GltfPrimitive made = PrimitiveBuilder(document, source, pointer).build();
  made.mesh = mesh, made.index = primitive;
  return made;
}

}  // namespace twinray
