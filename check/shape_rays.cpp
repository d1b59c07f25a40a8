// SPDX-License-Identifier: Apache-2.0
#include "check/shape_rays.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace twinray {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

// No expression draws twice: compilers differ in which operand they work out first, and so in the rays.

/// A zero of either sign.
float signed_zero(Random& random) { return random.below(2) ? 0.0f : -0.0f; }
float sign(Random& random) { return random.below(2) ? 1.0f : -1.0f; }

/// x moved by up to two floats either way.
float nudged(Random& random, float x) {
  const int steps = random.between(-2, 2);
  for (int i = 0; i < std::abs(steps); ++i) x = std::nextafter(x, steps < 0 ? -infinity : infinity);
  return x;
}
Vec3 nudged(Random& random, Vec3 p) {
  for (int axis = 0; axis < 3; ++axis) p[axis] = nudged(random, p[axis]);
  return p;
}

Vec3 between(const Vec3& a, const Vec3& b, float s) { return a + (b - a) * s; }

/// From one point at another; along x where they are the same.
Ray through(const Vec3& origin, const Vec3& target) {
  const Vec3 direction = target - origin;
  return {.origin = origin, .direction = max_abs(direction) > 0 ? direction : Vec3{1, 0, 0}};
}

}  // namespace

ShapeRays::ShapeRays(std::shared_ptr<const Geometry> geometry, const Accelerator& engine, std::uint64_t seed)
    : geometry_(std::move(geometry)), engine_(engine), seed_(seed) {
  std::uint64_t count = 0;
  for (std::uint32_t shape = 0; shape < geometry_->shapes().size(); ++shape) {
    const Mesh* mesh = geometry_->mesh(shape);
    count += mesh ? mesh->triangles.size() : geometry_->sphere_set(shape)->spheres.size();
    ends_.push_back(count);
  }
  std::uint64_t standing = geometry_->primitive_count(geometry_->direct_shapes());
  standing_.push_back(standing);
  std::vector<std::uint64_t> of_prototypes;
  for (const ShapeRange& prototype : geometry_->prototypes())
    of_prototypes.push_back(geometry_->primitive_count(prototype));
  for (const Instance& instance : geometry_->instances())
    standing_.push_back(standing += of_prototypes[instance.prototype]);
  const Aabb& bounds = geometry_->bounds();
  if (bounds.is_empty()) return;
  center_ = bounds.center();
  size_ = 0.5f * max_abs(bounds.extent());
}

Ray ShapeRays::ray(RayClass ray_class, std::uint64_t number) const {
  Random random(seed_ * ray_class_count + std::uint64_t(ray_class), number);
  return make(ray_class, random);
}

Ray ShapeRays::make(RayClass ray_class, Random& random) const {
  switch (ray_class) {
    case RayClass::random:
      return random_ray(random);
    case RayClass::vertices:
      return vertex_ray(random);
    case RayClass::edges:
      return edge_ray(random);
    case RayClass::axes:
      return axis_ray(random);
    case RayClass::box_faces:
      return box_face_ray(random);
    case RayClass::grazing:
      return grazing_ray(random);
    case RayClass::surface:
      return surface_ray(random);
    case RayClass::ends:
      return end_ray(random);
    case RayClass::directions:
      return direction_ray(random);
    case RayClass::far:
      return far_ray(random);
    case RayClass::moved:
    case RayClass::shrunk:
    case RayClass::grown:
      return mixed_ray(random);
    default:
      throw Error("rays of light paths are not made from shapes");
  }
}

ShapeRays::Corners ShapeRays::corners(Random& random) const {
  const std::uint64_t count = standing_.back();
  if (count == 0) {
    const Vec3 a = random.in_cube(), b = random.in_cube(), c = random.in_cube();
    return {a, b, c};
  }
  const std::uint64_t chosen = random.bits() % count;
  if (chosen < standing_.front()) return own_corners(chosen);
  const auto end = std::upper_bound(standing_.begin(), standing_.end(), chosen);
  const Instance& instance = geometry_->instances()[std::size_t(end - standing_.begin()) - 1];
  const std::uint32_t first = geometry_->prototypes()[instance.prototype].first;
  Corners all = own_corners(chosen - *(end - 1) + (first == 0 ? 0 : ends_[first - 1]));
  for (Vec3& corner : all) corner = instance.to_world.point(corner);
  return all;
}

ShapeRays::Corners ShapeRays::own_corners(std::uint64_t number) const {
  const auto shape = std::uint32_t(std::upper_bound(ends_.begin(), ends_.end(), number) - ends_.begin());
  const std::uint64_t index = number - (shape == 0 ? 0 : ends_[shape - 1]);
  if (const Mesh* mesh = geometry_->mesh(shape)) {
    const auto [a, b, c] = mesh->triangles[index];
    return {mesh->positions[a], mesh->positions[b], mesh->positions[c]};
  }
  const auto& [center, radius] = geometry_->sphere_set(shape)->spheres[index];
  return {center + Vec3{radius, 0, 0}, center + Vec3{0, -radius, 0}, center + Vec3{0, 0, radius}};
}

