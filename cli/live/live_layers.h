// SPDX-License-Identifier: Apache-2.0
// What of a film can be looked at while it grows.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "core/film.h"

namespace twinray {

/// A part of a film that makes a picture of its own.
struct LiveLayer {
  std::string name;                   ///< "beauty"; else as --layers, or a file's channels, call it.
  std::vector<std::string> channels;  ///< One to three, in short: "R", "G", "B".
  /// What it shows of a pixel of the film. Asked by the thread that last changed it.
  std::function<Rgb(const Film&, int x, int y)> value;
};

/// The film's colours, its layers but for mattes, which have more channels than a picture shows, and the
/// parts of its light.
std::vector<LiveLayer> live_layers(const FilmContents& contents,
                                   const std::vector<std::string>& light_groups);

/// The values of a tile's pixels, row by row, all channels of a pixel together.
void read_tile(const Film& film, const LiveLayer& layer, const PixelRect& tile, std::vector<float>& values);

/// A picture whose values lie row by row from the top left as a file of the format PFM, which has one or
/// three channels: a layer of two gets a black third.
std::string pfm_of(const std::string& values, int width, int height, std::size_t channels);

}  // namespace twinray
