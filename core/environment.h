// SPDX-License-Identifier: Apache-2.0
// An environment light, prepared for lookups and for sampling: directions are chosen by the picture's
// luminance. A cell's probability is the solid angle that it covers times the mean luminance there of the
// picture as it is filtered, so that no direction that shines lacks density; within a cell all directions are
// alike. Where scattered rays look for the light as well (multiple importance sampling), they find what is
// dim and wide by themselves: part of the mean is subtracted before, and samples go to what is bright (Karlik
// et al., "MIS Compensation", 2019).
#pragma once
#include <span>
#include <vector>

#include "core/direction_map.h"
#include "core/distribution.h"
#include "core/light.h"

namespace twinray {

class Environment {
 public:
  /// So many draws or directions wait for memory together.
  static constexpr std::size_t together = Distribution::most_together;

  struct Sample {
    Vec3 direction;  ///< Unit, in the world.
    Rgb radiance;
    float pdf = 0;  ///< That of pdf(direction). 0: nothing was chosen, and the rest is zero.
  };

  /// What a ray along a direction finds.
  struct View {
    Rgb radiance;
    float pdf = 0;
  };

  /// `compensation`: how many times the mean luminance is subtracted, >= 0; 0 unless scattered rays look for
  /// the light, too. Where nothing is left, as of a map that is the same everywhere, nothing is sampled.
  Environment(const EnvironmentLight& light, double compensation);

  /// Along a unit direction of the world; at most max_radiance.
  Rgb radiance(const Vec3& direction) const { return radiance_at(point_of(direction)); }
  /// u in [0, 1)^2.
  Sample sample(Vec2 u) const;
  /// samples[i] = sample(u[i]), several at a time, so that they wait for memory together: the picture and its
  /// distribution are larger than the nearer caches.
  void sample(std::span<const Vec2> u, std::span<Sample> samples) const;
  /// The density, per solid angle, with which sample() chooses a unit direction.
  float pdf(const Vec3& direction) const { return pdf_at(point_of(direction)); }
  /// Both of a unit direction.
  View view(const Vec3& direction) const { return view_at(point_of(direction)); }
  /// radiances[i] = radiance(directions[i]), several at a time, as by sample().
  void radiance(std::span<const Vec3> directions, std::span<Rgb> radiances) const;
  /// views[i] = view(directions[i]), likewise.
  void view(std::span<const Vec3> directions, std::span<View> views) const;

 private:
  /// Where a draw falls.
  struct Cell {
    Distribution::Choice row, column;
  };
  Vec3 direction_in(const Cell& chosen) const;
  Sample sample_at(const Vec3& direction, MapPoint point) const;
  View view_at(MapPoint point) const { return {radiance_at(point), pdf_at(point)}; }
  /// points[i] = point_of(directions[i]), and asks memory for the pixels there.
  void find_points(std::span<const Vec3> directions, std::span<MapPoint> points) const;
  /// Asks memory for the pixels at a point,
  void prefetch_radiance(MapPoint point) const;
  /// and for what the density there is made of.
  void prefetch_pdf(MapPoint point) const;
  int column_at(MapPoint point) const;
  int row_at(MapPoint point) const;
  MapPoint point_of(const Vec3& direction) const;
  Rgb radiance_at(MapPoint point) const;
  float pdf_at(MapPoint point) const;
  MapCell cell(int column, int row) const;
  double cell_solid_angle(int column, int row) const;
  double mean_luminance(int column, int row) const;
  /// A number for each cell, row by row.
  std::vector<double> mean_luminances() const;
  void subtract(std::vector<double>& luminances, double compensation) const;

  EnvironmentLight light_;
  int block_ =
      1;  ///< A cell is so many pixels wide and high; at the right and the lower edge it may be less.
  int columns_ = 0, rows_ = 0;   ///< Of cells.
  std::vector<double> heights_;  ///< Of the rows' edges, as map_height() has them.
  std::vector<double> row_solid_angle_;
  Distribution row_;                      ///< Of a sample's cell.
  std::vector<Distribution> columns_of_;  ///< Given the row.
};

/// How many times the mean makes the sum of both ways follow the picture, where each surface takes one
/// scattered ray and a number of light samples: 2 / (1 + samples) (Karlik et al., equation 15, with the
/// hemisphere for the scattered rays' density).
inline double mis_compensation(double light_samples) { return 2 / (1 + light_samples); }

}  // namespace twinray
