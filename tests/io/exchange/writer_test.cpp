// SPDX-License-Identifier: Apache-2.0
#include "io/exchange/writer.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <random>

#include "core/error.h"
#include "io/exchange/reader.h"
#include "io/picture/image_file.h"
#include "io/ply/ply.h"
#include "io/scene_writer.h"
#include "tests/support/catch.h"
#include "tests/support/json.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

Mesh triangle_mesh(const std::string& name) {
  return {.name = name, .positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .triangles = {{0, 1, 2}}};
}

/// Lines of the JSON file from the list of this name to its end.
std::string list_text(const Scene& scene, const std::string& name) {
  const std::string text = exchange_json(scene, "folder/a.json", {});
  const std::size_t begin = text.find("  \"" + name + "\": [");
  return text.substr(begin, text.find("\n  ]", begin) - begin);
}

/// Any finite float: all exponents, the smallest numbers and both zeros included.
float any_float(std::mt19937& random) {
  for (;;)
    if (const float x = std::bit_cast<float>(std::uint32_t(random())); std::isfinite(x)) return x;
}

/// What a reader of the PLY file finds.
struct ReadMesh {
  std::string header;
  std::vector<std::vector<float>> vertices;
  std::vector<Triangle> triangles;
};

template <typename T>
T take(const std::string& bytes, std::size_t& at) {
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  at += sizeof value;
  return value;
}

ReadMesh read_ply(const std::string& bytes, std::size_t vertices, std::size_t width, std::size_t triangles) {
  std::size_t at = bytes.find("end_header\n") + 11;
  ReadMesh mesh{bytes.substr(0, at), {}, {}};
  for (std::size_t i = 0; i < vertices; ++i)
    for (mesh.vertices.emplace_back(); mesh.vertices.back().size() < width;)
      mesh.vertices.back().push_back(take<float>(bytes, at));
  for (std::size_t i = 0; i < triangles; ++i) {
    REQUIRE(take<std::uint8_t>(bytes, at) == 3);
    Triangle& triangle = mesh.triangles.emplace_back();
    for (std::uint32_t& index : triangle) index = take<std::uint32_t>(bytes, at);
  }
  CHECK(at == bytes.size());
  return mesh;
}

bool same_bits(float a, float b) {
  return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

/// A mesh of any numbers, in which triangles share positions, normals and coordinates in other ways.
Mesh tangled_mesh(std::mt19937& random) {
  Mesh mesh;
  const auto any = [&] { return any_float(random); };
  for (int i = 0; i < 40; ++i) mesh.positions.push_back({any(), any(), any()});
  for (int i = 0; i < 7; ++i) mesh.normals.push_back({any(), any(), any()});
  for (int i = 0; i < 5; ++i) mesh.uvs.push_back({any(), any()});
  const auto corners = [&](std::size_t count) {
    const auto index = [&] { return std::uint32_t(random() % count); };
    return Triangle{index(), index(), index()};
  };
  for (int i = 0; i < 200; ++i) {
    mesh.triangles.push_back(corners(mesh.positions.size()));
    mesh.normal_indices.push_back(corners(mesh.normals.size()));
    mesh.uv_indices.push_back(corners(mesh.uvs.size()));
  }
  return mesh;
}

std::size_t different_corners(const Mesh& mesh) {
  std::vector<Triangle> corners;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      corners.push_back({mesh.triangles[i][k], mesh.normal_indices[i][k], mesh.uv_indices[i][k]});
  std::sort(corners.begin(), corners.end());
  return std::size_t(std::unique(corners.begin(), corners.end()) - corners.begin());
}

}  // namespace

