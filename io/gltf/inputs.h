// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/material.h"
#include "io/gltf/texture.h"

namespace twinray {

struct GltfContext;

/// A material while its parts are read: numbers that are the same everywhere go into its model, pictures
/// become textures of it.
struct GltfInputs {
  GltfTextures& textures;
  GltfContext& context;
  int uv_set = -1;           ///< The first set of texture coordinates of the mesh; -1: none.
  int second_uv_set = -1;    ///< The second one, by which colors and numbers may go, but no more; -1: none.
  bool is_mirrored = false;  ///< The first ones run the other way round.
  Material material = {};
  Principled model = {};
  std::vector<int> missing_sets = {};  ///< That textures name and the mesh does not have.

  /// Whether a slot has a picture that goes by the first texture coordinates. Warns where it goes by others.
  bool can_use(const GltfSlot& slot) const;
  /// The texture coordinates by which a slot's picture goes; none where it has no picture or, with a warning,
  /// goes by further ones.
  std::optional<CoordinateSet> coordinates(const GltfSlot& slot) const;
  bool is_missing(int set) const;
  /// Colours encoded as sRGB has it, times a factor.
  void color(MaterialInput input, const GltfSlot& slot, const Rgb& factor);
  /// One channel as it stands, times a factor.
  void number(MaterialInput input, const GltfSlot& slot, PictureChannels channel, float factor);
  /// A number that goes from `at_0` to `at_1` as one channel does.
  void between(MaterialInput input, const GltfSlot& slot, PictureChannels channel, float at_0, float at_1);
};

}  // namespace twinray
