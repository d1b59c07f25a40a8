// SPDX-License-Identifier: Apache-2.0
// What the viewer tev takes over TCP: packets of their length, an operation and its values. Numbers are
// little-endian, texts end with a zero. It never answers.
#pragma once
#include <string>
#include <vector>

namespace twinray {

/// A picture for a viewer.
struct ViewerPicture {
  std::string name;  ///< Without a zero; a viewer has one picture of each name.
  int width = 0, height = 0;
  std::vector<std::string> channels;  ///< "R", "G", "B", ...
  std::vector<float> values;          ///< Row by row from the top left, all channels of a pixel together.
};

/// Makes the viewer open a picture of this size and these channels, whose pixels are black.
std::string create_packet(const ViewerPicture& picture);

/// Gives it the pixels of the rows from y0 to y1 (not included).
std::string update_packet(const ViewerPicture& picture, int y0, int y1);

/// How many rows a packet may have, one at least: about a megabyte, more than which older viewers refuse.
int rows_a_packet(const ViewerPicture& picture);

}  // namespace twinray
