// SPDX-License-Identifier: Apache-2.0
#include "integrators/wave/path_wave.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "core/octahedron.h"
#include "core/offset.h"
#include "core/spawn_ray.h"
#include "core/warp.h"
#include "integrators/layer_records.h"

namespace twinray {

PathWave::PathWave(const WaveContext& context, SamplerKind kind, Tracer& tracer, Wave& wave,
                   std::span<const CameraSample> samples, const RecordSpans& records)
    : context_(context),
      stages_(context.stages),
      kind_(kind),
      tracer_(tracer),
      wave_(wave),
      paths_(wave.paths),
      surfaces_(wave.surfaces),
      light_(wave.light),
      connections_(wave.connections),
      samples_(samples),
      records_(records),
      radiance_(records.color()),
      has_light_paths_(records.has(Division::paths)),
      has_light_groups_(records.has(Division::groups)) {
  wave_.views.resize(views_together * context.transport.lights.distant().size());
  if (has_light_groups_)
    wave_.group_sums.assign(samples.size() * context.transport.scene.light_groups.size(), Rgb{});
}

void PathWave::trace() {
  start();
  const std::span<const Ray> rays(wave_.rays);
  const std::span<Hit> hits(wave_.hits);
  take_off(0);
  tracer_.camera_hits(rays.first(paths_.size), hits.first(paths_.size));
  fly(0);
  record_coverage();
  for (;; ++depth_) {
    tracer_.arrive();
    if (context_.options.counts(depth_)) depth_ == 0 ? add_emission() : add_found_light();
    const bool has_ended = depth_ >= context_.options.depth_limit();
    if (has_ended && !(depth_ == 0 && records_.has_layers())) return;
    drop_ended();
    if (paths_.size == 0) return;
    arrive();
    record_surfaces();
    if (has_ended) return;
    if (context_.options.counts(depth_ + 1)) add_direct_light();
    // The ray after the last surface only looks for light.
    const bool is_last = depth_ + 1 >= context_.options.depth_limit();
    if ((is_last && !may_find_light()) || !scatter(is_last)) return;
    take_off(std::uint32_t(depth_) + 1);
    tracer_.bounce_hits(rays.first(paths_.size), hits.first(paths_.size));
    fly(depth_ + 1);
  }
}

void PathWave::start() {
  paths_.size = samples_.size();
  records_.clear();
  std::iota(paths_.sample.values, paths_.sample.values + paths_.size, 0u);
  paths_.throughput.fill(paths_.size, 1);
  std::fill_n(paths_.materials.values, paths_.size, std::uint32_t(Materials::exact));
  std::fill_n(paths_.bounces.values, paths_.size, 0u);
  std::fill_n(paths_.eta_squared.values, paths_.size, 1.0f);
  PixelKeys pixel_key;
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    paths_.pixel.set(i, pixel_key(samples_[i].key));
    paths_.index[i] = samples_[i].key.index;
    paths_.interiors.set(i, samples_[i].interiors.bits());
    paths_.direction.set(i, samples_[i].ray.direction);
    paths_.cone_width[i] = samples_[i].cone.width;
    paths_.cone_spread[i] = samples_[i].cone.spread;
    wave_.rays[i] = samples_[i].ray;
  }
}

Departure PathWave::departure_from(std::size_t surface) const {
  return {receiver_at(surface), wave_.pdf[surface], Seeking(wave_.seeking[surface])};
}

Receiver PathWave::receiver_at(std::size_t surface) const {
  return {surfaces_.point.position.at(surface), surfaces_.shading.at(surface),
          surfaces_.lets_through[surface] != 0};
}

bool PathWave::may_find_light() const {
  if (!wave_.others.empty()) return true;
  for (std::size_t i = 0; i < paths_.size; ++i)
    if (twinray::may_find_light(context_.transport, departure_from(i))) return true;
  return false;
}

