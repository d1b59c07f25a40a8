// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstddef>
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
class DensityGrid {
 public:
  using Size = std::array<int, 3>;
  /// No grid is larger than this along an axis.
  static constexpr int most_cells = 1 << 14;

  /// `values`, of which x runs fastest, are finite and not negative; `to_unit` takes the scene's space to the
  /// one in which the box is [0, 1]^3. Throws Error where they are not so many as the cells, or where the
  /// transform flattens.
  DensityGrid(const Size& size, const std::vector<float>& values, const Transform& to_unit);

  const Size& size() const { return size_; }
  const Transform& to_unit() const { return to_unit_; }
  /// In memory.
  std::size_t bytes() const { return padded_.size() * sizeof(float); }
  /// That of a cell.
  float value(int x, int y, int z) const { return padded_[place(x + 1, y + 1, z + 1)]; }

  /// The integral of the density over the ray from one parameter to another, in the scene's lengths; `to` may
  /// be infinite.
  double amount(const Ray& ray, float from, float to) const;
  /// The parameter up to which so much lies along the ray from `from` on, > 0; infinite where there is less
  /// before `to`.
  float reach(const Ray& ray, float from, float to, double amount) const;

 private:
  /// A ray in the space of the lattice, where the numbers lie at 1 to size, and the zeros around them at 0
  /// and size + 1.
  struct Line {
    std::array<double, 3> origin, direction;
    double at(int axis, double t) const {
      return origin[std::size_t(axis)] + direction[std::size_t(axis)] * t;
    }
  };
  /// The eight numbers around a cell of the lattice.
  using Corners = std::array<float, 8>;

  Line line_of(const Ray& ray) const;
  std::size_t place(int x, int y, int z) const {
    return (std::size_t(z) * std::size_t(size_[1] + 2) + std::size_t(y)) * std::size_t(size_[0] + 2) +
           std::size_t(x);
  }
  Corners corners_of(const std::array<int, 3>& cell) const;
  /// The integral over t within a cell.
  static double integral(const Line& line, const std::array<int, 3>& cell, const Corners& corners,
                         double from, double to);
  /// Calls visit(cell, from, to) for each cell of the lattice that the line goes through within the box, in
  /// order, until it returns false.
  template <typename Visit>
  void walk(const Line& line, double from, double to, const Visit& visit) const;

  Size size_;
  Transform to_unit_;
  std::vector<float> padded_;  ///< With the zeros around.
};

}  // namespace twinray
