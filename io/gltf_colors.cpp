// SPDX-License-Identifier: Apache-2.0
#include "io/gltf_colors.h"

#include <algorithm>
#include <cmath>

#include "io/gltf_context.h"

namespace twinray {
namespace {

using VertexColors = GltfNumbers;

Rgb color_of(const VertexColors& colors, std::size_t vertex) {
  const auto channel = [&](std::size_t c) {
    const float value = colors.at(vertex, c);
    return value > 0 ? std::min(value, 1.0f) : 0;
  };
  return {channel(0), channel(1), channel(2)};
}

float alpha_of(const VertexColors& colors, std::size_t vertex) {
  if (colors.components < 4) return 1;
  const float value = colors.at(vertex, 3);
  return value > 0 ? std::min(value, 1.0f) : 0;
}

bool are_equal(const VertexColors& colors) {
  for (std::size_t i = 1; i < colors.count; ++i)
    if (color_of(colors, i) != color_of(colors, 0) || alpha_of(colors, i) != alpha_of(colors, 0))
      return false;
  return true;
}

bool has_alpha(const VertexColors& colors) {
  for (std::size_t i = 0; i < colors.count; ++i)
    if (alpha_of(colors, i) != 1) return true;
  return false;
}

/// Where the texels of triangles are: as many in a row as there are rows, about.
class Blocks {
 public:
  explicit Blocks(std::size_t triangles)
      : columns_(std::max<std::size_t>(1, std::size_t(std::ceil(std::sqrt(double(triangles)))))),
        rows_(std::max<std::size_t>(1, (triangles + columns_ - 1) / columns_)) {}

  int width() const { return int(2 * columns_); }
  int height() const { return int(2 * rows_); }
  int x(std::size_t triangle) const { return int(2 * (triangle % columns_)); }
  int y(std::size_t triangle) const { return int(2 * (triangle / columns_)); }
  /// The centre of a texel, as texture coordinates.
  Vec2 uv(int x, int y) const {
    return {float((double(x) + 0.5) / width()), float(1 - (double(y) + 0.5) / height())};
  }

 private:
  std::size_t columns_, rows_;
};

/// Of each triangle the values of its corners and, opposite to the first one, what makes them a plane.
template <typename Value>
std::uint32_t picture_of(const Mesh& mesh, const Blocks& blocks, GltfTextures& textures, const Value& value) {
  Image image(blocks.width(), blocks.height());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    const int x = blocks.x(i), y = blocks.y(i);
    image.at(x, y) = value(a), image.at(x + 1, y) = value(b), image.at(x, y + 1) = value(c);
    image.at(x + 1, y + 1) = value(b) + value(c) - value(a);
  }
  std::vector<Image> levels;
  levels.push_back(std::move(image));  // A smaller level would mix triangles.
  return textures.add("colors of vertices",
                      ImageTexture{.image = std::make_shared<const MipMap>(std::move(levels)),
                                   .wrap = WrapMode::clamp,
                                   .filter = TextureFilter::bilinear});
}

void set_uvs(const Blocks& blocks, Mesh& mesh) {
  mesh.uvs.clear();
  mesh.uv_indices.clear();
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto first = std::uint32_t(mesh.uvs.size());
    const int x = blocks.x(i), y = blocks.y(i);
    for (const Vec2 uv : {blocks.uv(x, y), blocks.uv(x + 1, y), blocks.uv(x, y + 1)}) mesh.uvs.push_back(uv);
    mesh.uv_indices.push_back({first, first + 1, first + 2});
  }
}

}  // namespace

const GltfColors::Drawn& GltfColors::drawn(const GltfPrimitive& primitive, const Mesh& mesh) {
  const auto [entry, is_new] = known_.try_emplace(primitive.pointer);
  if (!is_new) return entry->second;
  const VertexColors& colors = primitive.colors;
  const Blocks blocks(mesh.triangles.size());
  entry->second.color =
      picture_of(mesh, blocks, textures_, [&](std::uint32_t i) { return color_of(colors, i); });
  if (has_alpha(colors))
    entry->second.alpha = picture_of(mesh, blocks, textures_, [&](std::uint32_t i) {
      const float alpha = alpha_of(colors, i);
      return Rgb{alpha, alpha, alpha};
    });
  return entry->second;
}

void GltfColors::add(const GltfPrimitive& primitive, Mesh& mesh, GltfUse& use) {
  const VertexColors& colors = primitive.colors;
  if (colors.count == 0) return;
  if (are_equal(colors)) {
    const float alpha = alpha_of(colors, 0);
    if (color_of(colors, 0) != Rgb{1, 1, 1}) use.color = textures_.constant(color_of(colors, 0));
    if (alpha != 1) use.alpha = textures_.constant({alpha, alpha, alpha});
    return;
  }
  // The largest picture that textures may have.
  constexpr std::size_t most_triangles = most_texture_pixels / 4;
  if (use.has_uvs || mesh.triangles.size() > most_triangles)
    return context_.warn(primitive.pointer + "/attributes/COLOR_0",
                         "colors of vertices beside textures are not rendered, and left out");
  use.color = drawn(primitive, mesh).color;
  use.alpha = drawn(primitive, mesh).alpha;
  set_uvs(Blocks(mesh.triangles.size()), mesh);
}

}  // namespace twinray
