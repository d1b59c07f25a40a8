// SPDX-License-Identifier: Apache-2.0
// What of a film can be looked at while it grows.
#pragma once
#include <string>
#include <vector>

#include "core/film.h"

namespace twinray {

/// A part of a film that makes a picture of its own.
struct LiveLayer {
  std::string name;                   ///< "beauty"; else as --layers, or a file's channels, call it.
  std::vector<std::string> channels;  ///< One to three, in short: "R", "G", "B".
  enum class Kind { color, layer, part } kind = Kind::color;
  std::size_t index = 0;                ///< Of the film's layers; of the division's parts.
  Division division = Division::paths;  ///< Of a part.
};

/// The film's colours, its layers but for mattes, which have more channels than a picture shows, and the
/// parts of its light.
std::vector<LiveLayer> live_layers(const FilmContents& contents,
                                   const std::vector<std::string>& light_groups);

/// A picture, row by row from the top left: 32-bit floats, little-endian, all channels of a pixel together.
struct LiveValues {
  int width = 0, height = 0;
  std::string bytes;
};
LiveValues live_values(const Film& film, const LiveLayer& layer);

/// The same as a file of the format PFM, which has one or three channels: a layer of two gets a black third.
std::string pfm_of(const LiveValues& values, std::size_t channels);

}  // namespace twinray
