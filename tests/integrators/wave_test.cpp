// SPDX-License-Identifier: Apache-2.0
// Waves of paths against the path tracer that traces one after the other: every bit, every ray.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "core/instruction_sets.h"
#include "core/textured_material.h"
#include "integrators/path.h"
#include "integrators/path_log.h"
#include "integrators/path_reference.h"
#include "integrators/replay.h"
#include "tests/support/catch.h"
#include "tests/support/instances.h"
#include "tests/support/scenes.h"
#include "tests/support/wave_scenes.h"

namespace twinray::test {
namespace {

/// Of the whole frame. Every third starts in the interior of the last material, if that has one.
std::vector<CameraSample> samples_of(const Scene& scene, std::uint32_t count) {
  const Camera camera = fit_frame(scene.camera, 4, 3);
  std::vector<CameraSample> samples;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Vec2 frame{(float(i % 50) + 0.5f) / 50, (float(i / 50 % 40) + 0.5f) / 40};
    samples.push_back(
        {camera_ray(camera, frame, {}), {7, i % 50, i / 50, i * 2654435761u}, {0.001f, 0.004f}});
    if (i % 3 == 0 && has_interior(scene.materials.back()))
      samples.back().interiors.enter(std::uint32_t(scene.materials.size() - 1));
  }
  return samples;
}

constexpr SamplerKind samplers[] = {SamplerKind::sobol, SamplerKind::independent};

const PathOptions cases[] = {{},
                             {.max_depth = 0},
                             {.max_depth = 1},
                             {.max_depth = 3, .direct = DirectMethod::lights},
                             {.max_depth = 12},
                             {.max_depth = 3, .samples_per_light = 5},
                             {.max_depth = 4, .first_depth = 2, .last_depth = 3},
                             {.max_depth = 6, .roulette = {0.6f}},
                             {.max_depth = 6, .clamp = 0.3f, .regularize = true},
                             {.max_depth = 8, .limits = {.diffuse = 1, .glossy = 2, .transmission = 3}},
                             {.max_depth = 4, .limits = {.glossy = 0}, .roulette = {0.6f}},
                             {.max_depth = 9, .direct = DirectMethod::lights, .limits = {.transmission = 1}},
                             {.max_depth = 6, .samples_per_light = 65536 / 64, .roulette = {1e-3f}},
                             {.max_depth = 3, .direct = DirectMethod::hemisphere, .samples_per_light = 2},
                             {.max_depth = 1, .direct = DirectMethod::hemisphere}};

/// All that a record can be asked for.
FilmContents everything(const Scene& scene) {
  return {all_layers(), {light_path_count, scene.light_groups.size()}};
}

/// The scene with its lights in two groups.
Scene grouped(Scene scene) {
  scene.light_groups = {"even", "odd"};
  scene.media_group = 1;
  for (std::size_t i = 0; i < scene.lights.size(); ++i) scene.lights[i].group = i % 2;
  return scene;
}

bool same_bits(std::span<const Rgb> a, std::span<const Rgb> b) {
  if (a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0) return true;
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Rgb& p, const Rgb& q) { return twinray::same_bits(p, q); });
}

/// Checks that waves have the bits and the rays of the reference, on every instruction set.
void check_bits(const Scene& of, const PathOptions& options, std::uint32_t count, SamplerKind kind) {
  const bool counting = &options == cases;  // What rays do is slow to count, and does not depend on options.
  const Scene scene = grouped(of);
  const auto accelerator = build_accelerator(Backend::bvh, scene.geometry);
  const std::vector<CameraSample> samples = samples_of(scene, count);
  Records expected(everything(scene), count);
  Tracer alone(*accelerator, counting);
  PathReference(scene, options).sample(samples, kind, alone, expected.spans(count));
  // A scene whose paths end at once would show nothing.
  if (options.depth_limit() >= 5 && options.roulette.continuation == 0 && !options.limits.are_any())
    REQUIRE(alone.counts().bounce > count / 2);
  for (const std::string& simd : available_instruction_sets()) {
    CAPTURE(simd, sampler_name(kind), options.max_depth, options.samples_per_light);
    Records found(everything(scene), count);
    Tracer together(*accelerator, counting);
    PathIntegrator(scene, options, simd).sample(samples, kind, together, found.spans(count));
    CHECK(same_bits(found.spans(count).color(), expected.spans(count).color()));
    for (const Layer layer : all_layers()) {
      CAPTURE(layer_info(layer).name);
      CHECK(same_bits(found.spans(count)[layer], expected.spans(count)[layer]));
    }
    for (const Division division : divisions)
      CHECK(same_bits(found.spans(count)[division].values(), expected.spans(count)[division].values()));
    CHECK(together.counts() == alone.counts());
  }
}

