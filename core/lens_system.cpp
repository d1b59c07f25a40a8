// SPDX-License-Identifier: Apache-2.0
#include "core/lens_system.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "core/error.h"

namespace twinray {
namespace {

/// The film's radius is divided into so many parts, each with bounds of its pupils,
constexpr int film_parts = 64;
/// which are looked for by a grid of so many points a side.
constexpr int pupil_points = 64;
/// A pupil may be larger than the last surface: that is curved, and the plane is not.
constexpr double pupil_margin = 1.5;

double index_of(const LensSurface& surface) { return surface.ior == 0 ? 1 : surface.ior; }

/// A ray near the axis: its height, and how that grows along the way.
struct Paraxial {
  double height, slope;
};

/// A parallel ray at height 1 through all surfaces, towards the film or away from it.
Paraxial through_all(const std::vector<LensSurface>& surfaces, bool is_to_film) {
  Paraxial ray{1, 0};
  const auto count = std::ptrdiff_t(surfaces.size());
  for (std::ptrdiff_t step = 0; step < count; ++step) {
    const std::ptrdiff_t i = is_to_film ? step : count - 1 - step;
    const LensSurface& surface = surfaces[std::size_t(i)];
    const double front = i > 0 ? index_of(surfaces[std::size_t(i - 1)]) : 1, behind = index_of(surface);
    const double before = is_to_film ? front : behind, after = is_to_film ? behind : front;
    const double radius = is_to_film ? surface.curvature_radius : -surface.curvature_radius;
    if (radius != 0) ray.slope = (before * ray.slope - ray.height * (after - before) / radius) / after;
    const bool is_last = step == count - 1;
    if (!is_last) ray.height += ray.slope * surfaces[std::size_t(is_to_film ? i : i - 1)].thickness;
  }
  return ray;
}

void check_surfaces(const std::vector<LensSurface>& surfaces) {
  const auto fail = [](std::size_t i, const char* what, double value, const char* valid) {
    throw Error(fmt::format("surface {} of the lens: {} {:g}; valid is {}", i + 1, what, value, valid));
  };
  if (surfaces.empty() || surfaces.size() > LensSystem::most_surfaces)
    throw Error(
        fmt::format("a lens has 1 to {} surfaces; this one {}", LensSystem::most_surfaces, surfaces.size()));
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const LensSurface& s = surfaces[i];
    if (!std::isfinite(s.curvature_radius)) fail(i, "a curvature radius of", s.curvature_radius, "a number");
    if (!(s.thickness >= 0) || !std::isfinite(s.thickness))
      fail(i, "a thickness of", s.thickness, "a number that is not negative");
    if (s.ior != 0 && !(s.ior >= 1 && s.ior <= 10)) fail(i, "an index of refraction of", s.ior, "1 to 10");
    if (!(s.aperture_radius > 0) || !std::isfinite(s.aperture_radius))
      fail(i, "an aperture of", s.aperture_radius, "a positive number");
  }
  // What lies behind the last surface is where the film is.
  if (index_of(surfaces.back()) != 1)
    fail(surfaces.size() - 1, "an index of refraction of", surfaces.back().ior,
         "that of air, 1, before the film");
}

}  // namespace

CardinalPoints cardinal_points(const std::vector<LensSurface>& surfaces) {
  check_surfaces(surfaces);
  const Paraxial forth = through_all(surfaces, true), back = through_all(surfaces, false);
  if (!(forth.slope < 0) || !(back.slope < 0))
    throw Error("this lens brings no distant light together, so nothing is sharp behind it");
  const double focal_length = -1 / forth.slope;
  double length = 0;
  for (std::size_t i = 0; i + 1 < surfaces.size(); ++i) length += surfaces[i].thickness;
  return {.focal_length = focal_length,
          .front_principal = back.height / back.slope - 1 / back.slope - length,
          .rear_principal = -forth.height / forth.slope - focal_length};
}

std::vector<LensSurface> focused(std::vector<LensSurface> surfaces, double distance) {
  const CardinalPoints points = cardinal_points(surfaces);
  // Object, principal planes and film: v (T - v) = f T, where T is the way without the one between the
  // planes.
  const double between = points.rear_principal - points.front_principal;
  const double way = distance - between, f = points.focal_length;
  if (!(way >= 4 * f))
    throw Error(
        fmt::format("a lens with a focal length of {:g} makes nothing sharp nearer than {:g}; this is {:g}",
                    f, 4 * f + between, distance));
  const double image = 2 * f / (1 + std::sqrt(1 - 4 * f / way));  // Without cancellation.
  surfaces.back().thickness = points.rear_principal + image;
  if (!(surfaces.back().thickness > 0)) throw Error("the film would have to lie within this lens");
  return surfaces;
}

/// A ray in doubles: what is derived of small differences stays exact enough for floats.
struct LensSystem::Line {
  double x, y, z, dx, dy, dz;

