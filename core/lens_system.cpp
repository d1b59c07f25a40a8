// SPDX-License-Identifier: Apache-2.0
#include "core/lens_system.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/error.h"

namespace twinray {
namespace {

/// The film's radius is divided into so many parts, each with bounds of its pupils.
constexpr int film_parts = 64;
/// By so many steps a pupil is looked for on the axis, and again around the best of them.
constexpr int axis_steps = 128, most_looks = 8;
/// Edges of a pupil are halved in so often,
constexpr int halvings = 16;
/// and compared with what a grid of so many points a side finds up to so far around them.
constexpr int grid_points = 16;
constexpr double around = 0.25;
/// Squares of other lengths are no numbers.
constexpr double least_length = 1e-30, most_length = 1e30;

/// A ray near the axis: its height, and how that grows along the way.
struct Paraxial {
  double height, slope;
};

/// A parallel ray at height 1 through all surfaces, towards the film or away from it.
Paraxial through_all(const std::vector<LensSurface>& surfaces, bool is_to_film) {
  Paraxial ray{1, 0};
  const std::size_t count = surfaces.size();
  for (std::size_t step = 0; step < count; ++step) {
    const std::size_t i = is_to_film ? step : count - 1 - step;
    const LensSurface& surface = surfaces[i];
    const double front = ior_before(surfaces, i), behind = surface.index();
    const double before = is_to_film ? front : behind, after = is_to_film ? behind : front;
    const double radius = is_to_film ? surface.curvature_radius : -surface.curvature_radius;
    const double bent = radius == 0 ? 0 : ray.height * (after - before) / radius;
    ray.slope = (before * ray.slope - bent) / after;
    const bool is_last = step == count - 1;
    if (!is_last) ray.height += ray.slope * surfaces[is_to_film ? i : i - 1].thickness;
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
    const double curved = std::fabs(s.curvature_radius);
    if (curved != 0 && !(curved >= least_length && curved <= most_length))
      fail(i, "a curvature radius of", s.curvature_radius, "0, or 1e-30 to 1e30 with either sign");
    if (!(s.thickness >= 0 && s.thickness <= most_length))
      fail(i, "a thickness of", s.thickness, "0 to 1e30");
    if (s.ior != 0 && !(s.ior >= 1 && s.ior <= 10)) fail(i, "an index of refraction of", s.ior, "1 to 10");
    if (!(s.aperture_radius >= least_length && s.aperture_radius <= most_length))
      fail(i, "an aperture of", s.aperture_radius, "1e-30 to 1e30");
  }
  if (const LensSurface& last = surfaces.back(); last.index() != 1)
    fail(surfaces.size() - 1, "an index of refraction of", last.ior, "that of air, 1, before the film");
}

}  // namespace

double ior_before(const std::vector<LensSurface>& surfaces, std::size_t i) {
  return i > 0 ? surfaces[i - 1].index() : 1;
}

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

