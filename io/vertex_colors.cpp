// SPDX-License-Identifier: Apache-2.0
#include "io/vertex_colors.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include "core/texture_parts.h"
#include "io/picture/picture_meaning.h"

namespace twinray {
namespace {

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

}  // namespace

bool is_drawn_of_vertices(std::span<const Texture> textures, std::uint32_t texture) {
  const TextureModel& model = textures[texture].model;
  const auto* picture = std::get_if<ImageTexture>(&model);
  bool found = picture && picture->of_vertices;
  for_each_part(model, [&](std::uint32_t part) { found = found || is_drawn_of_vertices(textures, part); });
  return found;
}

bool can_draw_vertices(const Mesh& mesh) {
  return mesh.triangles.size() <= std::size_t(most_texture_pixels) / 4;
}

/// Of each triangle the values of its corners and, opposite to the first one, what makes them a plane.
ImageTexture draw_vertices(const Mesh& mesh, const std::function<Rgb(std::uint32_t)>& value) {
  const Blocks blocks(mesh.triangles.size());
  Image image(blocks.width(), blocks.height());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    const int x = blocks.x(i), y = blocks.y(i);
    image.at(x, y) = value(a), image.at(x + 1, y) = value(b), image.at(x, y + 1) = value(c);
    image.at(x + 1, y + 1) = value(b) + value(c) - value(a);
  }
  std::vector<Image> levels;
  levels.push_back(std::move(image));  // A smaller level would mix triangles.
  return {.image = std::make_shared<const MipMap>(std::move(levels)),
          .wrap = WrapMode::clamp,
          .filter = TextureFilter::bilinear,
          .of_vertices = true};
}

void set_drawn_uvs(Mesh& mesh, CoordinateSet set) {
  const bool is_first = set == CoordinateSet::first;
  std::vector<Vec2>& uvs = is_first ? mesh.uvs : mesh.second_uvs;
  std::vector<Triangle>& indices = is_first ? mesh.uv_indices : mesh.second_uv_indices;
  const Blocks blocks(mesh.triangles.size());
  uvs.clear();
  indices.clear();
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto first = std::uint32_t(uvs.size());
    const int x = blocks.x(i), y = blocks.y(i);
    for (const Vec2 uv : {blocks.uv(x, y), blocks.uv(x + 1, y), blocks.uv(x, y + 1)}) uvs.push_back(uv);
    indices.push_back({first, first + 1, first + 2});
  }
}

}  // namespace twinray
