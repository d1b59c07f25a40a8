// SPDX-License-Identifier: Apache-2.0
#include "io/used_elements.h"

namespace twinray {
namespace {

/// Whether so many triangles are worth a mark for each element, of which they may use a few.
bool are_marks_worth_it(std::size_t elements, std::size_t triangles) { return elements <= 16 * triangles; }

}  // namespace

std::vector<std::uint32_t> used_elements(std::size_t count, const std::vector<Triangle>& corners) {
  std::vector<std::uint32_t> used;
  if (are_marks_worth_it(count, corners.size())) {
    std::vector<bool> is_used(count);
    for (const Triangle& triangle : corners)
      for (const std::uint32_t i : triangle) is_used[i] = true;
    for (std::uint32_t i = 0; i < count; ++i)
      if (is_used[i]) used.push_back(i);
    return used;
  }
  for (const Triangle& triangle : corners) used.insert(used.end(), triangle.begin(), triangle.end());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  return used;
}

}  // namespace twinray