void PathWave::arrive() {
  if (has_textures()) prepare_textures();
  expand_hits();
  stages_.find_facets(surfaces_.triangle, surfaces_.point, paths_.size);
  stages_.find_points(surfaces_, paths_.size);
  place_others();
  if (has_textures()) {
    ask_for_texels();
    find_textured_reflectances();
  }
  find_others();
  stages_.find_interactions(paths_, surfaces_);
  std::fill_n(wave_.seeking.values, paths_.size, std::uint32_t(Seeking::zones));
  show_others();
}

namespace {

/// How many hits ahead memory is asked for what a hit is expanded from: for the triangle, and once that is
/// there for its corners.
constexpr std::size_t triangle_ahead = 16, corners_ahead = 8;

void prefetch_triangle(const ShapeEntry& shape, std::uint32_t triangle) {
  if (!shape.positions) return;
  __builtin_prefetch(shape.triangles + triangle);
  if (shape.normals) __builtin_prefetch(shape.normal_indices + triangle);
  if (shape.uvs) __builtin_prefetch(shape.uv_indices + triangle);
}

void prefetch_corners(const ShapeEntry& shape, std::uint32_t triangle) {
  if (!shape.positions) return;
  for (const std::uint32_t corner : shape.triangles[triangle]) __builtin_prefetch(shape.positions + corner);
  if (shape.normals)
    for (const std::uint32_t corner : shape.normal_indices[triangle])
      __builtin_prefetch(shape.normals + corner);
  if (shape.uvs)
    for (const std::uint32_t corner : shape.uv_indices[triangle]) __builtin_prefetch(shape.uvs + corner);
}

/// The corners of a triangle, for position `i` of the columns.
void gather_triangle(const ShapeEntry& shape, std::uint32_t triangle, TrianglePoints& corners,
                     std::size_t i) {
  const auto& [a, b, c] = shape.triangles[triangle];
  corners.a.set(i, shape.positions[a]);
  corners.b.set(i, shape.positions[b]);
  corners.c.set(i, shape.positions[c]);
}

}  // namespace

void PathWave::prefetch_surfaces(std::size_t i) const {
  const auto ahead = [&](std::size_t k) -> const Hit& { return wave_.hits[std::min(k, paths_.size - 1)]; };
  const Hit &later = ahead(i + triangle_ahead), &next = ahead(i + corners_ahead);
  prefetch_triangle(context_.shapes[later.mesh], later.primitive);
  prefetch_corners(context_.shapes[next.mesh], next.primitive);
}

void PathWave::expand_hits() {
  wave_.placed_alone.clear();
  for (std::size_t i = 0; i < paths_.size; ++i) {
    if (context_.prefetches) prefetch_surfaces(i);
    const Hit& hit = wave_.hits[i];
    const ShapeEntry& shape = context_.shapes[hit.mesh];
    surfaces_.reflectance.set(i, shape.reflectance);
    if (is_placed_alone(hit)) {
      wave_.placed_alone.push_back(std::uint32_t(i));
      // Lanes work out a point that no one reads: far from the edges of whatever triangle was there before.
      surfaces_.triangle.u[i] = surfaces_.triangle.v[i] = 1.0f / 3;
      continue;
    }
    surfaces_.triangle.u[i] = hit.u;
    surfaces_.triangle.v[i] = hit.v;
    gather_triangle(shape, hit.primitive, surfaces_.triangle, i);
    if (shape.normals) {
      const auto& [a, b, c] = shape.normal_indices[hit.primitive];
      surfaces_.normal_a.set(i, shape.normals[a]);
      surfaces_.normal_b.set(i, shape.normals[b]);
      surfaces_.normal_c.set(i, shape.normals[c]);
    } else {
      for (Columns3* const normal : {&surfaces_.normal_a, &surfaces_.normal_b, &surfaces_.normal_c})
        normal->set(i, Vec3{});
    }
  }
}