TEST_CASE("a small scene in exchange form") {
  Scene scene;
  SphereSet spheres{"balls", {{{0.1f, -2, 3e-7f}, 0.5f}, {{0, 0, 0}, 1}}};
  scene.geometry = std::make_shared<const Geometry>(std::vector<Shape>{triangle_mesh("lamp \"A\""), spheres});
  scene.materials = {{"grey", Lambert{}}};
  scene.lights = {{"lamp", MeshLight{0, {10, 9.5f, 1}, EmissionSide::front}}};
  scene.bindings = {{0, 0}, {0, no_light}};
  CHECK(exchange_json(scene, "folder/a.json", {400, 300}) ==
        R"({
  "format": "twinray scene",
  "version": 1,
  "resolution": [400,300],
  "camera": {"type":"perspective","position":[0.0,0.0,0.0],"right":[1.0,0.0,0.0],"up":[0.0,1.0,0.0],)"
        R"("forward":[0.0,0.0,-1.0],"tan_half_width":0.5,"tan_half_height":0.375,"lens_radius":0.0,)"
        R"("focal_distance":1.0,"clip_near":0.0,"clip_along":"forward"},
  "materials": [
    {"name":"grey","type":"lambert","reflectance":[0.5,0.5,0.5]}
  ],
  "lights": [
    {"name":"lamp","type":"mesh","shape":0,"radiance":[10.0,9.5,1.0],"side":"front"}
  ],
  "shapes": [
    {"name":"lamp \"A\"","type":"mesh","file":"a-0.ply","material":0,"light":0},
    {"name":"balls","type":"spheres","spheres":[[0.1,-2.0,3e-07,0.5],[0.0,0.0,0.0,1.0]],"material":0}
  ]
}
)");
}

TEST_CASE("an empty scene has empty lists") {
  const auto json = nlohmann::json::parse(exchange_json({}, "a.json", {}));
  for (const char* list : {"materials", "lights", "shapes"}) CHECK(json[list] == nlohmann::json::array());
  CHECK(json["resolution"] == nlohmann::json({480, 360}));
}

TEST_CASE("each kind of material in exchange form") {
  Scene scene;
  scene.materials = {
      {"a", Lambert{{0.25f, 0.5f, 1}}},
      {"b", Mirror{{0.25f, 0.5f, 1}}},
      {"c", Refraction{{0.25f, 0.5f, 1}, 0.125f, 1.25f}},
      {"d", Glass{{0.25f, 0.5f, 1}, {1, 0.5f, 0.25f}, 0.125f, 1.25f}},
      {"e", Microfacet{0.75f, {1, 2, 3}, {4, 5, 6}}},
      {"f", Dielectric{1.25f, {0.25f, 0.5f}, {1, 0.5f, 0.25f}, {0.25f, 0.5f, 1}, false}},
      {"g", Dielectric{.is_thin = true}},
      {"h", Conductor{{1, 2, 3}, {4, 5, 6}, {0.25f, 0.5f}, {1, 0.5f, 0.25f}}},
      {"i", DiffuseTransmission{{1, 0.5f, 0.25f}, {0.25f, 0.5f, 1}}},
      {"j", RoughDiffuse{{1, 0.5f, 0.25f}, 0.75f}},
      {"k", CoatedDiffuse{{1, 0.5f, 0.25f}, {0.25f, 0.5f}, 1.25f}},
      {"l", CoatedConductor{{1, 2, 3}, {4, 5, 6}, {0.25f, 0.5f}, {1, 0.5f, 0.25f}, {0.5f, 0.75f}, 1.25f}},
      {"m", Mix{3, 4, 0.25f}}};
  CHECK(list_text(scene, "materials") ==
        R"(  "materials": [
    {"name":"a","type":"lambert","reflectance":[0.25,0.5,1.0]},
    {"name":"b","type":"mirror","reflectance":[0.25,0.5,1.0]},
    {"name":"c","type":"refraction","transmittance":[0.25,0.5,1.0],"roughness":0.125,"ior":1.25},
    {"name":"d","type":"glass","transmittance":[0.25,0.5,1.0],"reflectance":[1.0,0.5,0.25],)"
        R"("roughness":0.125,"ior":1.25},
    {"name":"e","type":"microfacet","distribution":"beckmann","alpha":0.75,"eta":[1.0,2.0,3.0],)"
        R"("k":[4.0,5.0,6.0]},
    {"name":"f","type":"dielectric","ior":1.25,"alpha":[0.25,0.5],"reflectance":[1.0,0.5,0.25],)"
        R"("transmittance":[0.25,0.5,1.0]},
    {"name":"g","type":"thin_dielectric","ior":1.5,"alpha":[0.0,0.0],"reflectance":[1.0,1.0,1.0],)"
        R"("transmittance":[1.0,1.0,1.0]},
    {"name":"h","type":"conductor","eta":[1.0,2.0,3.0],"k":[4.0,5.0,6.0],"alpha":[0.25,0.5],)"
        R"("reflectance":[1.0,0.5,0.25]},
    {"name":"i","type":"diffuse_transmission","reflectance":[1.0,0.5,0.25],"transmittance":[0.25,0.5,1.0]},
    {"name":"j","type":"rough_diffuse","reflectance":[1.0,0.5,0.25],"roughness":0.75},
    {"name":"k","type":"coated_diffuse","reflectance":[1.0,0.5,0.25],"alpha":[0.25,0.5],"ior":1.25},
    {"name":"l","type":"coated_conductor","eta":[1.0,2.0,3.0],"k":[4.0,5.0,6.0],"alpha":[0.25,0.5],)"
        R"("reflectance":[1.0,0.5,0.25],"coat_alpha":[0.5,0.75],"coat_ior":1.25},
    {"name":"m","type":"mix","first":3,"second":4,"amount":0.25})");
}

