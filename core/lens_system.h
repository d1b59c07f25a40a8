// SPDX-License-Identifier: Apache-2.0
// A camera lens as it is built: pieces of glass with spherical surfaces and a stop, through which rays are
// traced from the film into the scene (Kolb, Mitchell and Hanrahan, "A Realistic Camera Model for Computer
// Graphics", 1995; the book's "realistic camera").
//
// Its own space: the film lies in the plane z = 0 around the axis, and the scene is where z is large.
#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "core/vec.h"

namespace twinray {

/// A surface around the axis, as tables of lenses list them: the first one is nearest to the scene.
struct LensSurface {
  /// Positive where the surface bulges towards the scene, negative where it is hollow; 0: flat. A flat one
  /// with the same on both sides is a stop.
  double curvature_radius = 0;
  double thickness = 0;        ///< Along the axis to the next surface; of the last one to the film; >= 0.
  double ior = 1;              ///< Of what fills that; 0 or 1: air.
  double aperture_radius = 0;  ///< Light passes no farther from the axis; > 0.

  double index() const { return ior == 0 ? 1 : ior; }
  bool operator==(const LensSurface&) const = default;
};

/// Where distant light is brought together, by the laws for rays near the axis (Gauss).
struct CardinalPoints {
  double focal_length;     ///< > 0.
  double front_principal;  ///< From the last surface towards the film, as the next;
  double rear_principal;   ///< negative within the lens.
};
/// Throws Error for a lens that brings none together.
CardinalPoints cardinal_points(const std::vector<LensSurface>& surfaces);

/// The same surfaces, the film moved to where what lies in a plane at `distance` from it is sharp. Throws
/// Error where that is too near.
std::vector<LensSurface> focused(std::vector<LensSurface> surfaces, double distance);

/// Of surface i: what is before it, towards the scene.
double ior_before(const std::vector<LensSurface>& surfaces, std::size_t i);
inline bool is_stop(const std::vector<LensSurface>& surfaces, std::size_t i) {
  return surfaces[i].curvature_radius == 0 && surfaces[i].index() == ior_before(surfaces, i);
}

class LensSystem {
 public:
  /// No lens has more surfaces.
  static constexpr std::size_t most_surfaces = 1000;

  /// `film_radius`: the farthest from the axis at which there is film. All lengths in units of the scene.
  /// Throws Error that says what is wrong with the surfaces.
  LensSystem(std::vector<LensSurface> surfaces, double film_radius);

  const std::vector<LensSurface>& surfaces() const { return surfaces_; }
  double film_radius() const { return film_radius_; }
  double focal_length() const { return points_.focal_length; }
  /// Between the film and the rear principal plane: a pinhole so far from the film sees what the lens does.
  double image_distance() const { return surfaces_.back().thickness - points_.rear_principal; }
  /// Between the film and what is sharp on it. focused() of that distance is this lens where the image
  /// distance is up to twice the focal length. Infinite where no plane before the lens is sharp.
  double focus_distance() const;

  /// A ray that has left the lens.
  struct Sight {
    Vec3 origin, direction;  ///< A unit vector.
    /// What the film gets of light along it, over the density of this ray; 0: the lens lets none through.
    float light = 0;
  };
  /// From a point of the film through a random point of the exit pupil; u uniform in [0, 1)^2. The mean of
  /// the light is that of cos^4 over the solid angle of the pupil at its distance, as the book has it.
  Sight sight(Vec2 film, Vec2 u) const;

 private:
  struct Line;
  /// A rectangle of the pupil's plane, where x points away from the axis, that is as high below it as above.
  struct Bounds {
    double x0, x1, y1;

    void extend(const Bounds& other);
  };

  double widest(Line& line, double most) const;
  double widest_by_way_of(double film, double x, double y) const;
  /// Holds the pupil of a film point for certain.
  Bounds rim(double film) const;
  std::optional<double> find_pupil(double film) const;
  Bounds pupil_at(double film) const;

  std::vector<LensSurface> surfaces_;
  double film_radius_;
  CardinalPoints points_;
  double plane_ = 0;  ///< Where pupils are bounded: nothing of the last surface lies nearer to the film.
  std::vector<Bounds> pupil_;  ///< By even parts of the film's radius.
};

}  // namespace twinray
