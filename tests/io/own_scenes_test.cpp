// SPDX-License-Identifier: Apache-2.0
// The scenes of this project: each loads without a word, and is what its comment says.
#include <map>
#include <set>
#include <utility>

#include "io/scene_file.h"
#include "tests/support/catch.h"

namespace twinray {
namespace {

LoadedScene load(const std::string& name) {
  return load_scene(TWINRAY_SOURCE_DIR "/scenes/" + name, {.strict = true});
}

const Mesh& mesh_named(const Scene& scene, const std::string& name) {
  for (const Shape& shape : scene.geometry->shapes())
    if (const auto* mesh = std::get_if<Mesh>(&shape); mesh && mesh->name == name) return *mesh;
  throw Error("no mesh of this name");
}

/// Each edge is used once in each direction.
bool is_closed(const Mesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& [a, b, c] : mesh.triangles) ++edges[{a, b}], ++edges[{b, c}], ++edges[{c, a}];
  for (const auto& [edge, count] : edges)
    if (const auto back = edges.find({edge.second, edge.first}); count != 1 || back == edges.end())
      return false;
  return true;
}

/// Positive where the triangles' fronts are outside.
double volume(const Mesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    sum += dot(mesh.positions[a], cross(mesh.positions[b], mesh.positions[c])) / 6;
  return sum;
}

}  // namespace

TEST_CASE("the scenes of this project load in strict mode, with nothing dropped") {
  const std::map<std::string, std::pair<std::size_t, std::size_t>> triangles_and_spheres{
      {"box.dae", {12, 0}},
      {"spheres.dae", {12, 2}},
      {"furnace.dae", {24, 1}},
      {"lights.dae", {6, 5}},
      {"cornell-bunny.dae", {10060, 0}}};
  for (const auto& [name, counts] : triangles_and_spheres) {
    INFO(name);
    const LoadedScene loaded = load(name);
    CHECK(loaded.scene.geometry->triangle_count() == counts.first);
    CHECK(loaded.scene.geometry->sphere_count() == counts.second);
    CHECK(loaded.summary.dropped_triangles == 0);
    CHECK(loaded.summary.camera == "camera");
  }
}

TEST_CASE("the lamp of the box shines down") {
  const LoadedScene loaded = load("box.dae");
  const Mesh& lamp = mesh_named(loaded.scene, "lamp");
  const auto [a, b, c] = lamp.triangles[0];
  CHECK(cross(lamp.positions[b] - lamp.positions[a], lamp.positions[c] - lamp.positions[a]).y < 0);
}

TEST_CASE("the shapes of a COLLADA node belong to the outermost node, and lamps to themselves") {
  const Scene scene = load("box.dae").scene;
  const auto asset_named = [&](const std::string& shape) -> std::string {
    for (std::uint32_t i = 0; i < scene.bindings.size(); ++i)
      if (scene.geometry->mesh(i)->name == shape)
        return scene.bindings[i].asset == no_asset ? "itself" : scene.assets[scene.bindings[i].asset];
    return "no such shape";
  };
  for (const char* const shape : {"box/red", "box/blue", "box/white"}) CHECK(asset_named(shape) == "box");
  CHECK(asset_named("lamp") == "itself");
}

TEST_CASE("the creature is a closed mesh with unit normals on its outside") {
  const LoadedScene loaded = load("cornell-bunny.dae");
  const Mesh& mesh = mesh_named(loaded.scene, "creature");
  CHECK(is_closed(mesh));
  CHECK(volume(mesh) > 0.05);
  REQUIRE(mesh.normals.size() == mesh.positions.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto [a, b, c] = mesh.triangles[i];
    const Vec3 n = cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
    if (dot(n, mesh.normals[mesh.normal_indices[i][0]]) <= 0) FAIL("triangle " << i);
  }
}

TEST_CASE("the furnace is closed, and its equation has the radiance 1") {
  const LoadedScene loaded = load("furnace.dae");
  const Mesh& enclosure = mesh_named(loaded.scene, "enclosure");
  CHECK(is_closed(enclosure));
  CHECK(volume(enclosure) == Approx(-64));
  CHECK(is_closed(mesh_named(loaded.scene, "block")));
  const auto& light = std::get<MeshLight>(loaded.scene.lights.at(0).source);
  const auto& binding = loaded.scene.bindings[light.shape];
  const Rgb albedo = std::get<Lambert>(loaded.scene.materials[binding.material].model).reflectance;
  CHECK(light.radiance.r / (1 - albedo.r) == 1);
}