TEST_CASE("each kind of light in exchange form") {
  Scene scene;
  scene.lights = {{"a", MeshLight{3, {1, 2, 3}, EmissionSide::both}},
                  {"b", MeshLight{4, {1, 2, 3}, EmissionSide::back}},
                  {"c", SphereLight{5, {1, 2, 3}}},
                  {"d", PointLight{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}},
                  {"e", SpotLight{{1, 2, 3}, {0, 1, 0}, {4, 5, 6}, {}, 90, 2, 5}},
                  {"f", DirectionalLight{{0, 1, 0}, {4, 5, 6}}},
                  {"g", AmbientLight{{0, 0, 1}, {4, 5, 6}}},
                  {"h", EnvironmentLight{std::make_shared<const Image>(2, 2),
                                         MapLayout::equal_area,
                                         Transform{{{0, 0, 1, 0}, {0, 1, 0, 0}, {-1, 0, 0, 0}}},
                                         {3, 4, 5}}},
                  {"i", EnvironmentLight{std::make_shared<const Image>(2, 1)}},
                  {"j", GoniometricLight{{1, 2, 3}, {4, 5, 6}, std::make_shared<const Image>(2, 2)}},
                  {"k", ProjectionLight{{1, 2, 3},
                                        {1, 0, 0},
                                        {0, 1, 0},
                                        {0, 0, -1},
                                        2,
                                        0.5f,
                                        {4, 5, 6},
                                        std::make_shared<const Image>(2, 2)}},
                  {"l", SunLight{{0, -1, 0}, {4, 5, 6}, 0.5f}}};
  CHECK(list_text(scene, "lights") ==
        R"(  "lights": [
    {"name":"a","type":"mesh","shape":3,"radiance":[1.0,2.0,3.0],"side":"both"},
    {"name":"b","type":"mesh","shape":4,"radiance":[1.0,2.0,3.0],"side":"back"},
    {"name":"c","type":"sphere","shape":5,"radiance":[1.0,2.0,3.0]},
    {"name":"d","type":"point","position":[1.0,2.0,3.0],"intensity":[4.0,5.0,6.0],)"
        R"("attenuation":{"constant":7.0,"linear":8.0,"quadratic":9.0}},
    {"name":"e","type":"spot","position":[1.0,2.0,3.0],"direction":[0.0,1.0,0.0],)"
        R"("intensity":[4.0,5.0,6.0],)"
        R"("attenuation":{"constant":0.0,"linear":0.0,"quadratic":1.0},)"
        R"("falloff_angle_degrees":90.0,"falloff_exponent":2.0,"penumbra_degrees":5.0},
    {"name":"f","type":"directional","direction":[0.0,1.0,0.0],"irradiance":[4.0,5.0,6.0]},
    {"name":"g","type":"ambient","up":[0.0,0.0,1.0],"radiance":[4.0,5.0,6.0]},
    {"name":"h","type":"environment","layout":"equal-area",)"
        R"("rotation":{"x":[0.0,0.0,-1.0],"y":[0.0,1.0,0.0],"z":[1.0,0.0,0.0]},)"
        R"("scale":[3.0,4.0,5.0],"file":"a-light-7.exr"},
    {"name":"i","type":"environment","layout":"latitude-longitude",)"
        R"("rotation":{"x":[1.0,0.0,0.0],"y":[0.0,1.0,0.0],"z":[0.0,0.0,1.0]},)"
        R"("scale":[1.0,1.0,1.0],"file":"a-light-8.exr"},
    {"name":"j","type":"goniometric","position":[1.0,2.0,3.0],"intensity":[4.0,5.0,6.0],)"
        R"("layout":"equal-area",)"
        R"("rotation":{"x":[1.0,0.0,0.0],"y":[0.0,1.0,0.0],"z":[0.0,0.0,1.0]},)"
        R"("file":"a-light-9.exr"},
    {"name":"k","type":"projection","position":[1.0,2.0,3.0],"right":[1.0,0.0,0.0],"up":[0.0,1.0,0.0],)"
        R"("forward":[0.0,0.0,-1.0],"tan_half_width":2.0,"tan_half_height":0.5,)"
        R"("intensity":[4.0,5.0,6.0],"file":"a-light-10.exr"},
    {"name":"l","type":"sun","direction":[0.0,-1.0,0.0],"irradiance":[4.0,5.0,6.0],"diameter_degrees":0.5})");
}