  void make_unit() {
    const double size = std::sqrt(dx * dx + dy * dy + dz * dz);
    dx /= size, dy /= size, dz /= size;
  }
  /// To a surface of this curvature, 1 / radius: seen from its vertex, curvature p^2 + 2 p_z = 0. Of two
  /// points the one on the vertex's side. False where the ray misses it, or starts behind it.
  bool advance_to(double vertex, double curvature) {
    const double from = z - vertex;
    const double b = curvature * (x * dx + y * dy + from * dz) + dz;
    const double c = curvature * (x * x + y * y + from * from) + 2 * from;
    const double left = b * b - curvature * c;
    if (!(left >= 0)) return false;
    const double t = -c / (b + std::sqrt(left));  // Without cancellation where it is nearly flat.
    if (!(t >= 0) || !std::isfinite(t)) return false;
    x += t * dx, y += t * dy, z += t * dz;
    return true;
  }
  /// There, into another medium; `ratio` is the index before over the one behind. False where all light is
  /// reflected.
  bool refract(double vertex, double curvature, double ratio) {
    double nx = curvature * x, ny = curvature * y, nz = curvature * (z - vertex) + 1;  // A unit vector.
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

/// From the film out of the lens: how far from the axis the ray comes, squared, in apertures of the surfaces
/// there. Infinite where it does not get out, or comes farther than `most`. The direction is a unit vector.
double LensSystem::widest(Line& line, double most) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double vertex = 0, found = 0;
  for (std::size_t i = surfaces_.size(); i-- > 0;) {
    const LensSurface& surface = surfaces_[i];
    vertex += surface.thickness;
    const double curvature = surface.curvature_radius == 0 ? 0 : 1 / surface.curvature_radius;
    if (!line.advance_to(vertex, curvature)) return infinity;
    const double x = line.x / surface.aperture_radius, y = line.y / surface.aperture_radius;
    found = std::max(found, x * x + y * y);
    if (!(found <= most)) return infinity;
    const double front = ior_before(surfaces_, i);
    if (surface.index() != front && !line.refract(vertex, curvature, surface.index() / front))
      return infinity;
  }
  return found;
}

/// The same from a point of the film on the x axis by way of one of the pupil's plane.
double LensSystem::widest_by_way_of(double film, double x, double y) const {
  Line line{film, 0, 0, x - film, y, plane_};
  line.make_unit();
  return widest(line, std::numeric_limits<double>::max());
}

void LensSystem::Bounds::extend(const Bounds& other) {
  x0 = std::min(x0, other.x0), x1 = std::max(x1, other.x1), y1 = std::max(y1, other.y1);
}

/// A ray to the last surface crosses the plane before, between its film point and that surface's rim.
LensSystem::Bounds LensSystem::rim(double film) const {
  const double half = std::max(surfaces_.back().aperture_radius, film);
  return {-half, half, half};
}

/// A point of the x axis through which a ray gets out, however small the stop is; none where none is found.
/// The less wide its way, the nearer a point is to one.
std::optional<double> LensSystem::find_pupil(double film) const {
  double middle = 0, reach = rim(film).x1;
  for (int look = 0; look < most_looks; ++look) {
    const double step = 2 * reach / axis_steps;
    double best = std::numeric_limits<double>::infinity(), place = middle;
    for (int i = 0; i <= axis_steps; ++i) {
      const double x = middle - reach + i * step, width = widest_by_way_of(film, x, 0);
      if (width < best) best = width, place = x;
    }
    if (best <= 1) return place;
    middle = place, reach = 2 * step;
  }
  return std::nullopt;
}

/// What a point of the film sees of the scene lies within these bounds.
LensSystem::Bounds LensSystem::pupil_at(double film) const {
  const Bounds all = rim(film);
  const std::optional<double> inside = find_pupil(film);
  if (!inside) return all;
  const auto is_in = [&](double x, double y) { return widest_by_way_of(film, x, y) <= 1; };
  // The first point that is not in the pupil on a way out of it, or the way's end.
  const auto edge = [](double from, double to, const auto& is_inside) {
    for (int i = 0; i < halvings && !is_inside(to); ++i) {
      const double middle = (from + to) / 2;
      if (is_inside(middle))
        from = middle;
      else
        to = middle;
    }
    return to;
  };
  const auto is_on_axis = [&](double x) { return is_in(x, 0); };
  Bounds found{edge(*inside, all.x0, is_on_axis), edge(*inside, all.x1, is_on_axis), 0};
  for (int i = 0; i <= grid_points; ++i) {
    const double x = found.x0 + (found.x1 - found.x0) * i / grid_points;
    if (is_on_axis(x)) found.y1 = std::max(found.y1, edge(0, all.y1, [&](double y) { return is_in(x, y); }));
  }
  // A pupil need not be as round as that.
  const double width = found.x1 - found.x0, dx = width * (1 + 2 * around) / grid_points,
               dy = found.y1 * (1 + around) / grid_points;
  Bounds seen = found;
  for (int column = 0; column <= grid_points; ++column)
    for (int row = 0; row <= grid_points; ++row) {
      const double x = found.x0 - around * width + column * dx, y = row * dy;
      if (is_in(x, y)) seen.extend({x, x, y});
    }
  return {seen.x0 - dx / 2, seen.x1 + dx / 2, seen.y1 + dy / 2};
}

LensSystem::LensSystem(std::vector<LensSurface> surfaces, double film_radius)
    : surfaces_(std::move(surfaces)), film_radius_(film_radius), points_(cardinal_points(surfaces_)) {
  const LensSurface& last = surfaces_.back();
  if (!(last.thickness > 0))
    throw Error("the film touches the lens: the last surface needs a thickness above 0");
  if (!(film_radius_ >= least_length && film_radius_ <= most_length))
    throw Error(fmt::format("a film that reaches {:g} from the axis; valid is 1e-30 to 1e30", film_radius_));
  if (!(image_distance() > 0)) throw Error("the film lies before the rear principal plane of this lens");
  plane_ = last.thickness;
  if (const double radius = last.curvature_radius; radius > 0) {
    const double rim = std::min(last.aperture_radius, radius);
    plane_ -= rim * rim / (radius + std::sqrt(radius * radius - rim * rim));
  }
  if (!(plane_ > 0)) throw Error("the rim of the last surface reaches the film");
  Bounds before = pupil_at(0);
  for (int part = 1; part <= film_parts; ++part) {
    const Bounds here = pupil_at(film_radius_ * part / film_parts);
    pupil_.push_back(before);
    pupil_.back().extend(here);
    before = here;
  }
}

double LensSystem::focus_distance() const {
  const double image = image_distance(), beyond = image - points_.focal_length;
  if (!(beyond > 0)) return std::numeric_limits<double>::infinity();
  return points_.focal_length * image / beyond + image + points_.rear_principal - points_.front_principal;
}

LensSystem::Sight LensSystem::sight(Vec2 film, Vec2 u) const {
  const double fx = double(film.x), fy = double(film.y), from_axis = std::sqrt(fx * fx + fy * fy);
  const double part = from_axis / film_radius_ * film_parts;
  const bool is_known = part < film_parts * (1 + 1e-6);  // The corner's own rounding.
  const Bounds bounds = is_known ? pupil_[std::min(std::size_t(part), pupil_.size() - 1)] : rim(from_axis);
  const double width = bounds.x1 - bounds.x0, height = 2 * bounds.y1;
  const double away = bounds.x0 + width * double(u.x), across = height * (double(u.y) - 0.5);
  const double c = from_axis > 0 ? fx / from_axis : 1, s = from_axis > 0 ? fy / from_axis : 0;
  Line line{fx, fy, 0, c * away - s * across - fx, s * away + c * across - fy, plane_};
  line.make_unit();
  const double cosine = line.dz;
  if (!(widest(line, 1) <= 1)) return {};
  const double light = cosine * cosine * cosine * cosine * (width / plane_) * (height / plane_);
  return {{float(line.x), float(line.y), float(line.z)},
          {float(line.dx), float(line.dy), float(line.dz)},
          float(light)};
}

}  // namespace twinray