namespace {

SurfacePoint point_in_medium(const Ray& ray, float t) {
  SurfacePoint point;
  point.position = ray.origin + ray.direction * t;
  point.geometric_normal = point.shading_normal = -normalize(ray.direction);
  return point;
}

}  // namespace

void PathWave::place_others() {
  const Geometry& geometry = *context_.transport.scene.geometry;
  for (const std::uint32_t i : wave_.placed_alone) {
    const SurfacePoint point = is_in_medium(i) ? point_in_medium(wave_.rays[i], wave_.hits[i].t)
                                               : surface_at(geometry, wave_.hits[i]);
    surfaces_.point.position.set(i, point.position);
    surfaces_.point.normal.set(i, point.geometric_normal);
    surfaces_.point.offset[i] = point.offset;
    surfaces_.shading.set(i, point.shading_normal);
  }
}

void PathWave::add_direct_light() {
  connections_.sum.clear(paths_.size);
  if (context_.transport.method == DirectMethod::hemisphere)
    add_hemisphere();
  else
    add_lights();
  for (std::size_t i = 0; i < paths_.size; ++i)
    radiance_[paths_.sample[i]] +=
        context_.options.clamped(paths_.throughput.at<Rgb>(i) * connections_.sum.at<Rgb>(i), depth_ + 1);
  if (has_light_paths_) add_direct_paths();
  if (has_light_groups_) add_direct_groups();
}

void PathWave::add_lights() {
  for (const std::uint32_t light : context_.transport.lights.sampled()) {
    sample_light(light);
    const float count = float(context_.transport.samples_of(light));
    for (std::size_t i = 0; i < paths_.size; ++i)
      connections_.sum.set(i, connections_.sum.at<Rgb>(i) + connections_.of_light.at<Rgb>(i) / count);
  }
}

void PathWave::draw(Purpose purpose, const SubSample& sub, Floats& x, Floats& y) {
  draw_at(std::uint32_t(depth_) + 1, purpose, sub, x, y);
}

void PathWave::draw_at(std::uint32_t vertex, Purpose purpose, const SubSample& sub, Floats& x, Floats& y) {
  DrawPlace place = place_of(purpose, vertex);
  place.member -= place.member % 2;
  stages_.draw(paths_.pixel, paths_.index, paths_.size, {kind_, place, sub}, x, y);
}

namespace {

/// A sphere light all of whose sphere emits; null for another light and for a group.
const SphereLight* plain_sphere(const LightSet& lights, std::uint32_t light) {
  if (light >= lights.size() || lights.has_alpha(light)) return nullptr;
  return std::get_if<SphereLight>(&lights.light(light).source);
}

}  // namespace

void PathWave::sample_light(std::uint32_t light) {
  connections_.of_light.clear(paths_.size);
  const MeshLight* mesh = context_.transport.lights.mesh(light);
  if (mesh && context_.transport.lights.triangles(light).total() == 0) return;
  // Lanes know neither alpha nor pictures.
  if (mesh && (mesh->picture || context_.transport.lights.has_alpha(light))) mesh = nullptr;
  const SphereLight* const sphere = plain_sphere(context_.transport.lights, light);
  const Environment* const environment = context_.transport.lights.environment(light);
  const std::uint32_t count = context_.transport.samples_of(light);
  MisRequest mis{.count = float(count)};
  if (context_.transport.method == DirectMethod::mis) {
    mis.zone = context_.transport.lights.zone(light);
    mis.is_shared = !context_.transport.lights.is_delta(light);
  }
  if (const PatchLight* patches = mesh ? context_.patches[light].light : nullptr)
    stages_.weigh_patches(*patches, surfaces_, paths_.size, wave_.corners);
  for (std::uint32_t part = 0; part < count; ++part) {
    draw(Purpose::light_point, {part, count, light}, light_.ux, light_.uy);
    if (mesh)
      sample_mesh_light(light, *mesh);
    else if (sphere)
      sample_sphere_light(*sphere);
    else if (environment)
      sample_environment(*environment);
    else if (light >= context_.transport.lights.size())
      sample_group(light);
    else
      sample_other_light(light);
    stages_.scatter_light(surfaces_, light_, paths_.size, mis, connections_);
    scatter_light_at_lobes(mis);
    if (context_.has_interiors && !context_.transport.passages) absorb_light();
    scatter_light_at_others(light);
    stages_.make_shadow_rays(light_, paths_.size, connections_);
    connect();
    stages_.add_connections(light_, paths_.size, connections_);
    if (has_light_paths_ && depth_ == 0) gather_scattered_light(float(count));
    if (has_light_groups_) gather_groups(light, float(count));
  }
}

