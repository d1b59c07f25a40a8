// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/ray.h"
#include "core/transform.h"

namespace twinray {

/// How dense a medium is, point by point: numbers at the middles of the even cells of a box, trilinear
/// between them and towards zeros half a cell outside of the box; nothing beyond it. As pbrt-v4's grids.
///
/// Along a ray a trilinear function is a polynomial of the third degree in each cell, which two points of
/// Gauss and Legendre integrate exactly. So what lies along a ray is known but for rounding, without random
/// numbers.
///
/// Cells are kept in bricks of 8 x 8 x 8. Where all are 0 there is none: it takes no memory, and a ray
/// crosses it in one step.
class DensityGrid {
 public:
  using Size = std::array<int, 3>;
  /// No grid is larger than this along an axis,
  static constexpr int most_cells = 1 << 14;
  /// or has more cells.
  static constexpr std::int64_t most_cells_in_all = std::int64_t(1) << 33;

  /// Of zeros. `to_unit` takes the scene's space to the one in which the box is [0, 1]^3. Throws Error for a
  /// size out of range, or where the transform flattens.
  DensityGrid(const Size& size, const Transform& to_unit);
  /// Of `values`, of which x runs fastest. Throws Error where they are not so many as the cells, too.
  DensityGrid(const Size& size, const std::vector<float>& values, const Transform& to_unit);
  /// Of a cell; the value is finite and not negative, or Error is thrown.
  void set(int x, int y, int z, float value);

  const Size& size() const { return size_; }
  const Transform& to_unit() const { return to_unit_; }
  /// In memory.
  std::size_t bytes() const;
  /// That of a cell.
  float value(int x, int y, int z) const;
  /// That of a point of the scene.
  double at(const Vec3& point) const;

  /// The integral of the density over the ray from one parameter to another, in the scene's lengths; `to` may
  /// be infinite. Where it is more than `most`, something that is, too.
  double amount(const Ray& ray, float from, float to,
                double most = std::numeric_limits<double>::infinity()) const;
  struct Reach {
    float t;        ///< The ray's parameter there; infinite where there is less before `to`,
    double amount;  ///< which is this.
  };
  /// How far so much lies along the ray from `from` on; amount >= 0.
  Reach reach(const Ray& ray, float from, float to, double amount) const;

 private:
  /// Along an edge of a brick: cells, and points of the lattice.
  static constexpr int cells = 8, points = cells + 1;
  using Index = std::array<int, 3>;
  /// A ray in the space of the lattice, where the numbers lie at 1 to size, and the zeros around them at 0
  /// and size + 1.
  struct Line {
    std::array<double, 3> origin, direction;
    double at(std::size_t axis, double t) const { return origin[axis] + direction[axis] * t; }
  };
  /// A cell of the lattice that a line goes through: the density along that, and its integral.
  class CellOnLine;

  Line line_of(const Ray& ray) const;
  std::size_t table_place(const Index& brick) const;
  /// A brick's numbers; null where all are 0.
  const float* brick_at(const Index& brick) const;
  /// Calls visit(CellOnLine, from, to) for each cell of the lattice that the line goes through within the
  /// box, in order and but for those of bricks that are 0, until it returns false.
  template <typename Visit>
  void walk(const Line& line, double from, double to, const Visit& visit) const;

  Size size_;
  Transform to_unit_;
  Index bricks_{};                    ///< How many along each axis.
  std::vector<std::uint32_t> table_;  ///< Of each brick, which of those kept it is, from 1 on; 0: none.
  std::vector<float> values_;         ///< Brick by brick; neighbours have the points between them both.
};

}  // namespace twinray
