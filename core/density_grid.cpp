// SPDX-License-Identifier: Apache-2.0
// Bricks, and the cells in them, are walked through as by Amanatides and Woo ("A Fast Voxel Traversal
// Algorithm for Ray Tracing", 1987).
#include "core/density_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"

namespace twinray {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();
constexpr std::size_t row_points = 9, slice = row_points * row_points,
                      brick_size = row_points * slice;  // Of a brick's points.

double between(double a, double b, double part) { return a + (b - a) * part; }

/// Calls visit(box, from, to) for each box of a lattice of this width that the line goes through, in order,
/// as long as it returns true and the boxes are within `first` to `last`.
template <typename Line, typename Index, typename Visit>
void walk_boxes(const Line& line, int width, const Index& first, const Index& last, double from, double to,
                const Visit& visit) {
  Index box{};
  double inverse[3], next[3];
  const auto side_of = [&](std::size_t k) {
    return (double((box[k] + (line.direction[k] > 0)) * width) - line.origin[k]) * inverse[k];
  };
  for (std::size_t k = 0; k < 3; ++k) {
    box[k] = std::clamp(int(std::floor(line.at(k, from) / width)), first[k], last[k]);
    inverse[k] = 1 / line.direction[k];
    next[k] = line.direction[k] != 0 ? side_of(k) : never;
  }
  while (true) {
    const std::size_t axis = next[0] < next[1] ? (next[0] < next[2] ? 0 : 2) : (next[1] < next[2] ? 1 : 2);
    const bool is_last = !(next[axis] < to);
    const double end = std::max(is_last ? to : next[axis], from);
    if (!visit(box, from, end) || is_last) return;
    box[axis] += line.direction[axis] > 0 ? 1 : -1;
    if (box[axis] < first[axis] || box[axis] > last[axis]) return;
    next[axis] = side_of(axis);
    from = end;
  }
}

}  // namespace

class DensityGrid::CellOnLine {
 public:
  CellOnLine(const float* brick, const Index& cell, const Line& line) : direction_(line.direction) {
    const auto within = [](int at) { return std::size_t(at % cells); };
    corners_ = brick + within(cell[2]) * slice + within(cell[1]) * row_points + within(cell[0]);
    for (std::size_t k = 0; k < 3; ++k) origin_[k] = line.origin[k] - double(cell[k]);
  }

  double density(double t) const {
    const double x = origin_[0] + direction_[0] * t, y = origin_[1] + direction_[1] * t,
                 z = origin_[2] + direction_[2] * t;
    const auto along_x = [&](std::size_t i) {
      return between(double(corners_[i]), double(corners_[i + 1]), x);
    };
    return between(between(along_x(0), along_x(row_points), y),
                   between(along_x(slice), along_x(slice + row_points), y), z);
  }
  double integral(double from, double to) const {
    constexpr double node = 0.57735026918962576;  // 1 / sqrt(3)
    const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
    return half * (density(middle - half * node) + density(middle + half * node));
  }
  /// Up to which the integral is so much, which it is up to `to`: by Newton's steps, or halves where these
  /// lead out of what is left.
  double reach(double from, double to, double amount) const {
    double low = from, high = to, t = 0.5 * (from + to);
    constexpr int most_steps = 60;
    constexpr double enough = 0x1p-40;  // More than a float tells apart.
    for (int i = 0; i < most_steps && high - low > enough * (to - from); ++i) {
      const double rest = amount - integral(from, t);
      (rest > 0 ? low : high) = t;
      const double next = t + rest / density(t);
      if (std::fabs(next - t) < enough * (to - from)) break;
      t = next > low && next < high ? next : 0.5 * (low + high);
    }
    return t;
  }

 private:
  const float* corners_;  ///< The lowest of eight.
  std::array<double, 3> origin_, direction_;
};

DensityGrid::DensityGrid(const Size& size, const Transform& to_unit) : size_(size), to_unit_(to_unit) {
  const auto [least, most] = std::minmax_element(size.begin(), size.end());
  if (*least < 1 || *most > most_cells)
    throw Error(fmt::format("a grid of {} x {} x {} densities; each must be from 1 to {}", size[0], size[1],
                            size[2], most_cells));
  if (std::int64_t(size[0]) * size[1] * size[2] > most_cells_in_all)
    throw Error(fmt::format("a grid of {} x {} x {} densities; in all they must not be more than {}", size[0],
                            size[1], size[2], most_cells_in_all));
  if (!(std::fabs(to_unit.determinant()) > 0) || !std::isfinite(to_unit.determinant()))
    throw Error("a grid of densities lies in a box that is flat or too large");
  for (std::size_t k = 0; k < 3; ++k) bricks_[k] = size[k] / cells + 1;
  table_.resize(std::size_t(bricks_[0]) * std::size_t(bricks_[1]) * std::size_t(bricks_[2]));
}

DensityGrid::DensityGrid(const Size& size, const std::vector<float>& values, const Transform& to_unit)
    : DensityGrid(size, to_unit) {
  if (const std::size_t number = std::size_t(size[0]) * std::size_t(size[1]) * std::size_t(size[2]);
      values.size() != number)
    throw Error(fmt::format("a grid of {} x {} x {} densities has {} numbers; it must have {}", size[0],
                            size[1], size[2], values.size(), number));
  auto next = values.begin();
  for (int z = 0; z < size[2]; ++z)
    for (int y = 0; y < size[1]; ++y)
      for (int x = 0; x < size[0]; ++x, ++next) set(x, y, z, *next);
}