void PathWave::sample_mesh_light(std::uint32_t light, const MeshLight& mesh) {
  const Distribution& triangles = context_.transport.lights.triangles(light);
  const PatchTable& patches = context_.patches[light];
  if (patches.light)
    stages_.choose_of_patches(patches, wave_.corners, light_, paths_.size);
  else
    choose_of_many(triangles, context_.shapes[mesh.shape]);
  stages_.sample_mesh_light(surfaces_, {mesh.radiance, mesh.side, triangles.total()}, light_, paths_.size);
}

void PathWave::choose_of_many(const Distribution& triangles, const ShapeEntry& shape) {
  for (std::size_t i = 0; i < paths_.size; ++i) {
    const Distribution::Choice choice = triangles.sample(light_.ux[i]);
    const Vec2 weights = square_to_triangle({choice.remainder, light_.uy[i]});
    light_.triangle.u[i] = weights.x;
    light_.triangle.v[i] = weights.y;
    light_.density[i] = 1;
    gather_triangle(shape, choice.index, light_.triangle, i);
  }
  stages_.find_facets(light_.triangle, light_.point, paths_.size);
}

void PathWave::sample_sphere_light(const SphereLight& light) {
  const Sphere& sphere = context_.transport.scene.geometry->sphere_set(light.shape)->spheres[0];
  const float offset = sphere_offset(sphere.center, sphere.radius);
  stages_.sample_sphere_light(surfaces_, {light.radiance, sphere.center, sphere.radius, offset}, light_,
                              paths_.size);
}

void PathWave::sample_environment(const Environment& environment) {
  std::array<Vec2, wave_size> draws;
  std::array<Environment::Sample, wave_size> samples;
  for (std::size_t i = 0; i < paths_.size; ++i) draws[i] = {light_.ux[i], light_.uy[i]};
  environment.sample(std::span(draws).first(paths_.size), std::span(samples).first(paths_.size));
  for (std::size_t i = 0; i < paths_.size; ++i) {
    const Environment::Sample& sample = samples[i];
    light_.direction.set(i, sample.direction);
    light_.radiance.set(i, sample.radiance);
    light_.pdf[i] = sample.pdf > 0 ? sample.pdf : 1;
    const Ray ray = sample.pdf > 0 ? spawn_ray(point_at(i), sample.direction) : Ray{};
    light_.origin.set(i, ray.origin);
    light_.towards.set(i, ray.direction);
    light_.t_max[i] = ray.t_max;
    light_.source[i] = 0;
  }
}

SurfacePoint PathWave::point_at(std::size_t surface) const {
  SurfacePoint point;
  point.position = surfaces_.point.position.at(surface);
  point.geometric_normal = surfaces_.point.normal.at(surface);
  point.offset = surfaces_.point.offset[surface];
  return point;
}

void PathWave::sample_other_light(std::uint32_t light) {
  for (std::size_t i = 0; i < paths_.size; ++i)
    keep_light_sample(i, context_.transport.lights.sample(light, point_at(i), receiver_at(i),
                                                          {light_.ux[i], light_.uy[i]}));
}

