// SPDX-License-Identifier: Apache-2.0
// Private to the writer of glTF: materials, which there say also what a surface emits and where it has holes.
#pragma once
#include <array>
#include <map>
#include <span>
#include <tuple>
#include <vector>

#include "io/gltf/stand_in.h"
#include "io/gltf/writer_texture.h"

namespace twinray {

class GltfMaterialWriter {
 public:
  GltfMaterialWriter(const Scene& scene, GltfFile& file)
      : scene_(scene), file_(file), textures_(scene, file) {}

  /// The index of what a shape of this binding is made of. `is_mirrored`: where its maps of directions lie
  /// mirrored; else of no effect.
  std::size_t material(const ShapeBinding& binding, bool is_mirrored = false);
  /// Whether it has a normal map or a tangent, which the format turns around where it lies mirrored.
  bool needs_handedness(const ShapeBinding& binding) const;
  /// The colours and alphas of vertices with these texture coordinates, where the shape's base colour or its
  /// holes were drawn of such (io/vertex_colors.h); else nothing.
  std::vector<std::array<float, 4>> vertex_colors(const ShapeBinding& binding, std::span<const Vec2> uvs);

 private:
  GltfJson make(const ShapeBinding& binding, bool is_mirrored);
  void add_emission(std::uint32_t light, GltfJson& json);

  const Scene& scene_;
  GltfFile& file_;
  GltfTextureWriter textures_;
  std::map<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, bool>, std::size_t> made_;
};

}  // namespace twinray