void DensityGrid::set(int x, int y, int z, float value) {
  if (!std::isfinite(value) || value < 0)
    throw Error(fmt::format("a number of the grid is {:g}; it must be finite and >= 0", value));
  const Index point{x + 1, y + 1, z + 1};
  if (value == 0 && this->value(x, y, z) == 0) return;
  Index first, last;  // The bricks that have the point.
  for (std::size_t k = 0; k < 3; ++k) {
    first[k] = (point[k] - 1) / cells;
    last[k] = std::min(point[k] / cells, bricks_[k] - 1);
  }
  for (int bz = first[2]; bz <= last[2]; ++bz)
    for (int by = first[1]; by <= last[1]; ++by)
      for (int bx = first[0]; bx <= last[0]; ++bx) {
        std::uint32_t& kept = table_[table_place({bx, by, bz})];
        if (kept == 0) {
          values_.resize(values_.size() + brick_size);
          kept = std::uint32_t(values_.size() / brick_size);
        }
        const auto within = [](int at, int brick) { return std::size_t(at - brick * cells); };
        values_[(kept - 1) * brick_size + within(point[2], bz) * slice + within(point[1], by) * row_points +
                within(point[0], bx)] = value;
      }
}

std::size_t DensityGrid::bytes() const {
  return values_.size() * sizeof(float) + table_.size() * sizeof(std::uint32_t);
}

std::size_t DensityGrid::table_place(const Index& brick) const {
  return (std::size_t(brick[2]) * std::size_t(bricks_[1]) + std::size_t(brick[1])) * std::size_t(bricks_[0]) +
         std::size_t(brick[0]);
}

const float* DensityGrid::brick_at(const Index& brick) const {
  const std::uint32_t kept = table_[table_place(brick)];
  return kept == 0 ? nullptr : values_.data() + (kept - 1) * brick_size;
}

float DensityGrid::value(int x, int y, int z) const {
  // Its point is the upper one of the lattice's cell of the same index.
  const float* const brick = brick_at({x / cells, y / cells, z / cells});
  const auto upper = [](int at) { return std::size_t(at % cells + 1); };
  return brick ? brick[upper(z) * slice + upper(y) * row_points + upper(x)] : 0;
}

double DensityGrid::at(const Vec3& point) const {
  double value = 0;
  const Line line = line_of({point, {}});
  walk(line, 0, 1, [&](const CellOnLine& cell, double, double) {
    value = cell.density(0);
    return false;
  });
  return value;
}

DensityGrid::Line DensityGrid::line_of(const Ray& ray) const {
  Line line{};
  const double o[3] = {double(ray.origin.x), double(ray.origin.y), double(ray.origin.z)};
  const double d[3] = {double(ray.direction.x), double(ray.direction.y), double(ray.direction.z)};
  for (std::size_t k = 0; k < 3; ++k) {
    const double* const to_unit = to_unit_.m[k];
    line.origin[k] =
        (to_unit[0] * o[0] + to_unit[1] * o[1] + to_unit[2] * o[2] + to_unit[3]) * size_[k] + 0.5;
    line.direction[k] = (to_unit[0] * d[0] + to_unit[1] * d[1] + to_unit[2] * d[2]) * size_[k];
  }
  return line;
}

template <typename Visit>
void DensityGrid::walk(const Line& line, double from, double to, const Visit& visit) const {
  for (std::size_t k = 0; k < 3; ++k) {
    const double o = line.origin[k], d = line.direction[k];
    const double low = 0.5, high = size_[k] + 0.5;
    if (d == 0) {
      if (!(o >= low && o <= high)) return;  // Nor where it is no number.
      continue;
    }
    const double a = (low - o) / d, b = (high - o) / d;
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  if (!(from < to)) return;
  const Index last{bricks_[0] - 1, bricks_[1] - 1, bricks_[2] - 1};
  walk_boxes(line, cells, Index{}, last, from, to, [&](const Index& at, double enters, double leaves) {
    const float* const brick = brick_at(at);
    if (!brick) return true;
    Index first_cell, last_cell;
    for (std::size_t k = 0; k < 3; ++k) {
      first_cell[k] = at[k] * cells;
      last_cell[k] = std::min(first_cell[k] + cells - 1, size_[k]);
    }
    bool goes_on = true;
    walk_boxes(line, 1, first_cell, last_cell, enters, leaves, [&](const Index& cell, double a, double b) {
      return goes_on = visit(CellOnLine(brick, cell, line), a, b);
    });
    return goes_on;
  });
}

double DensityGrid::amount(const Ray& ray, float from, float to, double most) const {
  const Line line = line_of(ray);
  const double scale = double(length(ray.direction));
  double sum = 0;
  walk(line, double(from), double(to), [&](const CellOnLine& cell, double a, double b) {
    sum += cell.integral(a, b);
    return sum * scale <= most;
  });
  return sum * scale;
}

DensityGrid::Reach DensityGrid::reach(const Ray& ray, float from, float to, double amount) const {
  const Line line = line_of(ray);
  const double scale = double(length(ray.direction)), wanted = amount / scale;
  double passed = 0, found = never;
  walk(line, double(from), double(to), [&](const CellOnLine& cell, double a, double b) {
    const double whole = cell.integral(a, b), rest = wanted - passed;
    if (whole < rest) {
      passed += whole;
      return true;
    }
    found = cell.reach(a, b, rest);
    return false;
  });
  return {float(found), found < never ? amount : passed * scale};
}

}  // namespace twinray