TEST_CASE("each kind of camera in exchange form, its frame as wide as the picture") {
  Scene scene;
  scene.camera.clip_near = 0.125f;
  scene.camera.clip_far = 100;
  scene.camera.clips_by_distance = true;
  const auto wide = nlohmann::json::parse(exchange_json(scene, "a.json", {800, 300}))["camera"];
  CHECK(wide["tan_half_width"] == 1);
  CHECK(wide["tan_half_height"] == 0.375);
  CHECK(wide["clip_near"] == 0.125);
  CHECK(wide["clip_far"] == 100);
  CHECK(wide["clip_along"] == "ray");
  scene.camera.projection = Projection::orthographic;
  scene.camera.is_stretched = true;
  const auto flat = nlohmann::json::parse(exchange_json(scene, "a.json", {800, 300}))["camera"];
  CHECK(flat["type"] == "orthographic");
  CHECK(flat["half_width"] == 0.5);
  CHECK(flat["half_height"] == 0.375);
  CHECK_FALSE(flat.contains("tan_half_width"));
  CHECK_FALSE(flat.contains("frame_center"));
  CHECK_FALSE(flat.contains("aperture"));
  scene.camera.frame_center = {0.25f, -0.5f};
  scene.camera.aperture_blades = 5;
  scene.camera.aperture_turns = 0.125f;
  const auto shifted = nlohmann::json::parse(exchange_json(scene, "a.json", {800, 300}))["camera"];
  CHECK(shifted["frame_center"].dump() == "[0.25,-0.5]");
  CHECK(shifted["aperture"].dump() == "{\"blades\":5,\"turns\":0.125}");
  scene.camera = with_panorama({}, Projection::fisheye, 1.5f);
  const auto around = nlohmann::json::parse(exchange_json(scene, "a.json", {200, 100}))["camera"];
  CHECK(around["type"] == "fisheye");
  CHECK(around["half_width"] == 3);
  CHECK(around["half_height"] == 1.5);
  CHECK(around["clip_along"] == "ray");
}

TEST_CASE("every number of the JSON file is read back with all its bits") {
  std::mt19937 random(1);
  for (int i = 0; i < 20000; ++i) {
    Scene scene;
    const Vec3 written{any_float(random), any_float(random), any_float(random)};
    scene.camera.position = written;
    const auto read = nlohmann::json::parse(exchange_json(scene, "a.json", {}))["camera"]["position"];
    const bool is_same = same_bits(float(read[0].get<double>()), written.x) &&
                         same_bits(float(read[1].get<double>()), written.y) &&
                         same_bits(float(read[2].get<double>()), written.z);
    if (!is_same) FAIL(read.dump() << " in round " << i);
  }
}

