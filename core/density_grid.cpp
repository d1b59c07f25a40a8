// SPDX-License-Identifier: Apache-2.0
// Cells are walked through as by Amanatides and Woo ("A Fast Voxel Traversal Algorithm for Ray Tracing",
// 1987).
#include "core/density_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"

namespace twinray {
namespace {

double between(double a, double b, double part) { return a + (b - a) * part; }

}  // namespace

DensityGrid::DensityGrid(const Size& size, const std::vector<float>& values, const Transform& to_unit)
    : size_(size), to_unit_(to_unit) {
  if (*std::min_element(size.begin(), size.end()) < 1 ||
      *std::max_element(size.begin(), size.end()) > most_cells)
    throw Error(fmt::format("a grid of {} x {} x {} densities; each must be from 1 to {}", size[0], size[1],
                            size[2], most_cells));
  if (const std::size_t cells = std::size_t(size[0]) * std::size_t(size[1]) * std::size_t(size[2]);
      values.size() != cells)
    throw Error(fmt::format("a grid of {} x {} x {} densities has {} numbers; it must have {}", size[0],
                            size[1], size[2], values.size(), cells));
  if (!(std::fabs(to_unit.determinant()) > 0) || !std::isfinite(to_unit.determinant()))
    throw Error("a grid of densities lies in a box that is flat or too large");
  padded_.resize(std::size_t(size[0] + 2) * std::size_t(size[1] + 2) * std::size_t(size[2] + 2));
  auto next = values.begin();
  for (int z = 1; z <= size[2]; ++z)
    for (int y = 1; y <= size[1]; ++y)
      for (int x = 1; x <= size[0]; ++x, ++next) {
        if (!std::isfinite(*next) || *next < 0)
          throw Error(fmt::format("a density is {:g}; it must be finite and >= 0", *next));
        padded_[place(x, y, z)] = *next;
      }
}

DensityGrid::Line DensityGrid::line_of(const Ray& ray) const {
  Line line{};
  const double o[3] = {double(ray.origin.x), double(ray.origin.y), double(ray.origin.z)};
  const double d[3] = {double(ray.direction.x), double(ray.direction.y), double(ray.direction.z)};
  for (std::size_t k = 0; k < 3; ++k) {
    const double* const row = to_unit_.m[k];
    line.origin[k] = (row[0] * o[0] + row[1] * o[1] + row[2] * o[2] + row[3]) * size_[k] + 0.5;
    line.direction[k] = (row[0] * d[0] + row[1] * d[1] + row[2] * d[2]) * size_[k];
  }
  return line;
}

DensityGrid::Corners DensityGrid::corners_of(const std::array<int, 3>& cell) const {
  const std::size_t first = place(cell[0], cell[1], cell[2]);
  const std::size_t row = std::size_t(size_[0] + 2), slice = row * std::size_t(size_[1] + 2);
  const float* const v = padded_.data() + first;
  return {v[0], v[1], v[row], v[row + 1], v[slice], v[slice + 1], v[slice + row], v[slice + row + 1]};
}

double DensityGrid::integral(const Line& line, const std::array<int, 3>& cell, const Corners& corners,
                             double from, double to) {
  const auto density = [&](double t) {
    double part[3];
    for (int k = 0; k < 3; ++k) part[k] = std::clamp(line.at(k, t) - double(cell[std::size_t(k)]), 0.0, 1.0);
    const auto along_x = [&](std::size_t i) {
      return between(double(corners[i]), double(corners[i + 1]), part[0]);
    };
    return between(between(along_x(0), along_x(2), part[1]), between(along_x(4), along_x(6), part[1]),
                   part[2]);
  };
  constexpr double node = 0.57735026918962576;  // 1 / sqrt(3)
  const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
  return half * (density(middle - half * node) + density(middle + half * node));
}

template <typename Visit>
void DensityGrid::walk(const Line& line, double from, double to, const Visit& visit) const {
  for (int k = 0; k < 3; ++k) {
    const double o = line.origin[std::size_t(k)], d = line.direction[std::size_t(k)];
    const double low = 0.5, high = size_[std::size_t(k)] + 0.5;
    if (d == 0) {
      if (o < low || o > high) return;
      continue;
    }
    const double a = (low - o) / d, b = (high - o) / d;
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  if (!(from < to)) return;
  std::array<int, 3> cell{};
  for (int k = 0; k < 3; ++k) {
    const double place = line.at(k, from);
    cell[std::size_t(k)] = std::clamp(int(std::floor(place)), 0, size_[std::size_t(k)]);
  }
  while (true) {
    double next = to;
    std::size_t axis = 3;
    for (std::size_t k = 0; k < 3; ++k) {
      const double d = line.direction[k];
      const double side = (double(cell[k] + (d > 0)) - line.origin[k]) / d;
      if (d != 0 && side < next) next = side, axis = k;
    }
    next = std::max(next, from);
    if (!visit(cell, from, next) || axis == 3) return;
    cell[axis] += line.direction[axis] > 0 ? 1 : -1;
    if (cell[axis] < 0 || cell[axis] > size_[axis]) return;
    from = next;
  }
}

double DensityGrid::amount(const Ray& ray, float from, float to) const {
  const Line line = line_of(ray);
  double sum = 0;
  walk(line, double(from), double(to), [&](const std::array<int, 3>& cell, double a, double b) {
    sum += integral(line, cell, corners_of(cell), a, b);
    return true;
  });
  return sum * double(length(ray.direction));
}

float DensityGrid::reach(const Ray& ray, float from, float to, double amount) const {
  const Line line = line_of(ray);
  double rest = amount / double(length(ray.direction));
  double found = std::numeric_limits<double>::infinity();
  walk(line, double(from), double(to), [&](const std::array<int, 3>& cell, double a, double b) {
    const Corners corners = corners_of(cell);
    const double whole = integral(line, cell, corners, a, b);
    if (whole < rest) {
      rest -= whole;
      return true;
    }
    double low = a, high = b;
    constexpr int halvings = 40;  // More than a float tells apart.
    for (int i = 0; i < halvings; ++i) {
      const double middle = 0.5 * (low + high);
      (integral(line, cell, corners, a, middle) < rest ? low : high) = middle;
    }
    found = high;
    return false;
  });
  return float(found);
}

}  // namespace twinray