Vec3 ShapeRays::point(Random& random, float reach) const { return center_ + random.in_cube(reach * size_); }

Ray ShapeRays::random_ray(Random& random) const {
  const Vec3 origin = point(random, 2), target = point(random, 1);
  Ray ray = through(origin, target);
  if (random.below(2)) ray.t_max = 1;
  return ray;
}

Ray ShapeRays::vertex_ray(Random& random) const {
  const Corners v = corners(random);
  return through(point(random, 1.5f), v[0]);
}

Ray ShapeRays::edge_ray(Random& random) const {
  const Corners v = corners(random);
  const Vec3 target = between(v[0], v[1], random.unit());
  return through(point(random, 1.5f), target);
}

Ray ShapeRays::axis_ray(Random& random) const {
  const Corners v = corners(random);
  Ray ray{.origin = random.below(2) ? v[0] : between(v[0], v[1], 0.5f)};
  const int axis = random.below(3);
  for (int other = 0; other < 3; ++other) ray.direction[other] = signed_zero(random);
  ray.direction[axis] = sign(random);
  ray.origin[axis] -= ray.direction[axis] * size_ * random.uniform(0, 3);
  return ray;
}

Ray ShapeRays::box_face_ray(Random& random) const {
  const Corners v = corners(random);
  const Aabb box = triangle_bounds(v[0], v[1], v[2]);
  const int axis = random.below(3);
  const Vec3 target = between(v[0], v[1], random.unit());
  Ray ray = through(point(random, 1.5f), target);
  ray.origin[axis] = random.below(2) ? box.lower[axis] : box.upper[axis];
  ray.direction[axis] = signed_zero(random);
  if (random.below(2)) ray.direction[(axis + 1) % 3] = signed_zero(random);
  if (max_abs(ray.direction) == 0) ray.direction[(axis + 2) % 3] = 1;
  return ray;
}

Ray ShapeRays::grazing_ray(Random& random) const {
  const Corners v = corners(random);
  const float s = random.uniform(-3, 3), t = random.uniform(-3, 3), along = random.unit();
  const Vec3 origin = v[0] + (v[1] - v[0]) * s + (v[2] - v[0]) * t;
  const Vec3 target = between(between(v[0], v[1], along), v[2], random.unit());
  return through(nudged(random, origin), target);
}

Ray ShapeRays::surface_ray(Random& random) const {
  const Corners v = corners(random);
  const float s = random.unit();
  const Vec3 origin = between(between(v[0], v[1], s), v[2], random.unit());
  return {.origin = origin, .direction = random.in_ball()};
}

Ray ShapeRays::end_ray(Random& random) const {
  Ray ray = random.below(2) ? random_ray(random) : edge_ray(random);
  const int kind = random.below(5);
  const float t = engine_.closest_hit(ray).t;
  if (std::isinf(t)) return ray;
  if (kind == 0) ray.t_min = t;
  if (kind == 1) ray.t_max = t;
  if (kind == 2) ray.t_min = ray.t_max = t;
  if (kind == 3) ray.t_min = std::nextafter(t, infinity);
  if (kind == 4) ray.t_max = std::nextafter(t, 0.0f);
  ray.t_max = std::max(ray.t_max, ray.t_min);
  return ray;
}

Ray ShapeRays::direction_ray(Random& random) const {
  Ray ray = random.below(2) ? random_ray(random) : vertex_ray(random);
  ray.t_max = infinity;
  const int exponent = random.between(-148, 127) - std::ilogb(max_abs(ray.direction));
  for (int axis = 0; axis < 3; ++axis) ray.direction[axis] = std::ldexp(ray.direction[axis], exponent);
  return ray;
}

Ray ShapeRays::far_ray(Random& random) const {
  // From 10^5 sizes on the rounding of the ray is as large as the scene and every box is hit: few such rays.
  constexpr float near[] = {5, 20, 1e3f, 1e4f};
  const int kind = random.below(64);
  const float sizes = kind == 0 ? 1e7f : kind < 4 ? 1e5f : near[kind % 4];
  const Vec3 away = random.in_ball();
  const float distance = std::min(sizes * size_, 0x1p58f);
  const Vec3 target = random.below(2) ? point(random, 1) : corners(random)[0];
  return through(target + away * distance, target);
}

Ray ShapeRays::mixed_ray(Random& random) const {
  constexpr RayClass mixed[] = {RayClass::random,    RayClass::vertices, RayClass::edges, RayClass::axes,
                                RayClass::box_faces, RayClass::surface,  RayClass::ends};
  return make(mixed[random.below(7)], random);
}

}  // namespace twinray
