// SPDX-License-Identifier: Apache-2.0
#include "accel/compact/node.h"

#include <algorithm>

namespace twinray {

CompactNode::CompactNode(const WideNode& node) : planes{}, child_count(std::uint32_t(node.count())) {
  std::copy(std::begin(node.children), std::end(node.children), children);
  for (int axis = 0; axis < 3; ++axis) {
    Extent extents[WideNode::width];
    for (std::uint32_t child = 0; child < child_count; ++child)
      extents[child] = {node.planes[axis][0][child], node.planes[axis][1][child]};
    grids[axis] = fit_grid({extents, child_count});
    for (std::uint32_t child = 0; child < child_count; ++child) {
      planes[axis][0][child] = std::uint8_t(grids[axis].last_below(extents[child].lower));
      planes[axis][1][child] = std::uint8_t(grids[axis].first_above(extents[child].upper));
    }
  }
}

}  // namespace twinray
