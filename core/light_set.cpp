// SPDX-License-Identifier: Apache-2.0
#include "core/light_set.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>

#include "core/alpha_test.h"
#include "core/angle.h"
#include "core/elementary.h"
#include "core/environment.h"
#include "core/frame.h"
#include "core/hash.h"
#include "core/light_bounds.h"
#include "core/mesh_area.h"
#include "core/octahedron.h"
#include "core/point_light.h"
#include "core/spawn_ray.h"
#include "core/texture.h"
#include "core/textured_material.h"
#include "core/warp.h"

namespace twinray {
namespace {

Distribution triangles_by_area(const Mesh& mesh) {
  std::vector<double> areas;
  areas.reserve(mesh.triangles.size());
  for (const Triangle& triangle : mesh.triangles) areas.push_back(area_vector(mesh, triangle).area());
  return Distribution(areas);
}

/// As far around a mesh as half of its diagonal.
Zone zone_around(const Mesh& mesh) {
  Aabb box;
  for (const Triangle& triangle : mesh.triangles)
    for (const std::uint32_t corner : triangle) box.extend(mesh.positions[corner]);
  if (box.is_empty()) return {};
  return {box, 0.25f * length_squared(box.extent())};
}

constexpr Zone everywhere{{{0, 0, 0}, {0, 0, 0}}, std::numeric_limits<float>::infinity()};

/// Radiance of a mesh light at the texture coordinates `uv`, seen from the side that cos_front = cos(front
/// normal, direction to the viewer) names.
Rgb radiance_of_side(const MeshLight& light, Vec2 uv, float cos_front) {
  const bool emits =
      light.side == EmissionSide::both || (light.side == EmissionSide::front) == (cos_front > 0);
  if (!emits || cos_front == 0) return {};
  if (!light.picture) return light.radiance;
  const Vec2 at = light.uv(uv);
  const Rgb shown = light.filter == TextureFilter::nearest ? nearest(*light.picture, light.wrap, at)
                                                           : bilinear(*light.picture, light.wrap, at);
  return light.radiance * at_least_zero(shown);
}

struct Towards {
  Vec3 direction;
  float distance_squared;
};

/// The unit direction and squared distance between two points; none where they coincide.
std::optional<Towards> towards_point(const Vec3& from, const Vec3& to) {
  const Vec3 towards = to - from;
  const float squared = length_squared(towards);
  if (!(squared > 0) || !std::isfinite(squared)) return std::nullopt;
  return Towards{towards / std::sqrt(squared), squared};
}

/// Density per solid angle of a point chosen with density 1 / area, seen under cos(theta) at a squared
/// distance.
float area_to_solid_angle(double area, float distance_squared, float cos_theta) {
  return float(distance_squared / (std::fabs(cos_theta) * area));
}

/// A point of a mesh light.
PatchWeights::Choice choose_point(const Distribution& triangles, const PatchLight& patches,
                                  const Receiver& receiver, Vec2 u) {
  if (!patches.patches.empty()) return PatchWeights(patches, receiver).choose(u);
  const Distribution::Choice choice = triangles.sample(u.x);
  const Vec2 weights = square_to_triangle({choice.remainder, u.y});
  return {choice.index, weights.x, weights.y, 1};
}

LightSample sample_mesh(const MeshLight& light, const Geometry& geometry, double area,
                        const PatchWeights::Choice& choice, const SurfacePoint& from) {
  const SurfacePoint to = triangle_point(geometry, light.shape, choice.triangle, choice.u, choice.v);
  const auto link = towards_point(from.position, to.position);
  if (!link) return {};
  const float cos_front = -dot(to.geometric_normal, link->direction);
  const Hit chosen{.u = choice.u, .v = choice.v, .primitive = choice.triangle, .mesh = light.shape};
  const Vec2 uv = light.picture ? texture_coordinates(geometry, chosen) : to.uv;
  const Rgb radiance = radiance_of_side(light, uv, cos_front);
  if (is_black(radiance)) return {};
  const float pdf = choice.density * area_to_solid_angle(area, link->distance_squared, cos_front);
  return {link->direction, radiance, pdf, connect(from, to)};
}

/// 1 - cos of the half-angle under which a sphere is seen from a distance; 0 from inside of it, and from its
/// own surface, whose points are rounded.
float visible_cone(const Sphere& sphere, float distance_squared) {
  const float offset = sphere_offset(sphere.center, sphere.radius);
  if (!(distance_squared > squared_reach(sphere.radius, offset))) return 0;
  const double sin_squared = double(sphere.radius) * sphere.radius / distance_squared;
  return float(sin_squared / (1 + std::sqrt(1 - sin_squared)));
}

/// The sphere's outward normal where the ray from `from` along a unit direction enters it, or comes closest
/// to it.
Vec3 entry_normal(const Sphere& sphere, const Vec3& from, const Vec3& direction) {
  const double dx = direction.x, dy = direction.y, dz = direction.z;
  const double ox = double(from.x) - sphere.center.x, oy = double(from.y) - sphere.center.y,
               oz = double(from.z) - sphere.center.z;
  const double closest = -(ox * dx + oy * dy + oz * dz) / (dx * dx + dy * dy + dz * dz);
  const double cx = ox + closest * dx, cy = oy + closest * dy, cz = oz + closest * dz;
  const double room = double(sphere.radius) * sphere.radius - (cx * cx + cy * cy + cz * cz);
  const double h = room > 0 ? std::sqrt(room) : 0;
  const double x = cx - h * dx, y = cy - h * dy, z = cz - h * dz;
  const double length = std::sqrt(x * x + y * y + z * z);
  return {float(x / length), float(y / length), float(z / length)};
}

/// The hit of a sphere light that a direction towards it means.
Hit entry_hit(const Sphere& sphere, std::uint32_t shape, const Vec3& from, const Vec3& direction) {
  const Vec3 normal = entry_normal(sphere, from, direction);
  const Vec2 uv = octahedral_encode(double(normal.x), double(normal.y), double(normal.z));
  return {.u = uv.x, .v = uv.y, .mesh = shape};
}

LightSample sample_sphere(const SphereLight& light, const Geometry& geometry, const SurfacePoint& from,
                          Vec2 u) {
  const Sphere& sphere = geometry.sphere_set(light.shape)->spheres[0];
  const auto axis = towards_point(from.position, sphere.center);
  if (!axis) return {};
  const float one_minus_cos = visible_cone(sphere, axis->distance_squared);
  if (!(one_minus_cos > 0)) return {};
  const Vec3 direction = Frame(axis->direction).to_world(square_to_uniform_cone(u, one_minus_cos));
  const SurfacePoint to = sphere_point(sphere, light.shape, entry_normal(sphere, from.position, direction));
  return {direction, light.radiance, uniform_cone_pdf(one_minus_cos), connect(from, to)};
}

LightSample sample_ambient(const AmbientLight& light, const SurfacePoint& from, Vec2 u) {
  const Vec3 direction = Frame(light.up).to_world(square_to_uniform_hemisphere(u));
  return {direction, light.radiance, uniform_hemisphere_pdf(), spawn_ray(from, direction)};
}

LightSample sample_environment(const Environment& environment, const SurfacePoint& from, Vec2 u) {
  const Environment::Sample sample = environment.sample(u);
  if (sample.pdf == 0) return {};
  return {sample.direction, sample.radiance, sample.pdf, spawn_ray(from, sample.direction)};
}

/// A sun's disc, as the cone of directions towards it.
struct Disc {
  float one_minus_cos;  ///< Of its half-angle.
  Rgb radiance;
};

Disc disc_of(const SunLight& sun) {
  const double radius = 0.5 * sun.diameter_degrees * radians_per_degree;
  const double half = sin_radians(0.5 * radius), edge = sin_radians(radius);
  return {float(2 * half * half), sun.irradiance / float(pi * edge * edge)};
}

LightSample sample_sun(const SunLight& sun, const SurfacePoint& from, Vec2 u) {
  const Disc disc = disc_of(sun);
  const Vec3 direction =
      normalize(Frame(-sun.direction).to_world(square_to_uniform_cone(u, disc.one_minus_cos)));
  return {direction, disc.radiance, uniform_cone_pdf(disc.one_minus_cos), spawn_ray(from, direction)};
}

/// Whether a unit direction points into the disc: 1 - cos is half of the squared chord, which keeps its
/// digits where the cosine has none left.
bool is_in_disc(const SunLight& sun, const Vec3& direction) {
  return 0.5f * length_squared(direction + sun.direction) <= disc_of(sun).one_minus_cos;
}

/// The shape of a light that has one, else null.
const std::uint32_t* shape_of(const LightSource& source) {
  if (const auto* mesh = std::get_if<MeshLight>(&source)) return &mesh->shape;
  const auto* sphere = std::get_if<SphereLight>(&source);
  return sphere ? &sphere->shape : nullptr;
}

/// As in pbrt-v4, a shape whose alpha is 0 everywhere emits all its light, and is not seen.
bool leaves_nothing(std::span<const Texture> textures, std::uint32_t alpha) {
  const auto* constant = alpha == no_texture ? nullptr : std::get_if<ConstantTexture>(&textures[alpha].model);
  return constant && !(constant->value.r > 0);
}

/// Radiance of an ambient light along a unit direction towards it.
Rgb ambient_radiance(const AmbientLight& light, const Vec3& direction) {
  return dot(light.up, direction) > 0 ? light.radiance : Rgb{};
}

}  // namespace

bool is_invisible(const Scene& scene, const LightSource& source) {
  const std::uint32_t* const shape = shape_of(source);
  return shape && leaves_nothing(scene.textures, scene.bindings[*shape].alpha);
}

LightSet::LightSet(const Scene& scene, const LightSetOptions& options)
    : lights_(scene.lights),
      bindings_(scene.bindings),
      textures_(scene.textures),
      geometry_(*scene.geometry),
      triangles_(scene.lights.size()),
      alphas_(scene.lights.size(), no_texture),
      is_invisible_(scene.lights.size()),
      patches_(scene.lights.size()),
      zones_(scene.lights.size() + 2),
      group_of_(scene.lights.size(), no_group),
      place_in_group_(scene.lights.size()),
      environment_of_(scene.lights.size()) {
  for (std::uint32_t i = 0; i < size(); ++i) prepare(i, options.compensation);
  make_groups(options.many);
}

void LightSet::prepare(std::uint32_t i, double compensation) {
  if (const std::uint32_t* shape = shape_of(lights_[i].source)) alphas_[i] = bindings_[*shape].alpha;
  is_invisible_[i] = leaves_nothing(textures_, alphas_[i]);
  if (const MeshLight* light = mesh(i)) {
    const Mesh& emitter = *geometry_.mesh(light->shape);
    triangles_[i] = triangles_by_area(emitter);
    patches_[i] = patch_light(emitter, light->side, triangles_[i].total());
    if (!is_invisible_[i]) zones_[i] = zone_around(emitter);
  } else if (const auto* environment = std::get_if<EnvironmentLight>(&lights_[i].source)) {
    zones_[i] = everywhere;
    is_all_a_zone_ = true;
    environment_of_[i] = std::uint32_t(environments_.size());
    environments_.emplace_back(*environment, compensation);
  }
  if (is_distant(lights_[i].source)) distant_.push_back(i);
}

void LightSet::make_groups(ManyLights many) {
  for (std::uint32_t i = 0; i < size(); ++i) {
    const LightSource& source = lights_[i].source;
    if (is_distant(source) || std::holds_alternative<DirectionalLight>(source) || is_invisible_[i])
      sampled_.push_back(i);
    else
      groups_[twinray::is_delta(source) ? points : surfaces].lights.push_back(i);
  }
  for (std::uint32_t g = 0; g < 2; ++g) {
    Group& group = groups_[g];
    if (many == ManyLights::all || group.lights.size() <= most_alone) {
      sampled_.insert(sampled_.end(), group.lights.begin(), group.lights.end());
      continue;
    }
    std::vector<LightBounds> bounds;
    for (const std::uint32_t light : group.lights) {
      place_in_group_[light] = std::uint32_t(bounds.size());
      group_of_[light] = g;
      bounds.push_back(bounds_of(lights_[light].source, geometry_));
      if (g == surfaces) zones_[light] = everywhere;
    }
    group.tree = LightTree(
        bounds, many == ManyLights::power ? LightTree::Choice::power : LightTree::Choice::importance);
    sampled_.push_back(size() + g);
    if (g == surfaces) {
      zones_[size() + g] = everywhere;
      is_all_a_zone_ = true;
    }
  }
  std::sort(sampled_.begin(), sampled_.end());
}

bool LightSet::is_in_a_zone(const Vec3& position) const {
  return is_all_a_zone_ ||
         std::any_of(zones_.begin(), zones_.end(), [&](const Zone& zone) { return zone.contains(position); });
}

LightSample LightSet::sample_group(const Group& group, const SurfacePoint& from, const Receiver& receiver,
                                   Vec2 u) const {
  const auto pick = group.tree.pick(receiver, double(u.x) + double(finer_bits(u)));
  if (!pick) return {};
  return sample_chosen(group.lights[pick->light], pick->probability, from, receiver, {pick->rest, u.y});
}

float LightSet::finer_bits(Vec2 u) {
  const std::uint64_t bits =
      std::uint64_t(std::bit_cast<std::uint32_t>(u.x)) << 32 | std::bit_cast<std::uint32_t>(u.y);
  return float(mix(bits + hash_step) >> 40) * 0x1p-48f;
}

LightSample LightSet::sample_chosen(std::uint32_t light, float probability, const SurfacePoint& from,
                                    const Receiver& receiver, Vec2 u) const {
  LightSample chosen = sample(light, from, receiver, u);
  chosen.light = light;
  chosen.pdf *= probability;
  if (!(chosen.pdf > 0)) return {};
  return chosen;
}

float LightSet::probability_in_group(std::uint32_t light, const Receiver& from) const {
  return groups_[group_of_[light]].tree.probability(place_in_group_[light], from);
}

float LightSet::alpha_of(std::uint32_t light, const Hit& hit) const {
  if (!has_alpha(light) || is_invisible_[light]) return 1;
  return alpha_at(textures_, alphas_[light], texture_point(surface_at(geometry_, hit)));
}

LightSample LightSet::sample(std::uint32_t light, const SurfacePoint& from, const Receiver& receiver,
                             Vec2 u) const {
  if (light >= size()) return sample_group(groups_[light - size()], from, receiver, u);
  const LightSource& source = lights_[light].source;
  if (const auto* mesh = std::get_if<MeshLight>(&source)) {
    const double area = triangles_[light].total();
    if (area == 0) return {};
    const auto choice = choose_point(triangles_[light], patches_[light], receiver, u);
    LightSample chosen = sample_mesh(*mesh, geometry_, area, choice, from);
    chosen.radiance =
        chosen.radiance *
        alpha_of(light, {.u = choice.u, .v = choice.v, .primitive = choice.triangle, .mesh = mesh->shape});
    return chosen;
  }
  if (const auto* sphere = std::get_if<SphereLight>(&source)) {
    LightSample chosen = sample_sphere(*sphere, geometry_, from, u);
    const Sphere& shape = geometry_.sphere_set(sphere->shape)->spheres[0];
    if (has_alpha(light))
      chosen.radiance =
          chosen.radiance * alpha_of(light, entry_hit(shape, sphere->shape, from.position, chosen.direction));
    return chosen;
  }
  if (const auto* point = std::get_if<PointLight>(&source)) return light_from(*point, from);
  if (const auto* spot = std::get_if<SpotLight>(&source)) return light_from(*spot, from);
  if (const auto* goniometric = std::get_if<GoniometricLight>(&source)) return light_from(*goniometric, from);
  if (const auto* projection = std::get_if<ProjectionLight>(&source)) return light_from(*projection, from);
  if (const auto* sun = std::get_if<SunLight>(&source)) return sample_sun(*sun, from, u);
  if (const auto* ambient = std::get_if<AmbientLight>(&source)) return sample_ambient(*ambient, from, u);
  if (std::holds_alternative<EnvironmentLight>(source))
    return sample_environment(environments_[environment_of_[light]], from, u);
  const auto& directional = std::get<DirectionalLight>(source);
  return {-directional.direction, directional.irradiance, 1, spawn_ray(from, -directional.direction)};
}

float LightSet::pdf_alone(std::uint32_t light, const Receiver& from, const Hit& hit) const {
  const LightSource& source = lights_[light].source;
  if (const auto* sphere = std::get_if<SphereLight>(&source)) {
    const Sphere& shape = geometry_.sphere_set(sphere->shape)->spheres[0];
    const float cone = visible_cone(shape, length_squared(shape.center - from.position));
    return cone > 0 ? uniform_cone_pdf(cone) : 0;
  }
  const SurfacePoint on_light = surface_at(geometry_, hit);
  const auto link = towards_point(from.position, on_light.position);
  if (!std::holds_alternative<MeshLight>(source) || !link) return 0;
  const float cosine = dot(on_light.geometric_normal, link->direction);
  if (cosine == 0) return 0;
  const PatchLight& patches = patches_[light];
  const float density =
      patches.patches.empty() ? 1 : PatchWeights(patches, from).density(hit.primitive, hit.u, hit.v);
  return density * area_to_solid_angle(triangles_[light].total(), link->distance_squared, cosine);
}

Rgb LightSet::emitted(const SurfacePoint& point, const Vec3& wo) const {
  const std::uint32_t light = bindings_[point.shape].light;
  if (light == no_light) return {};
  const float cos_front = dot(point.geometric_normal, wo);
  if (const auto* mesh = std::get_if<MeshLight>(&lights_[light].source))
    return radiance_of_side(*mesh, point.uv, cos_front);
  const auto* sphere = std::get_if<SphereLight>(&lights_[light].source);
  return sphere && cos_front > 0 ? sphere->radiance : Rgb{};
}

float LightSet::pdf(std::uint32_t light, const Vec3& direction) const {
  const LightSource& source = lights_[light].source;
  if (const auto* ambient = std::get_if<AmbientLight>(&source))
    return dot(ambient->up, direction) > 0 ? uniform_hemisphere_pdf() : 0;
  if (std::holds_alternative<EnvironmentLight>(source))
    return environments_[environment_of_[light]].pdf(direction);
  if (const auto* sun = std::get_if<SunLight>(&source))
    return is_in_disc(*sun, direction) ? uniform_cone_pdf(disc_of(*sun).one_minus_cos) : 0;
  return 0;
}

Rgb LightSet::radiance(std::uint32_t light, const Vec3& direction) const {
  const LightSource& source = lights_[light].source;
  if (const auto* ambient = std::get_if<AmbientLight>(&source)) return ambient_radiance(*ambient, direction);
  if (std::holds_alternative<EnvironmentLight>(source))
    return environments_[environment_of_[light]].radiance(direction);
  if (const auto* sun = std::get_if<SunLight>(&source))
    return is_in_disc(*sun, direction) ? disc_of(*sun).radiance : Rgb{};
  return {};
}

Environment::View LightSet::view(std::uint32_t light, const Vec3& direction) const {
  if (const Environment* const map = environment(light)) return map->view(direction);
  return {radiance(light, direction), pdf(light, direction)};
}

void LightSet::view(std::span<const Vec3> directions, std::span<Environment::View> views) const {
  constexpr std::size_t together = Environment::together;
  Environment::View of_light[together];
  for (std::size_t place = 0; place < distant_.size(); ++place)
    for (std::size_t first = 0; first < directions.size(); first += together) {
      const auto some = directions.subspan(first, std::min(together, directions.size() - first));
      if (const Environment* const map = environment(distant_[place]))
        map->view(some, of_light);
      else
        for (std::size_t i = 0; i < some.size(); ++i) of_light[i] = view(distant_[place], some[i]);
      for (std::size_t i = 0; i < some.size(); ++i)
        views[(first + i) * distant_.size() + place] = of_light[i];
    }
}

Rgb LightSet::escaped(const Vec3& direction) const {
  Rgb sum;
  for (const std::uint32_t light : distant_) sum += radiance(light, direction);
  return sum;
}

Rgb LightSet::background(const Vec3& direction) const {
  Rgb sum;
  for (const std::uint32_t light : distant_)
    if (is_background(lights_[light].source)) sum += radiance(light, direction);
  return sum;
}

void LightSet::background(std::span<const Vec3> directions, std::span<Rgb> radiances) const {
  constexpr std::size_t together = Environment::together;
  Rgb of_light[together];
  std::fill_n(radiances.begin(), directions.size(), Rgb{});
  for (const std::uint32_t light : distant_) {
    if (!is_background(lights_[light].source)) continue;
    for (std::size_t first = 0; first < directions.size(); first += together) {
      const auto some = directions.subspan(first, std::min(together, directions.size() - first));
      if (const Environment* const map = environment(light))
        map->radiance(some, of_light);
      else
        for (std::size_t i = 0; i < some.size(); ++i) of_light[i] = radiance(light, some[i]);
      for (std::size_t i = 0; i < some.size(); ++i) radiances[first + i] += of_light[i];
    }
  }
}

}  // namespace twinray
