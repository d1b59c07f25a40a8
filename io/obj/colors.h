// SPDX-License-Identifier: Apache-2.0
// Private: colors of an OBJ file's vertices, which programs write in two ways that are not of the format.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/rgb.h"
#include "io/obj/text.h"

namespace twinray {

/// Takes colors in the order of the file. They are encoded as sRGB has it, as MeshLab and Blender write them.
class ObjColors {
 public:
  /// The line of the vertex of this index: "v x y z r g b", and an alpha perhaps. Returns whether it has a
  /// color.
  bool add_vertex(std::size_t index, const ObjNumbers& numbers);
  /// A line of ZBrush, "#MRGB" and of each vertex eight hexadecimal digits: of a mask, which is left out, and
  /// its color. The lines between two vertices are the colors of as many vertices before them.
  void add_painted(std::string_view line);
  /// The colors of all vertices, linear and within [0, 1], white where there are none; or none at all. They
  /// are bytes where a number is above 1 and all are whole, or one is above 16. What is left out or guessed
  /// is noted.
  std::vector<Rgb> take(std::size_t count, std::vector<std::string>& notes);

 private:
  void take_block(std::size_t count);
  bool are_bytes() const { return largest_ > 1 && (are_whole_ || largest_ > 16); }

  std::vector<Rgb> numbers_;  ///< As the lines have them, up to the last one that has a color.
  std::vector<Rgb> painted_;  ///< Those of ZBrush, in [0, 255], up to the last one.
  std::vector<Rgb> block_;    ///< Of them, those behind the last vertex.
  float largest_ = 0;         ///< Of numbers_.
  bool are_whole_ = true;     ///< Of numbers_.
  std::size_t beyond_ = 0;    ///< How many colors of ZBrush are of no vertex.
  bool has_alphas_ = false;
};

}  // namespace twinray