TEST_CASE("a PLY file has each corner of each triangle with all bits, and no vertex twice") {
  std::mt19937 random(1);
  const Mesh mesh = tangled_mesh(random);
  const std::size_t count = different_corners(mesh);
  const ReadMesh read = read_ply(ply_bytes(mesh), count, 8, mesh.triangles.size());
  CHECK(read.header == "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(count) +
                           "\nproperty float x\nproperty float y\nproperty float z\n"
                           "property float nx\nproperty float ny\nproperty float nz\n"
                           "property float u\nproperty float v\nelement face 200\n"
                           "property list uchar uint vertex_indices\nend_header\n");
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 p = mesh.positions[mesh.triangles[i][k]], n = mesh.normals[mesh.normal_indices[i][k]];
      const Vec2 uv = mesh.uvs[mesh.uv_indices[i][k]];
      const std::vector<float> expected{p.x, p.y, p.z, n.x, n.y, n.z, uv.x, uv.y};
      const std::vector<float>& found = read.vertices[read.triangles[i][k]];
      if (!std::equal(found.begin(), found.end(), expected.begin(), same_bits))
        FAIL("corner " << k << " of triangle " << i);
    }
}

TEST_CASE("a PLY file of a mesh without normals and coordinates has positions alone") {
  Mesh mesh = triangle_mesh("a");
  mesh.triangles.push_back({2, 1, 0});
  const ReadMesh read = read_ply(ply_bytes(mesh), 3, 3, 2);
  CHECK(read.header.find("nx") == std::string::npos);
  CHECK(read.header.find("float u") == std::string::npos);
  CHECK(read.vertices[1] == std::vector<float>{1, 0, 0});
  CHECK(read.triangles[1] == Triangle{2, 1, 0});
}

TEST_CASE("the files of a scene, the JSON file last") {
  const TemporaryFolder folder;
  const std::string path = folder.file("room.json");
  Scene scene;
  SphereSet spheres{"balls", {{{0, 0, 0}, 1}}};
  scene.geometry =
      std::make_shared<const Geometry>(std::vector<Shape>{triangle_mesh("a"), spheres, triangle_mesh("b")});
  scene.materials = {{"grey", Lambert{}}};
  scene.bindings = {{0, no_light}, {0, no_light}, {0, no_light}};
  const auto map = std::make_shared<Image>(2, 1);
  map->pixels = {{0.1f, 2, 3e8f}, {4, 5, 6}};
  scene.lights = {{"sky", EnvironmentLight{map}}};
  const WrittenScene written = written_scene({scene, {.resolution = {{480, 360}}}}, path);
  std::vector<std::string> paths;
  for (const SceneFile& file : written.files) paths.push_back(file.path);
  CHECK(paths == std::vector<std::string>{folder.file("room-0.ply"), folder.file("room-2.ply"),
                                          folder.file("room-light-0.exr"), path});
  CHECK(folder.file_count() == 0);
  write_files(written);
  CHECK(folder.file_count() == 4);
  CHECK(read_text(path) == exchange_json(scene, path, {}));
  CHECK(read_text(folder.file("room-2.ply")) == ply_bytes(triangle_mesh("b")));
  const Image read = read_image(folder.file("room-light-0.exr"));
  CHECK(std::memcmp(read.pixels.data(), map->pixels.data(), sizeof(Rgb) * 2) == 0);
}