/// What the lights found bring together.
Rgb found_together(const PathVertex& vertex) {
  Rgb sum;
  for (const FoundLight& found : vertex.found) sum += found.radiance * found.weight;
  return sum;
}

/// Direct light by the light samples of a vertex, source by source.
Rgb light_of_samples(const std::vector<LoggedLightSample>& samples) {
  Rgb sum;
  for (std::size_t first = 0, next = 0; first < samples.size(); first = next) {
    Rgb of_source;
    for (next = first; next < samples.size() && samples[next].taken.source == samples[first].taken.source;
         ++next) {
      const TakenLightSample& taken = samples[next].taken;
      if (!is_black(taken.scattered)) of_source += taken.scattered * taken.visibility / taken.sample.pdf;
    }
    sum += of_source / float(next - first);
  }
  return sum;
}

/// Checks that what is written of a vertex makes the terms that it adds, and the throughput behind it.
void check_vertex(const PathVertex& vertex, DirectMethod method) {
  const Rgb throughput = vertex.arrival.throughput;
  if (vertex.emission) CHECK(vertex.emission->light == throughput * found_together(vertex));
  if (vertex.direct_light && method != DirectMethod::hemisphere)
    CHECK(vertex.direct_light->light == throughput * light_of_samples(vertex.light_samples));
  for (const auto& [taken, weight, bsdf_pdf] : vertex.light_samples)
    CHECK(taken.scattered ==
          vertex.surface->scattered(taken.sample.direction).value * taken.sample.radiance * weight);
  if (!vertex.scattering || !vertex.scattering->next) return;
  const auto& [sample, next] = *vertex.scattering;
  CHECK(next->throughput == throughput * sample.value * (std::fabs(sample.wi.z) / sample.pdf));
  CHECK((next->kind == ScatterKind::transmission) == (sample.wi.z < 0));
  if (vertex.roulette) CHECK(vertex.roulette->throughput == next->throughput / vertex.roulette->probability);
}

/// Checks that paths that are watched have the bits of waves, and that what is written of them adds up.
void check_logs(const Scene& scene, const PathOptions& options, std::uint32_t count) {
  const auto accelerator = build_accelerator(Backend::bvh, scene.geometry);
  const PathReference reference(scene, options);
  const PathIntegrator waves(scene, options);
  Tracer wave(*accelerator, false);
  for (const CameraSample& sample : samples_of(scene, count)) {
    PathLog log;
    Tracer watched(*accelerator, false);
    watched.watch(log);
    const Rgb radiance = reference.radiance(sample.ray, SamplerKind::sobol, sample.key, watched);
    CHECK(radiance == waves.radiance(sample.ray, SamplerKind::sobol, sample.key, wave));
    CHECK(log.sum() == radiance);
    const std::vector<PathVertex>& vertices = log.vertices();
    REQUIRE(!vertices.empty());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      check_vertex(vertices[i], options.direct);
      if (i + 1 == vertices.size()) break;
      const auto& [scattered, next] = *vertices[i].scattering;
      CHECK(vertices[i + 1].arrival.throughput ==
            (vertices[i].roulette ? vertices[i].roulette->throughput : next->throughput));
      CHECK(vertices[i + 1].arrival.ray.direction == next->direction);
    }
    CHECK((log.end() == PathEnd::left) == vertices.back().arrival.hit.is_miss());
    if (log.end() == PathEnd::depth && !options.limits.are_any())
      CHECK(int(vertices.size()) == options.depth_limit() + 1);
  }
}

/// Samples of a few pixels, some of them in one order and some in another.
}  // namespace

