// SPDX-License-Identifier: Apache-2.0
#include "io/first_coordinates.h"

#include <algorithm>
#include <cstdint>

namespace twinray {
namespace {

Rgb mean_of(const MipMap& picture) {
  if (picture.levels() > 1) return picture.level(picture.levels() - 1).at(0, 0);
  const Image image = picture.image(0);
  double r = 0, g = 0, b = 0;
  for (const Rgb& pixel : image.pixels) r += double(pixel.r), g += double(pixel.g), b += double(pixel.b);
  const auto count = double(image.pixels.size());
  return {float(r / count), float(g / count), float(b / count)};
}

bool is_second(const Texture& texture) {
  const auto* image = std::get_if<ImageTexture>(&texture.model);
  return image && image->coordinates == CoordinateSet::second;
}

}  // namespace

std::shared_ptr<const Scene> by_first_coordinates(const Scene& scene, Losses& losses) {
  if (std::none_of(scene.textures.begin(), scene.textures.end(), is_second))
    return {std::shared_ptr<const Scene>(), &scene};
  auto made = std::make_shared<Scene>(scene);
  for (Texture& texture : made->textures) {
    if (!is_second(texture)) continue;
    texture.model = ConstantTexture{mean_of(*std::get<ImageTexture>(texture.model).image)};
    losses.add("a picture by second texture coordinates is its mean color",
               "{} pictures by second texture coordinates are their mean colors");
  }
  return made;
}

}  // namespace twinray