TEST_CASE("textures in exchange form are of its third version, patterns of its fourth") {
  const TemporaryFolder folder;
  const std::string path = folder.file("room.json");
  Scene scene;
  Image map(2, 1);
  map.pixels = {{0.1f, 2, 3}, {4, 5, 6}};
  const auto picture = std::make_shared<const MipMap>(map);
  scene.textures = {{"even", ConstantTexture{{0.25f, 0.5f, 1}}},
                    {"wood", ImageTexture{picture, WrapMode::clamp, TextureFilter::nearest, {}}},
                    {"same", ImageTexture{picture, {WrapMode::repeat, WrapMode::black}}},
                    {"drawn", ImageTexture{std::make_shared<const MipMap>(std::vector{map})}}};
  CHECK(list_text(scene, "textures") == R"(  "textures": [
    {"name":"even","type":"constant","value":[0.25,0.5,1.0]},
    {"name":"wood","type":"image","wrap":"clamp","filter":"nearest","uv":[[1.0,0.0,0.0],[0.0,1.0,0.0]],)"
                                        R"("coordinates":"first","file":"a-texture-1.exr"},
    {"name":"same","type":"image","wrap":["repeat","black"],"filter":"stochastic",)"
                                        R"("uv":[[1.0,0.0,0.0],[0.0,1.0,0.0]],"coordinates":"first",)"
                                        R"("file":"a-texture-1.exr"},
    {"name":"drawn","type":"image","wrap":"repeat","filter":"stochastic","uv":[[1.0,0.0,0.0],[0.0,1.0,0.0]],)"
                                        R"("coordinates":"first","file":"a-texture-3.exr","mip_map":false})");
  const auto version = [&] { return nlohmann::json::parse(exchange_json(scene, "a.json", {}))["version"]; };
  CHECK(version() == 3);
  scene.textures.push_back({"clouds", NoiseTexture{}});
  CHECK(version() == 4);
  scene.textures.pop_back();
  const WrittenScene written = written_scene({scene, {.resolution = {{480, 360}}}}, path);
  std::vector<std::string> paths;
  for (const SceneFile& file : written.files) paths.push_back(file.path);
  CHECK(paths ==
        std::vector<std::string>{folder.file("room-texture-1.exr"), folder.file("room-texture-3.exr"), path});
  CHECK(written.warnings.empty());
  write_files(written);
  CHECK(read_image(folder.file("room-texture-1.exr")).pixels == map.pixels);
}

TEST_CASE("instances in exchange form are of its second version") {
  Scene scene;
  Transform place = Transform::translation(1, 2, 3);
  place.m[0][0] = 0.1;  // No float.
  scene.geometry = std::make_shared<const Geometry>(
      std::vector<Shape>{triangle_mesh("a"), triangle_mesh("b"), triangle_mesh("c")}, nullptr,
      Instancing{{{1, 1}, {2, 1}}, {{1, place}, {0, {}}}});
  scene.materials = {{"grey", Lambert{}}};
  scene.bindings.resize(3);
  const auto json = nlohmann::json::parse(exchange_json(scene, "a.json", {}));
  CHECK(json["version"] == 2);
  CHECK_FALSE(json["shapes"][0].contains("prototype"));
  CHECK(json["shapes"][1]["prototype"] == 0);
  CHECK(json["shapes"][2]["prototype"] == 1);
  REQUIRE(json["instances"].size() == 2);
  CHECK(json["instances"][0]["prototype"] == 1);
  CHECK(json["instances"][0]["to_world"] ==
        nlohmann::json::parse("[[0.1, 0, 0, 1], [0, 1, 0, 2], [0, 0, 1, 3]]"));
  Scene plain = scene;
  plain.geometry = std::make_shared<const Geometry>(scene.geometry->shapes());
  CHECK(nlohmann::json::parse(exchange_json(plain, "a.json", {}))["version"] == 1);
}

TEST_CASE("a camera in exchange form has the bits of its frame, whatever the shape of the picture") {
  Scene scene;
  scene.materials = {{"grey", Lambert{}}};
  for (const ExchangePicture& size : {ExchangePicture{500, 333}, ExchangePicture{333, 500}})
    for (int i = 1; i <= 200; ++i) {
      CAPTURE(size.width, i);
      scene.camera.tan_half_width = i % 2 == 0 ? 0.01f * float(i) : 0.001f;
      scene.camera.tan_half_height = i % 2 == 0 ? 0.001f : 0.01f * float(i);
      const Camera written = fit_frame(scene.camera, size.width, size.height);
      const LoadedScene loaded = read_exchange(exchange_json(scene, "a.json", size), "a.json", {}, {});
      const Camera read = fit_frame(loaded.scene.camera, size.width, size.height);
      CHECK_FALSE(read.is_stretched);
      CHECK(read.tan_half_width == written.tan_half_width);
      CHECK(read.tan_half_height == written.tan_half_height);
    }
}

}  // namespace twinray::test