  void advance(double t) { x += t * dx, y += t * dy, z += t * dz; }
  void make_unit() {
    const double size = std::sqrt(dx * dx + dy * dy + dz * dz);
    dx /= size, dy /= size, dz /= size;
  }
  /// To a sphere around a point of the axis, on the side of it where `radius` has the vertex.
  bool advance_to_sphere(double center, double radius) {
    const double from = z - center;
    const double b = x * dx + y * dy + from * dz;
    const double left = b * b - (x * x + y * y + from * from - radius * radius);
    if (!(left >= 0)) return false;
    const double root = std::sqrt(left), t = radius > 0 ? -b + root : -b - root;
    if (!(t >= 0)) return false;
    advance(t);
    return true;
  }
  /// There, into another medium; `ratio` is the index before over the one behind. False where all light is
  /// reflected.
  bool refract(double center, double radius, double ratio) {
    double nx = x / radius, ny = y / radius, nz = (z - center) / radius;  // Towards the scene.
    if (nx * dx + ny * dy + nz * dz > 0) nx = -nx, ny = -ny, nz = -nz;
    const double cosine = -(nx * dx + ny * dy + nz * dz);
    const double left = 1 - ratio * ratio * (1 - cosine * cosine);
    if (!(left >= 0)) return false;
    const double along = ratio * cosine - std::sqrt(left);
    dx = ratio * dx + along * nx, dy = ratio * dy + along * ny, dz = ratio * dz + along * nz;
    make_unit();
    return true;
  }
};

/// From the film out of the lens; false where it does not get there. The direction is a unit vector.
bool LensSystem::trace(Line& line) const {
  double vertex = 0;
  for (std::size_t i = surfaces_.size(); i-- > 0;) {
    const LensSurface& surface = surfaces_[i];
    vertex += surface.thickness;
    const double radius = surface.curvature_radius, center = vertex - radius;
    if (radius == 0) {
      const double t = (vertex - line.z) / line.dz;
      if (!(t >= 0)) return false;
      line.advance(t);
    } else if (!line.advance_to_sphere(center, radius)) {
      return false;
    }
    if (!(line.x * line.x + line.y * line.y <= surface.aperture_radius * surface.aperture_radius))
      return false;
    const double front = i > 0 ? index_of(surfaces_[i - 1]) : 1;
    if (radius != 0 && !line.refract(center, radius, index_of(surface) / front)) return false;
  }
  return true;
}

/// Whether a ray gets out from a point of the film on the x axis by way of one of the plane.
bool LensSystem::reaches(double film, double x, double y) const {
  Line line{film, 0, 0, x - film, y, rear()};
  line.make_unit();
  return trace(line);
}

/// What a point of the film sees of the scene lies within these bounds; `all_` where nothing is found.
LensSystem::Bounds LensSystem::pupil_at(double film) const {
  const double half = all_.x1, step = 2 * half / pupil_points;
  Bounds found{half, half, -half, -half};
  const auto place = [&](int i) { return -half + (i + 0.5) * step; };
  for (int column = 0; column < pupil_points; ++column)
    for (int row = 0; row < pupil_points / 2; ++row) {  // The other half is its mirror image.
      const double x = place(column), y = place(row);
      if (!reaches(film, x, y)) continue;
      found = {std::min(found.x0, x), std::min(found.y0, y), std::max(found.x1, x), std::max(found.y1, -y)};
    }
  if (found.x0 > found.x1) return all_;
  return {found.x0 - step, found.y0 - step, found.x1 + step, found.y1 + step};
}

LensSystem::LensSystem(std::vector<LensSurface> surfaces, double film_radius)
    : surfaces_(std::move(surfaces)), film_radius_(film_radius) {
  const CardinalPoints points = cardinal_points(surfaces_);
  if (!(rear() > 0)) throw Error("the film touches the lens: the last surface needs a thickness above 0");
  if (!(film_radius_ > 0) || !std::isfinite(film_radius_))
    throw Error(
        fmt::format("a film that reaches {:g} from the axis; valid is a positive number", film_radius_));
  image_distance_ = rear() - points.rear_principal;
  if (!(image_distance_ > 0)) throw Error("the film lies before the rear principal plane of this lens");
  const double half = pupil_margin * surfaces_.back().aperture_radius;
  all_ = {-half, -half, half, half};
  Bounds before = pupil_at(0);
  for (int part = 1; part <= film_parts; ++part) {
    const Bounds here = pupil_at(film_radius_ * part / film_parts);
    pupil_.push_back({std::min(before.x0, here.x0), std::min(before.y0, here.y0),
                      std::max(before.x1, here.x1), std::max(before.y1, here.y1)});
    before = here;
  }
}

double LensSystem::focus_distance() const {
  const CardinalPoints points = cardinal_points(surfaces_);
  const double beyond = image_distance_ - points.focal_length;
  if (!(beyond > 0)) return std::numeric_limits<double>::infinity();
  const double before = points.focal_length * image_distance_ / beyond;
  return before + image_distance_ + points.rear_principal - points.front_principal;
}

LensSystem::Sight LensSystem::sight(Vec2 film, Vec2 u) const {
  const double fx = double(film.x), fy = double(film.y), from_axis = std::sqrt(fx * fx + fy * fy);
  const double part = from_axis / film_radius_ * film_parts;
  const bool is_known = part < film_parts * (1 + 1e-6);  // The corner's own rounding.
  const Bounds& bounds = is_known ? pupil_[std::min(std::size_t(part), pupil_.size() - 1)] : all_;
  const double width = bounds.x1 - bounds.x0, height = bounds.y1 - bounds.y0;
  const double away = bounds.x0 + width * double(u.x), across = bounds.y0 + height * double(u.y);
  const double c = from_axis > 0 ? fx / from_axis : 1, s = from_axis > 0 ? fy / from_axis : 0;
  Line line{fx, fy, 0, c * away - s * across - fx, s * away + c * across - fy, rear()};
  line.make_unit();
  const double cosine = line.dz;
  if (!trace(line)) return {};
  const double light = cosine * cosine * cosine * cosine * (width * height) / (rear() * rear());
  return {{float(line.x), float(line.y), float(line.z)},
          {float(line.dx), float(line.dy), float(line.dz)},
          float(light)};
}

}  // namespace twinray
