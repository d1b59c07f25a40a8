// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/colors.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/gltf/context.h"
#include "io/vertex_colors.h"

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

}  // namespace

/// Holes go by the first coordinates alone.
const GltfColors::Drawn& GltfColors::drawn(const GltfPrimitive& primitive, const Mesh& mesh,
                                           CoordinateSet set) {
  const auto [entry, is_new] = known_.try_emplace(primitive.pointer);
  if (!is_new) return entry->second;
  const VertexColors& colors = primitive.colors;
  const auto add = [&](const std::function<Rgb(std::uint32_t)>& value) {
    ImageTexture picture = draw_vertices(mesh, value);
    picture.coordinates = set;
    return textures_.add("colors of vertices", picture);
  };
  entry->second.color = add([&](std::uint32_t i) { return color_of(colors, i); });
  if (set == CoordinateSet::first && has_alpha(colors))
    entry->second.alpha = add([&](std::uint32_t i) {
      const float alpha = alpha_of(colors, i);
      return Rgb{alpha, alpha, alpha};
    });
  return entry->second;
}

void GltfColors::put_darkest_first(const GltfPrimitive& primitive, Mesh& mesh) {
  const VertexColors& colors = primitive.colors;
  if (colors.count == 0) return;
  const auto is_darker = [&](std::uint32_t a, std::uint32_t b) {
    return luminance(color_of(colors, a)) < luminance(color_of(colors, b));
  };
  for (Triangle& t : mesh.triangles)
    std::rotate(t.begin(), std::min_element(t.begin(), t.end(), is_darker), t.end());
  if (!mesh.normal_indices.empty()) mesh.normal_indices = mesh.triangles;
}

void GltfColors::add(const GltfPrimitive& primitive, bool is_unlit, Mesh& mesh, GltfUse& use) {
  const VertexColors& colors = primitive.colors;
  if (colors.count == 0) return;
  if (are_equal(colors)) {
    const float alpha = alpha_of(colors, 0);
    if (color_of(colors, 0) != Rgb{1, 1, 1}) use.color = textures_.constant(color_of(colors, 0));
    if (alpha != 1) use.alpha = textures_.constant({alpha, alpha, alpha});
    return;
  }
  const auto leave_out = [&](const char* what) {
    context_.warn(primitive.pointer + "/attributes/COLOR_0", fmt::format("{} are left out", what));
  };
  if (!can_draw_vertices(mesh)) return leave_out("colors of so many vertices");
  if (use.has_uvs && (use.has_second_uvs || is_unlit))
    return leave_out("colors of vertices beside these textures");
  const CoordinateSet set = use.has_uvs ? CoordinateSet::second : CoordinateSet::first;
  use.color = drawn(primitive, mesh, set).color;
  use.alpha = drawn(primitive, mesh, set).alpha;
  set_drawn_uvs(mesh, set);
  if (use.has_uvs && has_alpha(colors)) leave_out("alphas of vertices beside textures");
}

}  // namespace twinray
