// SPDX-License-Identifier: Apache-2.0
#include "core/environment.h"

#include <algorithm>
#include <cmath>

#include "core/map_points.h"
#include "core/radiance.h"

namespace twinray {
namespace {

/// Cells take 8 bytes each; more than so many would choose hardly better.
constexpr std::int64_t most_cells = 1 << 22;
/// A part of the mean below which what is left of a cell is rounding.
constexpr double residue = 1e-6;

int ceil_divide(int a, int b) { return (a + b - 1) / b; }

int block_for(const Image& map) {
  int block = 1;
  while (std::int64_t(ceil_divide(map.width, block)) * ceil_divide(map.height, block) > most_cells) ++block;
  return block;
}

/// The mean over a pixel of the luminance as bilinear filtering has it.
double filtered_luminance(MapLayout layout, const Image& map, int x, int y) {
  constexpr double weights[] = {0.125, 0.75, 0.125};
  double sum = 0;
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx)
      sum +=
          weights[dx + 1] * weights[dy + 1] * double(luminance(wrapped_pixel(layout, map, x + dx, y + dy)));
  return sum;
}

}  // namespace

Environment::Environment(const EnvironmentLight& light, double compensation)
    : light_(light),
      block_(block_for(*light.map)),
      columns_(ceil_divide(light.map->width, block_)),
      rows_(ceil_divide(light.map->height, block_)) {
  for (int row = 0; row < rows_; ++row) heights_.push_back(map_height(light_.layout, cell(0, row).lower.y));
  heights_.push_back(map_height(light_.layout, 1));
  for (int row = 0; row < rows_; ++row)
    row_solid_angle_.push_back(
        solid_angle(light_.layout, {{0, cell(0, row).lower.y}, {1, cell(0, row).upper.y}}));
  std::vector<double> weights = mean_luminances();
  subtract(weights, compensation);
  std::vector<double> sums, of_row(static_cast<std::size_t>(columns_));
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column)
      of_row[std::size_t(column)] = weights[std::size_t(row) * std::size_t(columns_) + std::size_t(column)] *
                                    cell_solid_angle(column, row);
    sums.push_back(columns_of_.emplace_back(of_row).total());
  }
  row_ = Distribution(sums);
}

std::vector<double> Environment::mean_luminances() const {
  std::vector<double> luminances;
  luminances.reserve(std::size_t(columns_) * std::size_t(rows_));
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column) luminances.push_back(mean_luminance(column, row));
  return luminances;
}

void Environment::subtract(std::vector<double>& luminances, double compensation) const {
  if (compensation == 0) return;
  double sum = 0;
  for (std::size_t i = 0; i < luminances.size(); ++i)
    sum += luminances[i] * cell_solid_angle(int(i % std::size_t(columns_)), int(i / std::size_t(columns_)));
  constexpr double all_directions = 12.566370614359172;
  const double mean = sum / all_directions;
  for (double& luminance : luminances) {
    const double left = luminance - compensation * mean;
    luminance = left > residue * mean ? left : 0;
  }
}

Environment::Sample Environment::sample(Vec2 u) const {
  if (!(row_.total() > 0)) return {};
  const Distribution::Choice row = row_.sample(u.y);
  const Vec3 direction = direction_in({row, columns_of_[row.index].sample(u.x)});
  return sample_at(direction, point_of(direction));
}

void Environment::sample(std::span<const Vec2> u, std::span<Sample> samples) const {
  if (!(row_.total() > 0)) {
    std::fill(samples.begin(), samples.end(), Sample{});
    return;
  }
  Cell cells[together];
  const Distribution* columns[together];
  float across[together];
  Distribution::Choice chosen[together];
  Vec3 directions[together];
  MapPoint points[together];
  for (std::size_t first = 0; first < u.size(); first += together) {
    const std::size_t count = std::min(together, u.size() - first);
    for (std::size_t i = 0; i < count; ++i) cells[i].row = row_.sample(u[first + i].y);
    for (std::size_t i = 0; i < count; ++i) {
      columns[i] = &columns_of_[cells[i].row.index];
      across[i] = u[first + i].x;
    }
    Distribution::sample(std::span(columns).first(count), across, chosen);
    for (std::size_t i = 0; i < count; ++i) {
      cells[i].column = chosen[i];
      directions[i] = direction_in(cells[i]);
    }
    find_points(std::span(directions).first(count), points);
    for (std::size_t i = 0; i < count; ++i) samples[first + i] = sample_at(directions[i], points[i]);
  }
}

