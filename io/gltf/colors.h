// SPDX-License-Identifier: Apache-2.0
// Colours of vertices, as io/vertex_colors.h draws them.
#pragma once
#include <map>
#include <string>

#include "core/geometry.h"
#include "io/gltf/material.h"
#include "io/gltf/primitive.h"

namespace twinray {

struct GltfContext;

class GltfColors {
 public:
  GltfColors(GltfTextures& textures, GltfContext& context) : textures_(textures), context_(context) {}

  /// Adds the colours of a primitive's vertices, if it has any, to the use of its material: the same one for
  /// all as a constant; else a picture, by whose texture coordinates the mesh goes. They are the second ones
  /// of a mesh that has some of its own; where that has two sets, or holes and light would have to go by
  /// them, a warning says that colours or alphas are left out. A primitive has the same picture wherever it
  /// is placed.
  void add(const GltfPrimitive& primitive, bool is_unlit, Mesh& mesh, GltfUse& use);

  /// Turns the corners of triangles so that the darkest is first, if there are colours. Of four texels, whose
  /// last one is what the second and third have beyond the first, the mean is then black for black triangles
  /// alone: by it a picture that emits is judged.
  static void put_darkest_first(const GltfPrimitive& primitive, Mesh& mesh);

 private:
  struct Drawn {
    std::uint32_t color = no_texture, alpha = no_texture;
  };

  const Drawn& drawn(const GltfPrimitive& primitive, const Mesh& mesh, CoordinateSet set);

  GltfTextures& textures_;
  GltfContext& context_;
  std::map<std::string, Drawn> known_;  ///< By the primitive's pointer.
};

}  // namespace twinray
