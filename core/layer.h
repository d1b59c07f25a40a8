// SPDX-License-Identifier: Apache-2.0
// What a picture may show beside its colours, layer by layer.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "core/light_division.h"

namespace twinray {

/// What a layer shows. "The first surface" is the one that the camera ray hits; where it is a mirror, smooth
/// glass or the like, albedo and normal are those of what is seen in it (integrators/layer_records.h).
enum class Layer : std::size_t {
  alpha,             ///< 1 where the camera ray hits something or an environment is behind all, else 0.
  albedo,            ///< Reflectance, in [0, 1]; black where nothing is hit.
  normal,            ///< The unit shading normal on the viewer's side; zero where nothing is hit.
  geometric_normal,  ///< The first surface's, unit, on the viewer's side; zero where nothing is hit.
  depth,             ///< Of the first surface, along the camera's axis.
  position,          ///< Of the first surface.
  uv,                ///< The first surface's texture coordinates.
  ids,               ///< Of the first surface's shape, material and instance, from 1 on; 0: there is none.
  samples,           ///< How many samples the pixel has.
  variance,          ///< Of the pixel's luminance: that of one sample, over the number of samples.
  // How much of the pixel each thing covers, for mattes (Cryptomatte 1.2):
  object_matte,
  material_matte,
  asset_matte,  ///< What objects belong to (Scene::assets).
};
inline constexpr std::size_t layer_count = 13;

/// How the samples of a pixel become its value in a layer.
enum class Gathering {
  mean,      ///< Their mean.
  first,     ///< The value of the sample with the least index that has one: of points and ids no mean is one.
  of_color,  ///< What the sums of the colours say: nothing else is kept.
  coverage,  ///< How many of them have each id, as record_id() keeps it.
};

/// What is known of a layer, whatever the scene.
struct LayerInfo {
  const char* name;                   ///< As --layers takes it.
  std::vector<std::string> channels;  ///< As files name them: 1 to 3; of coverage, 2 for each rank.
  Gathering gathering;
  bool is_half;       ///< 16 bits say enough in a file: it lies in [-1, 1].
  float nothing = 0;  ///< What each channel is where the pixel has no value.
};
const LayerInfo& layer_info(Layer layer);
std::size_t channel_count(Layer layer);

/// All layers, in their order.
std::vector<Layer> all_layers();

/// Of coverage: how many ids of a pixel a file has, those that cover most of it.
inline constexpr std::size_t coverage_ranks = 6;

/// What a picture's film keeps besides its colours.
struct FilmContents {
  std::vector<Layer> layers;  ///< In this order, each once.
  PartCounts parts{};         ///< Of the light.

  bool are_any() const { return !layers.empty() || parts != PartCounts{}; }
  bool operator==(const FilmContents&) const = default;
};

}  // namespace twinray