void Environment::radiance(std::span<const Vec3> directions, std::span<Rgb> radiances) const {
  MapPoint points[together];
  for (std::size_t first = 0; first < directions.size(); first += together) {
    const std::size_t count = std::min(together, directions.size() - first);
    find_points(directions.subspan(first, count), points);
    for (std::size_t i = 0; i < count; ++i) radiances[first + i] = radiance_at(points[i]);
  }
}

void Environment::view(std::span<const Vec3> directions, std::span<View> views) const {
  MapPoint points[together];
  for (std::size_t first = 0; first < directions.size(); first += together) {
    const std::size_t count = std::min(together, directions.size() - first);
    find_points(directions.subspan(first, count), points);
    for (std::size_t i = 0; i < count; ++i) prefetch_pdf(points[i]);
    for (std::size_t i = 0; i < count; ++i) views[first + i] = view_at(points[i]);
  }
}

void Environment::find_points(std::span<const Vec3> directions, std::span<MapPoint> points) const {
  Vec3 local[together];
  for (std::size_t i = 0; i < directions.size(); ++i)
    local[i] = light_.rotation.transposed_vector(directions[i]);
  map_points(light_.layout, std::span(local).first(directions.size()), points);
  for (std::size_t i = 0; i < directions.size(); ++i) prefetch_radiance(points[i]);
}

void Environment::prefetch_radiance(MapPoint point) const {
  const Image& map = *light_.map;
  const int x = std::clamp(int(point.x * map.width - 0.5), 0, map.width - 1);
  const int y = std::clamp(int(point.y * map.height - 0.5), 0, map.height - 1);
  __builtin_prefetch(&map.at(x, y));
  __builtin_prefetch(&map.at(x, std::min(y + 1, map.height - 1)));
}

void Environment::prefetch_pdf(MapPoint point) const {
  columns_of_[std::size_t(row_at(point))].prefetch(std::uint32_t(column_at(point)));
}

Vec3 Environment::direction_in(const Cell& chosen) const {
  MapCell heights = cell(int(chosen.column.index), int(chosen.row.index));
  heights.lower.y = heights_[chosen.row.index];
  heights.upper.y = heights_[chosen.row.index + 1];
  const Vec3 local =
      direction_between(light_.layout, heights, {chosen.column.remainder, chosen.row.remainder});
  return light_.rotation.vector(local);
}

Environment::Sample Environment::sample_at(const Vec3& direction, MapPoint point) const {
  // The direction is rounded: all that is said of it is that of the point where it lies now.
  const float pdf = pdf_at(point);
  if (!(pdf > 0)) return {};
  return {direction, radiance_at(point), pdf};
}

MapPoint Environment::point_of(const Vec3& direction) const {
  return map_point(light_.layout, light_.rotation.transposed_vector(direction));
}

Rgb Environment::radiance_at(MapPoint point) const {
  const Rgb radiance = light_.scale * map_value(light_.layout, *light_.map, point);
  return {std::min(radiance.r, max_radiance), std::min(radiance.g, max_radiance),
          std::min(radiance.b, max_radiance)};
}

int Environment::column_at(MapPoint point) const {
  return std::clamp(int(point.x * light_.map->width) / block_, 0, columns_ - 1);
}

int Environment::row_at(MapPoint point) const {
  return std::clamp(int(point.y * light_.map->height) / block_, 0, rows_ - 1);
}

float Environment::pdf_at(MapPoint point) const {
  if (!(row_.total() > 0)) return 0;
  const int column = column_at(point), row = row_at(point);
  const Distribution& columns = columns_of_[std::size_t(row)];
  if (!(columns.total() > 0)) return 0;
  const double probability =
      double(row_.probability(std::uint32_t(row))) * columns.probability(std::uint32_t(column));
  return float(probability / cell_solid_angle(column, row));
}

MapCell Environment::cell(int column, int row) const {
  const auto fraction = [&](int cells, int size) { return double(std::min(cells * block_, size)) / size; };
  const int w = light_.map->width, h = light_.map->height;
  return {{fraction(column, w), fraction(row, h)}, {fraction(column + 1, w), fraction(row + 1, h)}};
}

double Environment::cell_solid_angle(int column, int row) const {
  const MapCell all = cell(column, row);
  return row_solid_angle_[std::size_t(row)] * (all.upper.x - all.lower.x);
}

double Environment::mean_luminance(int column, int row) const {
  const Image& map = *light_.map;
  const int right = std::min((column + 1) * block_, map.width);
  const int below = std::min((row + 1) * block_, map.height);
  double sum = 0;
  for (int y = row * block_; y < below; ++y)
    for (int x = column * block_; x < right; ++x) sum += filtered_luminance(light_.layout, map, x, y);
  return sum / (double(right - column * block_) * double(below - row * block_));
}

}  // namespace twinray