TEST_CASE("waves of paths have the bits and the rays of paths one after the other") {
  const Scene everything = scene_of_everything();
  const Scene models = scene_of_every_model();
  const Scene room = small_room(), skies = scene_under_skies();
  const Scene textures = textured(scene_of_every_model(), TextureFilter::stochastic),
              many = scene_of_many_lights(),
              lamps = textured(scene_of_everything(), TextureFilter::trilinear), maps = mapped(textures),
              interiors = scene_of_interiors(), closed = scene_without_passages();
  const Scene media = scene_in_media(), bodies = scene_with_bodies(),
              textured_bodies = textured(scene_with_bodies(), TextureFilter::trilinear);
  const Scene instances = instanced(everything), textured_instances = instanced(textures);
  const Scene* const scenes[] = {&instances,      &textured_instances,
                                 &everything,     &models,
                                 &room,           &skies,
                                 &textures,       &lamps,
                                 &many,           &maps,
                                 &interiors,      &closed,
                                 &media,          &bodies,
                                 &textured_bodies};
  for (std::size_t i = 0; i < std::size(cases); ++i)
    for (std::size_t j = 0; j < std::size(scenes); ++j) {
      // A whole wave, and a part of the next.
      std::uint32_t count = cases[i].samples_per_light > 100 ? 8 : 640;
      if (scenes[j] == &textured_instances || scenes[j] == &maps) count = std::min(count, 500u);
      // Who draws the numbers does not depend on who uses them: by turns, but for the usual options.
      for (int k = 0; k < 2; ++k)
        if (i == 0 || (i + j) % 2 == std::size_t(k)) check_bits(*scenes[j], cases[i], count, samplers[k]);
    }
}

TEST_CASE("waves have the bits of paths that choose from many lights by power, and from lights without any") {
  const Scene lit = scene_of_many_lights();
  Scene dark = small_room();
  for (int i = 0; i < 9; ++i) add_light(dark, PointLight{{0.1f * float(i), 0.5f, 0}, {0, 0, 0}, {}});
  // Where media scatter, too, a tree chooses.
  Scene foggy = lit;
  foggy.materials.push_back({.name = "fog", .model = Interface{}});
  foggy.materials.back().interior = {.scattering = {0.9f, 0.6f, 0.3f}};
  for (const SamplerKind kind : samplers) {
    check_bits(foggy, {}, 500, kind);
    check_bits(lit, {.many_lights = ManyLights::power}, 500, kind);
    check_bits(dark, {}, 200, kind);
  }
}

TEST_CASE("waves have the bits of paths at a sphere lamp that reflects, outside and inside") {
  const Vec3 center{0.3f, -0.2f, 0.1f};
  for (const Vec3& eye : {Vec3{0, 0.2f, 3}, Vec3{0.4f, -0.1f, 0.1f}}) {
    Scene scene = scene_of(inward_box(4), {0.8f, 0.7f, 0.6f}, eye, center);
    add_lamp(scene, SphereSet{"ball", {{center, 0.5f}}}, {3, 2, 1}, EmissionSide::front);
    scene.materials.back().model = Lambert{{0.5f, 0.5f, 0.5f}};
    for (const SamplerKind kind : samplers) check_bits(scene, {}, 500, kind);
  }
}

TEST_CASE("what is written of a path adds up to the bits of its sample, as waves make it") {
  const Scene everything = scene_of_everything(), models = scene_of_every_model(),
              many = scene_of_many_lights();
  const Scene textures = textured(scene_of_every_model(), TextureFilter::stochastic), room = small_room(),
              skies = scene_under_skies();
  for (const PathOptions& options : cases) {
    if (options.samples_per_light > 100) continue;
    for (const Scene* scene : {&everything, &models, &many, &textures, &room, &skies})
      check_logs(*scene, options, 60);
  }
}

TEST_CASE("a wave of one path records its rays in the order of a path alone") {
  for (const Scene& scene : {scene_of_every_model(), scene_in_media(), scene_with_bodies()}) {
    const auto accelerator = build_accelerator(Backend::bvh, scene.geometry);
    for (const PathOptions& options : cases) {
      if (options.samples_per_light > 100) continue;
      const PathReference reference(scene, options);
      const PathIntegrator waves(scene, options);
      for (const CameraSample& sample : samples_of(scene, 40)) {
        std::vector<RecordedRay> expected, found;
        Tracer alone(*accelerator, false, &expected), wave(*accelerator, false, &found);
        CHECK(waves.radiance(sample.ray, SamplerKind::sobol, sample.key, wave) ==
              reference.radiance(sample.ray, SamplerKind::sobol, sample.key, alone));
        REQUIRE(found.size() == expected.size());
        for (std::size_t i = 0; i < found.size(); ++i) {
          CHECK(found[i].ray.origin == expected[i].ray.origin);
          CHECK(found[i].ray.direction == expected[i].ray.direction);
          CHECK(found[i].ray.t_max == expected[i].ray.t_max);
          CHECK(found[i].kind == expected[i].kind);
          CHECK(found[i].vertex == expected[i].vertex);
        }
      }
    }
  }
}

}  // namespace twinray::test
