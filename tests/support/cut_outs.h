// SPDX-License-Identifier: Apache-2.0
// Geometry with holes.
#pragma once
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "core/alpha_test.h"
#include "core/scene.h"
#include "tests/support/random.h"

namespace twinray::test {

/// A picture of 16 x 16 alphas: a third each of 0, 1 and what lies between.
inline Texture random_alpha(std::uint64_t seed) {
  Random random(seed);
  Image picture(16, 16);
  for (Rgb& pixel : picture.pixels) {
    const int kind = random.below(3);
    const float alpha = kind == 2 ? random.unit() : float(kind);
    pixel = {alpha, alpha, alpha};
  }
  ImageTexture image{.image = std::make_shared<const MipMap>(std::move(picture))};
  image.filter = TextureFilter::nearest;
  return {"alpha", image};
}

inline Texture constant_alpha(float alpha) { return {"alpha", ConstantTexture{{alpha, alpha, alpha}}}; }

/// Each shape cut out by the texture of the same place in the list; where the list ends the shapes are
/// opaque.
inline std::shared_ptr<const Geometry> share_cut_out(std::vector<Shape> shapes,
                                                     const std::vector<Texture>& textures) {
  std::vector<ShapeBinding> bindings(shapes.size());
  for (std::uint32_t i = 0; i < textures.size(); ++i) bindings[i].alpha = i;
  return std::make_shared<const Geometry>(cut_out(std::move(shapes), bindings, textures));
}

/// Cuts a shape of a scene out by a texture.
inline void set_alpha(Scene& scene, std::uint32_t shape, const Texture& texture) {
  scene.bindings[shape].alpha = std::uint32_t(scene.textures.size());
  scene.textures.push_back(texture);
  scene.geometry =
      std::make_shared<const Geometry>(cut_out(scene.geometry->shapes(), scene.bindings, scene.textures));
  check_scene(scene);
}

}  // namespace twinray::test
