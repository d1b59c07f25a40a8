// SPDX-License-Identifier: Apache-2.0
// What a picture may show beside its colours, layer by layer.
#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

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
  // The light of the picture by the paths that it took (integrators/light_parts.h): these add up to it.
  emission,     ///< Of what the camera sees directly.
  environment,  ///< Seen directly behind all.
  diffuse_direct,
  diffuse_indirect,
  glossy_direct,
  glossy_indirect,
  transmission_direct,
  transmission_indirect,
};
inline constexpr std::size_t layer_count = 18;

/// How the samples of a pixel become its value in a layer.
enum class Gathering {
  mean,      ///< Their mean.
  first,     ///< The value of the sample with the least index that has one: of points and ids no mean is one.
  of_color,  ///< What the sums of the colours say: nothing else is kept.
  part  ///< Their mean; all parts together are the colours, to the last bit. They are kept together or not.
};

/// What is known of a layer, whatever the scene.
struct LayerInfo {
  const char* name;                   ///< As --layers takes it.
  std::vector<const char*> channels;  ///< 1 to 3, as files name them.
  Gathering gathering;
  bool is_half;       ///< 16 bits say enough in a file: it lies in [-1, 1].
  float nothing = 0;  ///< What each channel is where the pixel has no value.
};
const LayerInfo& layer_info(Layer layer);
std::size_t channel_count(Layer layer);

/// All layers, in their order.
std::vector<Layer> all_layers();
/// Those that are parts of the colours.
std::vector<Layer> light_parts();

}  // namespace twinray
