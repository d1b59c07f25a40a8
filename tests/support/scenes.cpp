// SPDX-License-Identifier: Apache-2.0
#include "tests/support/scenes.h"

#include <cmath>
#include <map>
#include <utility>

namespace twinray::test {
namespace {

std::uint32_t add_shape(Scene& scene, Shape shape, const Material& material, std::uint32_t light) {
  std::vector<Shape> shapes = scene.geometry->shapes();
  shapes.push_back(std::move(shape));
  scene.geometry = std::make_shared<const Geometry>(std::move(shapes));
  scene.materials.push_back(material);
  scene.bindings.push_back({std::uint32_t(scene.materials.size() - 1), light});
  return std::uint32_t(scene.bindings.size() - 1);
}

Mesh quad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  Mesh mesh;
  mesh.positions = {a, b, c, d};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

std::uint32_t midpoint(Mesh& mesh, std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>& known,
                       std::uint32_t a, std::uint32_t b) {
  const auto key = std::minmax(a, b);
  const auto found = known.find(key);
  if (found != known.end()) return found->second;
  mesh.positions.push_back(normalize(mesh.positions[a] + mesh.positions[b]));
  return known[key] = std::uint32_t(mesh.positions.size() - 1);
}

void subdivide(Mesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> known;
  std::vector<Triangle> finer;
  for (const auto& [a, b, c] : std::vector<Triangle>(mesh.triangles)) {
    const std::uint32_t ab = midpoint(mesh, known, a, b);
    const std::uint32_t bc = midpoint(mesh, known, b, c);
    const std::uint32_t ca = midpoint(mesh, known, c, a);
    for (const Triangle& t : {Triangle{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}})
      finer.push_back(t);
  }
  mesh.triangles = std::move(finer);
}

}  // namespace

Mesh inward_box(float half) {
  Mesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.positions.push_back({i & 1 ? half : -half, i & 2 ? half : -half, i & 4 ? half : -half});
  mesh.triangles = {{0, 1, 3}, {0, 3, 2}, {4, 6, 7}, {4, 7, 5}, {0, 4, 5}, {0, 5, 1},
                    {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 5, 7}, {1, 7, 3}};
  return mesh;
}

Mesh floor_square(float half, float y) {
  return quad({-half, y, half}, {half, y, half}, {half, y, -half}, {-half, y, -half});
}

Mesh icosphere(int subdivisions) {
  const float g = 1.618034f;
  Mesh mesh;
  for (const Vec3& p : {Vec3{-1, g, 0},
                        {1, g, 0},
                        {-1, -g, 0},
                        {1, -g, 0},
                        {0, -1, g},
                        {0, 1, g},
                        {0, -1, -g},
                        {0, 1, -g},
                        {g, 0, -1},
                        {g, 0, 1},
                        {-g, 0, -1},
                        {-g, 0, 1}})
    mesh.positions.push_back(normalize(p));
  mesh.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (int i = 0; i < subdivisions; ++i) subdivide(mesh);
  return mesh;
}

EnvironmentLight constant_sky(const Rgb& radiance) {
  Image map(1, 1);
  map.pixels[0] = radiance;
  return {std::make_shared<const Image>(std::move(map))};
}

Scene ball_under_sky(const SurfaceModel& model, const Rgb& radiance) {
  Scene scene = scene_of({}, {}, {0, 0, 3}, {0, 0, 0});
  scene.geometry = std::make_shared<const Geometry>(std::vector<Shape>{SphereSet{"ball", {{{0, 0, 0}, 1}}}});
  scene.materials = {{"ball", model}};
  scene.camera.tan_half_width = scene.camera.tan_half_height = 0.1f;
  add_light(scene, constant_sky(radiance));
  return scene;
}

Camera camera_at(const Vec3& eye, const Vec3& target) {
  Camera camera;
  camera.position = eye;
  camera.forward = normalize(target - eye);
  const Vec3 up = std::fabs(camera.forward.y) > 0.99f ? Vec3{0, 0, 1} : Vec3{0, 1, 0};
  camera.right = normalize(cross(camera.forward, up));
  camera.up = cross(camera.right, camera.forward);
  camera.tan_half_width = camera.tan_half_height = 0.36397f;
  return camera;
}

Scene scene_of(Mesh mesh, const Rgb& reflectance, const Vec3& eye, const Vec3& target) {
  Scene scene;
  add_shape(scene, std::move(mesh), {"surface", Lambert{reflectance}}, no_light);
  scene.camera = camera_at(eye, target);
  return scene;
}

std::uint32_t add_lamp(Scene& scene, Shape shape, const Rgb& radiance, EmissionSide side) {
  const bool is_mesh = std::holds_alternative<Mesh>(shape);
  const std::uint32_t index =
      add_shape(scene, std::move(shape), {"lamp", Lambert{{0, 0, 0}}}, std::uint32_t(scene.lights.size()));
  if (is_mesh)
    scene.lights.push_back({"lamp", MeshLight{index, radiance, side}});
  else
    scene.lights.push_back({"lamp", SphereLight{index, radiance}});
  return index;
}

void add_light(Scene& scene, LightSource source) { scene.lights.push_back({"light", std::move(source)}); }

Scene emissive_enclosure(float emitted, float reflectance) {
  const Rgb grey{reflectance, reflectance, reflectance};
  Scene scene = scene_of(inward_box(1), grey, {0.2f, 0.1f, 0.3f}, {-0.5f, -0.4f, -1});
  scene.bindings[0].light = 0;
  scene.lights.push_back({"walls", MeshLight{0, {emitted, emitted, emitted}, EmissionSide::both}});
  return scene;
}

Scene small_room(float scale) {
  Scene scene =
      scene_of(inward_box(scale), {0.7f, 0.6f, 0.5f}, Vec3{0, 0, 0.95f} * scale, Vec3{0, -0.2f, -1} * scale);
  Mesh blob = icosphere(2);
  for (Vec3& p : blob.positions) p = (p * 0.35f + Vec3{-0.4f, -0.6f, -0.3f}) * scale;
  add_shape(scene, std::move(blob), {"blob", Lambert{{0.2f, 0.5f, 0.8f}}}, no_light);
  add_shape(scene, SphereSet{"ball", {{Vec3{0.45f, -0.7f, 0} * scale, 0.3f * scale}}},
            {"ball", Lambert{{0.8f, 0.3f, 0.2f}}}, no_light);
  Mesh lamp = floor_square(0.3f, -0.98f);  // turned over: the front faces down, just under the ceiling
  for (Vec3& p : lamp.positions) p = Vec3{p.x, -p.y, -p.z} * scale;
  add_lamp(scene, std::move(lamp), {8, 7, 6}, EmissionSide::front);
  return scene;
}

}  // namespace twinray::test
