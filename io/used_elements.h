// SPDX-License-Identifier: Apache-2.0
// The part of a source that a primitive element uses: several may share a large one.
#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/geometry.h"

namespace twinray {

/// The elements, of `count`, that the corners use, each once and in their order.
std::vector<std::uint32_t> used_elements(std::size_t count, const std::vector<Triangle>& corners);

/// Appends element(i) for each used element i, of `count`, and renumbers the corners: they are indices into
/// these. Returns the numbers that they had; nothing where all are used.
template <typename Element, typename At>
std::vector<std::uint32_t> take_used(std::size_t count, const At& element, std::vector<Triangle>& corners,
                                     std::vector<Element>& to) {
  std::vector<std::uint32_t> used = used_elements(count, corners);
  to.reserve(used.size());
  for (const std::uint32_t i : used) to.push_back(element(i));
  if (used.size() == count) return {};
  for (Triangle& triangle : corners)
    for (std::uint32_t& i : triangle)
      i = std::uint32_t(std::lower_bound(used.begin(), used.end(), i) - used.begin());
  return used;
}

}  // namespace twinray
