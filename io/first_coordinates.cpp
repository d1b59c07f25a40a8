// SPDX-License-Identifier: Apache-2.0
#include "io/first_coordinates.h"

#include <algorithm>

namespace twinray {
namespace {

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
    texture.model = ConstantTexture{std::get<ImageTexture>(texture.model).image->mean()};
    losses.add("a picture by second texture coordinates is its mean color",
               "{} pictures by second texture coordinates are their mean colors");
  }
  return made;
}

}  // namespace twinray
