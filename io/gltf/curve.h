// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace twinray {

/// Values that keys give at their times (appendix C of the glTF specification).
struct GltfCurve {
  const std::vector<float>& times;   ///< Ascending, at least one.
  const std::vector<float>& values;  ///< `numbers` a key; of a spline, three times as many: tangent that
                                     ///< comes in, value, tangent that goes out.
  std::size_t numbers = 1;
  std::string interpolation;  ///< "STEP", "LINEAR" or "CUBICSPLINE".
  bool is_rotation = false;   ///< The four numbers are a quaternion, which turns evenly and the shorter way.

  /// The value at a time; before the first key and behind the last one, theirs.
  std::vector<double> at(double seconds) const;
};

}  // namespace twinray
