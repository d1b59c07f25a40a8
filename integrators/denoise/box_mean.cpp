// SPDX-License-Identifier: Apache-2.0
#include "integrators/denoise/box_mean.h"

#include <algorithm>

#include "core/parallel.h"

namespace twinray {
namespace {

constexpr std::size_t rows_a_task = 16;

/// The numbers are added anew for each pixel: a running sum would keep a rounding error of the brightest.
Plane mean_across(const Plane& plane, int radius) {
  Plane means(plane.width, plane.height);
  parallel_for(std::size_t(plane.height), rows_a_task, 0, [&](std::size_t begin, std::size_t end) {
    for (int y = int(begin); y < int(end); ++y)
      for (int x = 0; x < plane.width; ++x) {
        const int first = std::max(0, x - radius), last = std::min(plane.width - 1, x + radius);
        float sum = 0;
        for (int i = first; i <= last; ++i) sum += plane.row(y)[i];
        means.row(y)[x] = sum / float(last - first + 1);
      }
  });
  return means;
}

Plane mean_down(const Plane& plane, int radius) {
  Plane means(plane.width, plane.height);
  parallel_for(std::size_t(plane.height), rows_a_task, 0, [&](std::size_t begin, std::size_t end) {
    for (int y = int(begin); y < int(end); ++y) {
      const int first = std::max(0, y - radius), last = std::min(plane.height - 1, y + radius);
      float* const row = means.row(y);
      for (int i = first; i <= last; ++i)
        for (int x = 0; x < plane.width; ++x) row[x] += plane.row(i)[x];
      for (int x = 0; x < plane.width; ++x) row[x] /= float(last - first + 1);
    }
  });
  return means;
}

}  // namespace

Plane box_mean(const Plane& plane, int radius) { return mean_down(mean_across(plane, radius), radius); }

}  // namespace twinray
