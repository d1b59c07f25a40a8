// SPDX-License-Identifier: Apache-2.0
#include "integrators/denoise/regression.h"

#include <cmath>
#include <memory>

#include "core/parallel.h"

namespace twinray {
namespace {

/// The features, and the constant that is looked for.
constexpr std::size_t terms = feature_count + 1;
/// Features that vary less than the root of this say nothing of the colours.
constexpr float least_feature_variance = 1e-4f;

/// The normal equations of all pixels of a tile, those of one bandwidth: the lower half of the weighted Gram
/// matrix of the terms, and its right-hand sides.
struct Equations {
  std::array<TilePlane, terms*(terms + 1) / 2> gram;
  std::array<std::array<TilePlane, 3>, terms> right;
};

/// What a tile is worked on in.
struct Workspace {
  std::array<Equations, bandwidths.size()> equations;
  TilePlane distances;
};

using Row = std::array<float, tile_width>;

/// e^-distance / k^2, but for a tail: (1 - x / 8)^8 has an end.
float weight_of(float distance, float scale) {
  const float base = std::max(0.0f, 1 - distance * scale);
  const float square = base * base, fourth = square * square;
  return fourth * fourth;
}

/// Adds a row of neighbours to the equations, with their weights.
void add_row(const Row& weights, const std::array<Row, terms>& values,
             const std::array<const float*, 3>& color, std::size_t y, Equations& equations) {
  auto gram = equations.gram.begin();
  for (std::size_t i = 0; i < terms; ++i) {
    Row weighted;
    for (std::size_t x = 0; x < tile_width; ++x) weighted[x] = weights[x] * values[i][x];
    for (std::size_t j = 0; j <= i; ++j, ++gram) {
      Row& sums = (*gram)[y];
      for (std::size_t x = 0; x < tile_width; ++x) sums[x] += weighted[x] * values[j][x];
    }
    for (std::size_t c = 0; c < 3; ++c) {
      Row& sums = equations.right[i][c][y];
      for (std::size_t x = 0; x < tile_width; ++x) sums[x] += weighted[x] * color[c][x];
    }
  }
}

/// The neighbours at one step from all pixels of the tile at x0, y0.
void add_neighbours(const RegressionInput& input, int x0, int y0, Step step, Workspace& work) {
  patch_distances(input.guide, x0, y0, step, work.distances);
  for (std::size_t y = 0; y < tile_height; ++y) {
    const int own_y = y0 + int(y), other_x = x0 + step.x, other_y = own_y + step.y;
    std::array<Row, terms> values;
    values.back().fill(1);
    for (std::size_t f = 0; f < feature_count; ++f) {
      const float *const own = input.features[f].at(x0, own_y), *const other =
                                                                    input.features[f].at(other_x, other_y);
      for (std::size_t x = 0; x < tile_width; ++x) values[f][x] = other[x] - own[x];
    }
    const std::array<const float*, 3> color{input.color[0].at(other_x, other_y),
                                            input.color[1].at(other_x, other_y),
                                            input.color[2].at(other_x, other_y)};
    const float* const inside = input.inside.at(other_x, other_y);
    for (std::size_t k = 0; k < bandwidths.size(); ++k) {
      const float scale = 1 / (8 * bandwidths[k] * bandwidths[k]);
      Row weights;
      for (std::size_t x = 0; x < tile_width; ++x)
        weights[x] = inside[x] * weight_of(work.distances[y][x], scale);
      add_row(weights, values, color, y, work.equations[k]);
    }
  }
}

using Matrix = std::array<std::array<double, terms>, terms>;

/// The Cholesky factor, in place of the lower half of a symmetric, positive definite matrix.
void factorise(Matrix& m) {
  for (std::size_t i = 0; i < terms; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = m[i][j];
      for (std::size_t k = 0; k < j; ++k) sum -= m[i][k] * m[j][k];
      m[i][j] = i == j ? std::sqrt(sum) : sum / m[j][j];
    }
}

/// The last unknown of L L^T x = right: that which substitution finds first.
double last_unknown(const Matrix& lower, std::array<double, terms> right) {
  for (std::size_t i = 0; i < terms; ++i) {
    for (std::size_t k = 0; k < i; ++k) right[i] -= lower[i][k] * right[k];
    right[i] /= lower[i][i];
  }
  return right.back() / lower.back().back();
}

/// Noisy features count as less than they seem to vary (ridge regression).
Matrix matrix_of(const RegressionInput& input, int x0, int y0, std::size_t x, std::size_t y,
                 const Equations& equations) {
  Matrix matrix{};
  auto gram = equations.gram.begin();
  for (std::size_t i = 0; i < terms; ++i)
    for (std::size_t j = 0; j <= i; ++j) matrix[i][j] = (*gram++)[y][x];
  const double weights = matrix.back().back();
  for (std::size_t f = 0; f < feature_count; ++f)
    matrix[f][f] += weights * (least_feature_variance + input.feature_variance[f].at(x0, y0 + int(y))[x]);
  return matrix;
}

void solve(const RegressionInput& input, int x0, int y0, const Equations& equations, Color& found) {
  const auto width = std::size_t(std::min(tile_width, found[0].width - x0));
  const auto height = std::size_t(std::min(tile_height, found[0].height - y0));
  for (std::size_t y = 0; y < height; ++y)
    for (std::size_t x = 0; x < width; ++x) {
      Matrix matrix = matrix_of(input, x0, y0, x, y, equations);
      factorise(matrix);
      for (std::size_t c = 0; c < 3; ++c) {
        std::array<double, terms> right;
        for (std::size_t i = 0; i < terms; ++i) right[i] = equations.right[i][c][y][x];
        found[c].row(y0 + int(y))[x0 + int(x)] = float(last_unknown(matrix, right));
      }
    }
}

}  // namespace

std::array<Color, bandwidths.size()> regressions(const RegressionInput& input, int width, int height,
                                                 const std::function<bool()>& is_stopped) {
  const Plane empty(width, height);
  std::array<Color, bandwidths.size()> found;
  found.fill({empty, empty, empty});
  const int columns = (width + tile_width - 1) / tile_width, rows = (height + tile_height - 1) / tile_height;
  parallel_for(std::size_t(columns) * std::size_t(rows), 1, 0, [&](std::size_t tile, std::size_t) {
    if (is_stopped && is_stopped()) return;
    const int x0 = int(tile) % columns * tile_width, y0 = int(tile) / columns * tile_height;
    const auto work = std::make_unique<Workspace>();
    for (int dy = -window_radius; dy <= window_radius; ++dy)
      for (int dx = -window_radius; dx <= window_radius; ++dx) add_neighbours(input, x0, y0, {dx, dy}, *work);
    for (std::size_t k = 0; k < bandwidths.size(); ++k) solve(input, x0, y0, work->equations[k], found[k]);
  });
  return found;
}

}  // namespace twinray
