// SPDX-License-Identifier: Apache-2.0
#include "core/plane.h"

#include <algorithm>

#include "core/parallel.h"

namespace twinray {
namespace {

constexpr std::size_t rows_a_task = 16;

/// sum += weight * source, number by number.
void add(const float* source, float weight, int count, float* sum) {
  for (int i = 0; i < count; ++i) sum[i] += weight * source[i];
}

void filter_across(const float* row, const Kernel& kernel, int width, float* sum) {
  const int radius = int(kernel.size()) / 2;
  std::vector<float> padded(std::size_t(width) + kernel.size() - 1);
  for (int i = 0; i < int(padded.size()); ++i)
    padded[std::size_t(i)] = row[std::clamp(i - radius, 0, width - 1)];
  for (std::size_t k = 0; k < kernel.size(); ++k) add(&padded[k], kernel[k], width, sum);
}

void filter_down(const Plane& plane, const Kernel& kernel, int y, float* sum) {
  const int radius = int(kernel.size()) / 2;
  for (int k = 0; k < int(kernel.size()); ++k)
    add(plane.row(std::clamp(y + k - radius, 0, plane.height - 1)), kernel[std::size_t(k)], plane.width, sum);
}

template <class Body>
void for_each_row(int height, const Body& body) {
  parallel_for(std::size_t(height), rows_a_task, 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t y = begin; y < end; ++y) body(int(y));
  });
}

}  // namespace

Plane filtered(const Plane& plane, const Kernel& across, const Kernel& down) {
  Plane half(plane.width, plane.height), whole(plane.width, plane.height);
  for_each_row(plane.height, [&](int y) { filter_across(plane.row(y), across, plane.width, half.row(y)); });
  for_each_row(plane.height, [&](int y) { filter_down(half, down, y, whole.row(y)); });
  return whole;
}

}  // namespace twinray
