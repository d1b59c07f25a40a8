// SPDX-License-Identifier: Apache-2.0
// Waves of paths against the path tracer that traces one after the other: every bit, every ray.
#include <algorithm>
#include <cmath>
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
#include "tests/support/random.h"
#include "tests/support/scenes.h"
#include "tests/support/shapes.h"

namespace twinray::test {
namespace {

/// A picture of random colours, some of them black.
std::shared_ptr<const Image> random_picture(int width, int height) {
  auto map = std::make_shared<Image>(width, height);
  Random random(5);
  for (Rgb& pixel : map->pixels) pixel = {random.below(3) == 0 ? 0 : random.unit(), random.unit(), 0.25f};
  return map;
}

std::shared_ptr<const Image> random_sky() { return random_picture(8, 4); }
std::shared_ptr<const Image> random_square() { return random_picture(5, 5); }

/// Corner normals that contradict the geometry here and there.
void add_normals(Mesh& mesh) {
  Random random(11);
  for (const Triangle& triangle : mesh.triangles) {
    const auto first = std::uint32_t(mesh.normals.size());
    for (int corner = 0; corner < 3; ++corner) mesh.normals.push_back(normalize(random.in_ball()));
    mesh.normal_indices.push_back({first, first + 1, first + 2});
    static_cast<void>(triangle);
  }
}

/// A lamp of triangles of very different areas, the last of them without any.
Mesh lamp_of(int triangles) {
  Mesh mesh{.name = "lamp"};
  float size = 0.001f;
  for (int i = 0; i < triangles; ++i, size *= 5)
    add_triangle(mesh, {size, 1.3f, size}, {2 * size, 1.4f, size}, {size, 1.5f, -size});
  mesh.triangles.back()[2] = mesh.triangles.back()[1];
  return mesh;
}

/// Random triangles of each of the models.
void add_models(Scene& scene, const std::vector<SurfaceModel>& models) {
  std::vector<Shape> shapes = scene.geometry->shapes();
  for (const SurfaceModel& model : models) {
    scene.bindings.push_back({std::uint32_t(scene.materials.size())});
    scene.materials.push_back({"", model});
    shapes.push_back(soup(12, 0.7f, scene.materials.size()));
  }
  scene.geometry = std::make_shared<const Geometry>(std::move(shapes));
}

/// Every light that rays find by leaving the scene.
void add_distant_lights(Scene& scene) {
  add_light(scene, AmbientLight{{0, 1, 0}, {0.1f, 0.2f, 0.1f}});
  add_light(scene, EnvironmentLight{random_sky()});
  EnvironmentLight square{random_square(), MapLayout::equal_area};
  square.rotation = Transform::rotation({1, 2, 3}, 40);
  square.scale = {0.5f, 0.25f, 1};
  add_light(scene, std::move(square));
  add_light(scene, SunLight{normalize({-1, -2, 1}), {0.5f, 0.3f, 0.2f}, 5});
}

/// Random triangles, some of them mirrors, with nothing but skies around.
Scene scene_under_skies() {
  Scene scene = scene_of(soup(40, 0.7f, 3), {0.8f, 0.7f, 0.6f}, {0, 0.3f, 1.6f}, {0, 0, 0});
  add_models(scene, {Conductor{}});
  add_distant_lights(scene);
  return scene;
}

/// Random triangles of which many lie close to an edge of another, spheres, and a light of every kind.
Scene scene_of_everything() {
  Mesh mesh = soup(60, 0.7f, 3);
  add_normals(mesh);
  Scene scene = scene_of(std::move(mesh), {0.8f, 0.7f, 0}, {0, 0.3f, 1.6f}, {0, 0, 0});
  add_lamp(scene, floor_square(0.5f, 1.2f), {3, 2, 1}, EmissionSide::both);
  add_lamp(scene, floor_square(0.25f, -0.9f), {1, 2, 3}, EmissionSide::front);
  add_lamp(scene, lamp_of(4), {1, 1, 2}, EmissionSide::both);
  add_lamp(scene, lamp_of(5), {2, 1, 1}, EmissionSide::both);
  Mesh bulb = icosphere(1);
  for (Vec3& p : bulb.positions) p = p * 0.15f + Vec3{-0.6f, 0.4f, 0.5f};
  add_lamp(scene, std::move(bulb), {3, 2, 3}, EmissionSide::front);
  add_lamp(scene, inward_box(1.7f), {0.1f, 0.1f, 0.2f}, EmissionSide::back);
  add_lamp(scene, SphereSet{"ball", {{{0.3f, 0.8f, 0.4f}, 0.2f}}}, {2, 2, 2}, EmissionSide::front);
  add_light(scene, PointLight{{0.3f, 0.2f, 0.1f}, {1, 2, 3}, {}});
  add_light(scene, SpotLight{{0, 1, 0}, {0, -1, 0}, {4, 4, 4}, {}, 70, 2});
  add_light(scene, DirectionalLight{normalize({1, -2, -1}), {0.5f, 0.5f, 0.4f}});
  add_distant_lights(scene);
  add_light(scene, GoniometricLight{{-0.4f, 0.5f, 0.6f}, {1, 2, 1}, random_square()});
  ProjectionLight slide{.position = {0.5f, 0.5f, 1.2f}, .intensity = {3, 2, 1}, .picture = random_sky()};
  add_light(scene, std::move(slide));
  return scene;
}

/// The same lights upon surfaces of every model, balls among them.
Scene scene_of_every_model() {
  Scene scene = scene_of_everything();
  const SurfaceModel models[] = {Mirror{{0.9f, 0.8f, 0.7f}},
                                 Refraction{.ior = 1.3f},
                                 Glass{{0.9f, 1, 0.8f}, {1, 0.5f, 1}, 0, 1.5f},
                                 Microfacet{.alpha = 0.4f},
                                 Dielectric{.ior = 1.4f},
                                 Dielectric{.ior = 1.5f, .roughness = {0.3f, 0.2f}},
                                 Dielectric{.is_thin = true},
                                 Conductor{},
                                 Conductor{.roughness = {0.1f, 0.4f}},
                                 DiffuseTransmission{},
                                 RoughDiffuse{},
                                 CoatedDiffuse{},
                                 CoatedDiffuse{.roughness = {0.2f, 0.2f}},
                                 CoatedConductor{},
                                 CoatedConductor{.roughness = {0.3f, 0.3f}, .coat_roughness = {0.2f, 0.2f}},
                                 Mix{0, 4, 0.3f}};
  std::vector<Shape> shapes = scene.geometry->shapes();
  std::uint64_t seed = 20;
  for (const SurfaceModel& model : models) {
    scene.materials.push_back({"", model});
    const auto material = std::uint32_t(scene.materials.size() - 1);
    Mesh mesh = soup(12, 0.7f, seed++);
    if (seed % 2 == 0) add_normals(mesh);
    shapes.push_back(std::move(mesh));
    shapes.push_back(SphereSet{"", {{Random(seed).in_ball(), 0.2f}}});
    scene.bindings.push_back({material});
    scene.bindings.push_back({material});
  }
  scene.geometry = std::make_shared<const Geometry>(std::move(shapes));
  return scene;
}

/// The same in fog, with overlapping bodies that absorb or hide each other.
Scene scene_of_interiors() {
  Scene scene = scene_of_every_model();
  std::vector<Shape> shapes = scene.geometry->shapes();
  Random random(30);
  for (int i = 0; i < 12; ++i) {
    const float ior = 1.1f + 0.1f * float(i % 5);
    Material material{"", i % 3 == 0 ? SurfaceModel(Interface{}) : Dielectric{ior}};
    if (i % 4 == 1) material.model = Dielectric{ior, {0.3f, 0.3f}};
    material.interior = {{random.unit(), i % 2 == 0 ? 0 : random.unit(), 0.5f}, i % 4};
    scene.materials.push_back(material);
    scene.bindings.push_back({std::uint32_t(scene.materials.size() - 1)});
    shapes.push_back(SphereSet{"", {{random.in_ball() * 0.3f, i == 0 ? 1.3f : 0.5f}}});
  }
  scene.geometry = std::make_shared<const Geometry>(std::move(shapes));
  check_scene(scene);
  return scene;
}

/// The same without surfaces that are not there.
Scene scene_without_passages() {
  Scene scene = scene_of_interiors();
  for (Material& material : scene.materials)
    if (std::holds_alternative<Interface>(material.model)) material.model = Dielectric{1.2f};
  return scene;
}

/// Lamps, balls and points of light, more of each than are sampled alone, some of them behind surfaces that
/// let light through.
Scene scene_of_many_lights() {
  Scene scene = scene_of(soup(60, 0.7f, 3), {0.8f, 0.7f, 0.6f}, {0, 0.3f, 1.6f}, {0, 0, 0});
  add_models(scene, {DiffuseTransmission{}, Dielectric{.ior = 1.5f, .roughness = {0.3f, 0.2f}}});
  Random random(8);
  for (int i = 0; i < 7; ++i) {
    const Vec3 place = random.in_ball() * 1.4f;
    Mesh lamp = floor_square(0.1f, 0);
    for (Vec3& p : lamp.positions) p = p + place;
    add_lamp(scene, std::move(lamp), {3, 2, float(i)}, i % 2 ? EmissionSide::back : EmissionSide::both);
    const Vec3 center = random.in_ball() * 1.3f;
    add_lamp(scene, SphereSet{"ball", {{center, 0.1f}}}, {2, 2, 2}, EmissionSide::front);
    add_light(scene, PointLight{random.in_ball(), {0.1f, 0.2f, 0.3f}, {}});
    add_light(scene, SpotLight{random.in_ball(), {0, -1, 0}, {1, 1, 1}, {}, 70, 2});
  }
  add_light(scene, EnvironmentLight{random_sky()});
  return scene;
}

/// Texture coordinates for every other mesh; the others have the weights of their hits.
void add_uvs(Scene& scene) {
  std::vector<Shape> shapes = scene.geometry->shapes();
  Random random(50);
  for (std::size_t i = 0; i < shapes.size(); i += 2)
    if (auto* const mesh = std::get_if<Mesh>(&shapes[i])) {
      mesh->uv_indices = mesh->triangles;
      mesh->uvs.resize(mesh->positions.size());
      for (Vec2& uv : mesh->uvs) uv = {random.unit(), random.unit()};
      if (i % 8 == 0) continue;
      mesh->second_uv_indices = mesh->triangles;
      mesh->second_uvs.resize(mesh->positions.size());
      for (Vec2& uv : mesh->second_uvs) uv = {random.unit(), 3 * random.unit()};
    }
  scene.geometry = std::make_shared<const Geometry>(std::move(shapes));
}

/// The same, every input of every material by a texture, and meshes that emit by a picture.
Scene textured(Scene scene, TextureFilter filter) {
  add_uvs(scene);
  const ImageTexture image{
      std::make_shared<const MipMap>(*random_square()), WrapMode::repeat, filter, {{{7, 1, 0}, {0, 5, 0}}}};
  ImageTexture second = image;
  second.coordinates = CoordinateSet::second;
  scene.textures = {{"", ConstantTexture{{0.2f, 0.6f, 0.9f}}},
                    {"", image},
                    {"", CheckerboardTexture{0, 1, {{{4, 0, 0}, {0, 4, 0}}}}},
                    {"", second}};
  for (Material& material : scene.materials)
    for (int i = 0; i < material_inputs; ++i)
      if (const auto input = MaterialInput(i); has_input(material.model, input))
        material.textures.push_back({input, (std::uint32_t(i) + 2) % 3 + 1});
  for (Light& light : scene.lights)
    if (auto* const mesh = std::get_if<MeshLight>(&light.source)) mesh->picture = random_square();
  check_scene(scene);
  return scene;
}

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
  for (std::size_t i = 0; i < scene.lights.size(); ++i) scene.lights[i].group = i % 2;
  return scene;
}

bool same_bits(std::span<const Rgb> a, std::span<const Rgb> b) {
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
      for (std::size_t i = 0; i < count; ++i)
        REQUIRE(same_bits(found.spans(count)[division][i], expected.spans(count)[division][i]));
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
              lamps = textured(scene_of_everything(), TextureFilter::trilinear),
              interiors = scene_of_interiors(), bodies = scene_without_passages();
  const Scene instances = instanced(everything), textured_instances = instanced(textures);
  const Scene* const scenes[] = {&instances, &textured_instances, &everything, &models, &room,
                                 &skies,     &textures,           &lamps,      &many,   &interiors,
                                 &bodies};
  for (std::size_t i = 0; i < std::size(cases); ++i)
    for (std::size_t j = 0; j < std::size(scenes); ++j) {
      // Waves, whole ones and a part of one.
      std::uint32_t count = cases[i].samples_per_light > 100 ? 8 : 1100;
      if (scenes[j] == &textured_instances) count = std::min(count, 500u);
      // Who draws the numbers does not depend on who uses them: by turns, but for the usual options.
      for (int k = 0; k < 2; ++k)
        if (i == 0 || (i + j) % 2 == std::size_t(k)) check_bits(*scenes[j], cases[i], count, samplers[k]);
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
  const Scene scene = scene_of_every_model();
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

}  // namespace twinray::test