void PathWave::connect() {
  if (context_.transport.passages) return connect_through_passages();
  const std::span<const Rgb> visible =
      tracer_.visibilities(std::span(connections_.rays).first(connections_.size));
  for (std::size_t k = 0; k < connections_.size; ++k)
    connections_.arriving.set(connections_.surface[k], visible[k]);
}

void PathWave::add_hemisphere() {
  const std::uint32_t count = context_.transport.directions();
  if (count == 0) return;
  const float divisor = float(count) * uniform_hemisphere_pdf();
  connections_.of_light.clear(paths_.size);
  connections_.passed.assign(wave_size, Rgb{1, 1, 1});
  for (std::uint32_t part = 0; part < count; ++part) {
    draw(Purpose::light_point, {part, count, 0}, light_.ux, light_.uy);
    stages_.sample_hemisphere(surfaces_, light_, paths_.size);
    stages_.scatter_light(surfaces_, light_, paths_.size, {}, connections_);
    look_around_others();
    stages_.make_shadow_rays(light_, paths_.size, connections_);
    const std::span<Hit> hits = std::span(connections_.hits).first(connections_.size);
    tracer_.bounce_hits(std::span(connections_.rays).first(connections_.size), hits);
    for (std::size_t k = 0; k < connections_.size; ++k)
      connections_.arriving.set(connections_.surface[k], found_around(k));
    stages_.add_connections(light_, paths_.size, connections_);
    if (has_light_paths_ && depth_ == 0) gather_scattered_light(divisor);
    if (has_light_groups_) gather_groups_around(divisor);
  }
  for (std::size_t i = 0; i < paths_.size; ++i)
    connections_.sum.set(i, connections_.of_light.at<Rgb>(i) / divisor);
}

Rgb PathWave::found_around(std::size_t k) {
  if (!context_.has_interiors && !context_.transport.passages)
    return lamp_radiance(context_.transport, connections_.hits[k], connections_.rays[k].direction);
  Way way{connections_.rays[k], connections_.hits[k], interiors_of(k)};
  if (context_.transport.passages) context_.transport.passages->follow(tracer_, way);
  connections_.hits[k] = way.hit;
  connections_.passed[k] =
      way.left * transmittance(context_.transport.scene, way.interiors, way.ray, way.hit.t);
  return lamp_radiance(context_.transport, way.hit, way.ray.direction) * connections_.passed[k];
}

bool PathWave::scatter(bool is_last) {
  draw(Purpose::direction, {}, wave_.ux, wave_.uy);
  keep_throughput_at_others();
  stages_.scatter_paths(surfaces_, wave_);
  const bool has_limits = context_.options.limits.are_any();
  if (has_limits) std::fill_n(wave_.kind.values, paths_.size, std::uint32_t(ScatterKind::diffuse));
  scatter_at_others();
  if (!wave_.walks.empty()) walk();
  if (records_.has(Layer::albedo) || records_.has(Layer::normal)) follow_mirrors();
  if (has_light_paths_ && depth_ == 0) keep_first_scattering();
  if (has_limits) count_bounces();
  if (context_.options.regularize) regularize_scattered();
  if (has_textures()) widen_cones();
  std::size_t kept = stages_.keep_paths(wave_);
  if (is_last || has_limits) kept = keep_light_seekers(kept, is_last);
  if (context_.options.roulette.applies(depth_ + 1)) kept = play_roulette(kept);
  for (std::size_t k = 0; k < kept; ++k) {
    const std::size_t i = wave_.kept[k];
    wave_.rays[k] = {.origin = wave_.origin.at(i), .direction = paths_.direction.at(i)};
  }
  compact(kept);
  return kept > 0;
}

void PathWave::regularize_scattered() {
  for (std::size_t i = 0; i < paths_.size; ++i)
    if (Seeking(wave_.seeking[i]) != Seeking::alone)
      paths_.materials[i] = std::uint32_t(Materials::regularized);
}

}  // namespace twinray