TEST_CASE("the scene of lights has one of each kind") {
  const LoadedScene loaded = load("lights.dae");
  std::vector<std::string> lines = summary_lines(loaded.summary);
  CHECK(lines == std::vector<std::string>{
                     "unit: meter (1 m), kept as it is; up axis: Y", "camera: \"camera\"",
                     "shapes: 3 meshes, 6 triangles, 5 spheres; 4 materials",
                     "light \"sign\": mesh, both sides, radiance 2 0.5 2, power 2.513 0.6283 2.513",
                     "light \"ember\": sphere, radiance 6 3 1, power 5.33 2.665 0.8883",
                     "light \"panel\": mesh, one side, radiance 3 3 3, power 4.524 4.524 4.524",
                     "light \"point\": point, intensity 0.6 0.2 0.1, power 7.54 2.513 1.257",
                     "light \"faded\": point, intensity 0.1 0.2 0.6",
                     "light \"spot\": spot, intensity 4 4 3, power 2.141 2.141 1.606",
                     "light \"sun\": directional, irradiance 0.4 0.4 0.35",
                     "light \"sky\": ambient, the hemisphere around up, radiance 0.08 0.1 0.14",
                     "note: the file says nothing of how light falls off with the distance d for \"point\", "
                     "\"spot\": it falls off as 1/d^2, with d in the file's unit; --attenuation=file gives "
                     "COLLADA's default, no fall-off"});
}

TEST_CASE("table.gltf has a lamp, a spot, a panel of many colors and balls of four materials") {
  const LoadedScene loaded = load("table.gltf");
  const Scene& scene = loaded.scene;
  CHECK(loaded.summary.camera == "front");
  CHECK(loaded.summary.dropped_triangles == 0);
  REQUIRE(scene.lights.size() == 2);
  CHECK(scene.lights[0].name == "lamp");
  CHECK(std::get<SpotLight>(scene.lights[1].source).intensity == Rgb{13.5f, 15.3f, 18});
  for (const char* ball : {"brass ball", "lacquered ball", "glass ball", "velvet ball"}) {
    INFO(ball);
    const Mesh& mesh = mesh_named(scene, ball);
    CHECK(mesh.triangles.size() == 528);
    CHECK(volume(mesh) > 0);
  }
  CHECK_FALSE(mesh_named(scene, "panel").uvs.empty());
}

TEST_CASE("still-life.pbrt shows a gold, a glass and a varnished ball under two lamps") {
  const LoadedScene loaded = load("still-life.pbrt");
  CHECK(loaded.scene.geometry->sphere_count() == 3);
  REQUIRE(loaded.scene.lights.size() == 2);
  for (const Light& light : loaded.scene.lights) {  // They look down.
    const auto& lamp = std::get<MeshLight>(light.source);
    CHECK(lamp.side == EmissionSide::front);
    CHECK(loaded.scene.geometry->facet(lamp.shape, 0).normal.z < -0.999f);
  }
  CHECK(*loaded.defaults.max_depth == 8);
}

TEST_CASE("materials.pbrt shows ten balls of ten models before a texture, under a lamp and a sky") {
  const LoadedScene loaded = load("materials.pbrt");
  CHECK(loaded.scene.geometry->sphere_count() == 10);
  std::set<std::uint32_t> materials;
  for (std::uint32_t shape = 0; shape < loaded.scene.bindings.size(); ++shape)
    if (loaded.scene.geometry->sphere_set(shape)) materials.insert(loaded.scene.bindings[shape].material);
  CHECK(materials.size() == 10);
  CHECK_FALSE(loaded.scene.textures.empty());
  CHECK(loaded.scene.lights.size() == 2);
}

TEST_CASE("layers.pbrt shows seven surfaces of OpenPBR, and smoke, tea and amber that absorb light") {
  const LoadedScene loaded = load("layers.pbrt");
  CHECK(loaded.warnings.empty());
  int principled = 0, absorbing = 0, nested = 0;
  for (const ShapeBinding& binding : loaded.scene.bindings) {
    const Material& material = loaded.scene.materials[binding.material];
    principled += std::holds_alternative<Principled>(material.model);
    absorbing += !is_black(material.interior.absorption);
    nested += material.interior.priority > 0;
  }
  CHECK(principled == 7);
  CHECK(absorbing == 5);  // The green glass as well; tea has a surface of two shapes.
  CHECK(nested == 4);
}

TEST_CASE("haze.pbrt shows a cloud and jade, in a room of haze") {
  const LoadedScene loaded = load("haze.pbrt");
  CHECK(loaded.warnings.empty());
  int scattering = 0;
  for (const ShapeBinding& binding : loaded.scene.bindings)
    scattering += !is_black(loaded.scene.materials[binding.material].interior.scattering);
  CHECK(scattering == 3);
}

TEST_CASE("glow.pbrt shows a flame and two tubes, whose media emit light") {
  const LoadedScene loaded = load("glow.pbrt");
  CHECK(loaded.warnings.empty());
  std::set<float> colors;
  int hot = 0;
  for (const Material& material : loaded.scene.materials) {
    if (!material.interior.emits()) continue;
    colors.insert(material.interior.glow.radiance.b);
    hot += material.interior.glow.temperature != no_density;
  }
  CHECK(colors.size() == 3);
  CHECK(hot == 1);
}

TEST_CASE("lens.pbrt is seen through a lens of eleven surfaces, with lamps far behind") {
  const LoadedScene loaded = load("lens.pbrt");
  CHECK(loaded.warnings.empty());
  REQUIRE(loaded.scene.camera.lenses);
  CHECK(loaded.scene.camera.lenses->surfaces().size() == 11);
  CHECK(loaded.scene.lights.size() == 26);
}

TEST_CASE("hair.pbrt shows hair of three colours, in locks that are instances") {
  const LoadedScene loaded = load("hair.pbrt");
  CHECK(loaded.warnings.empty());
  std::set<float> colors;
  for (const Material& material : loaded.scene.materials)
    if (const auto* const hair = std::get_if<Hair>(&material.model)) colors.insert(hair->reflectance.g);
  CHECK(colors.size() == 3);
  CHECK(loaded.scene.geometry->instances().size() > 100);
}

TEST_CASE("subsurface.pbrt shows pawns below three of which light is scattered, and a matte one") {
  const LoadedScene loaded = load("subsurface.pbrt");
  CHECK(loaded.warnings.empty());
  std::set<float> radii;
  for (const ShapeBinding& binding : loaded.scene.bindings)
    radii.insert(loaded.scene.materials[binding.material].subsurface.radius.g);
  CHECK(radii == std::set<float>{0, 0.02f, 0.2f, 0.3f});
}

TEST_CASE("films.pbrt shows films of six thicknesses on steel, on enamel, and alone") {
  const LoadedScene loaded = load("films.pbrt");
  CHECK(loaded.warnings.empty());
  int metals = 0, glossy = 0, bubbles = 0;
  std::set<float> thicknesses;
  for (const ShapeBinding& binding : loaded.scene.bindings) {
    const auto* model = std::get_if<Principled>(&loaded.scene.materials[binding.material].model);
    if (!model) continue;
    CHECK(model->thin_film_weight == 1);
    thicknesses.insert(model->thin_film_thickness);
    ++(model->base_metalness == 1 ? metals : model->geometry_thin_walled ? bubbles : glossy);
  }
  CHECK(metals == 6);
  CHECK(glossy == 6);
  CHECK(bubbles == 6);
  CHECK(thicknesses.size() == 6);
}

TEST_CASE("patterns.pbrt shows every kind of texture that needs no picture, on ten balls and around them") {
  const LoadedScene loaded = load("patterns.pbrt");
  CHECK(loaded.warnings.empty());
  std::set<std::size_t> kinds;
  std::set<NoisePattern> patterns;
  std::set<TexturePlacement> placements;
  for (const Texture& texture : loaded.scene.textures) {
    kinds.insert(texture.model.index());
    if (const auto* noise = std::get_if<NoiseTexture>(&texture.model)) patterns.insert(noise->pattern);
    if (const auto* placed = std::get_if<PlacedTexture>(&texture.model)) placements.insert(placed->placement);
  }
  CHECK(kinds.size() == std::variant_size_v<TextureModel> - 1);
  CHECK(patterns.size() == 4);
  CHECK(placements.size() == 4);
  CHECK(loaded.scene.geometry->sphere_count() == 9);  // One within another; two with bumps are meshes.
}

}  // namespace twinray
