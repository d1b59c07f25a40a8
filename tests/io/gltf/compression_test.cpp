// SPDX-License-Identifier: Apache-2.0
// Data that Draco and meshoptimizer pack, packed here by their own encoders.
#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <meshoptimizer.h>

#include "tests/io/gltf/file.h"
#include "tests/support/catch.h"

namespace twinray {
namespace {

using test::GltfFile;
using test::only_mesh;

/// A grid of squares in z = 0: enough vertices for codecs to work on.
struct Grid {
  static constexpr std::uint32_t side = 17;
  std::vector<float> positions;
  std::vector<std::uint32_t> indices;

  Grid() {
    for (std::uint32_t y = 0; y < side; ++y)
      for (std::uint32_t x = 0; x < side; ++x)
        for (const float c : {float(x), float(y), 0.0f}) positions.push_back(c);
    for (std::uint32_t y = 0; y + 1 < side; ++y)
      for (std::uint32_t x = 0; x + 1 < side; ++x) {
        const std::uint32_t a = y * side + x, b = a + side;
        for (const std::uint32_t i : {a, a + 1, b, b, a + 1, b + 1}) indices.push_back(i);
      }
  }
  std::size_t vertices() const { return positions.size() / 3; }
};

/// A compressed view in place of the view of an accessor.
void compress(GltfFile& file, int accessor, const std::vector<unsigned char>& bytes, std::size_t count,
              std::size_t stride, const char* mode) {
  const int packed = file.view({bytes.begin(), bytes.end()});
  const auto source = file.json["bufferViews"][std::size_t(packed)];
  const std::size_t view = file.json["accessors"][std::size_t(accessor)]["bufferView"];
  file.json["bufferViews"][view]["extensions"]["EXT_meshopt_compression"] = {
      {"buffer", 0},
      {"byteOffset", source["byteOffset"]},
      {"byteLength", bytes.size()},
      {"byteStride", stride},
      {"count", count},
      {"mode", mode}};
}

GltfFile meshopt_grid(const Grid& grid) {
  GltfFile file;
  const int positions = file.accessor<float>(grid.positions, "VEC3");
  const int indices = file.accessor<std::uint32_t>(grid.indices, "SCALAR");
  std::fill(file.buffer.begin(), file.buffer.end(), '\0');  // Nothing but the packed data is left.
  file.show({{"attributes", {{"POSITION", positions}}}, {"indices", indices}});
  std::vector<unsigned char> packed(meshopt_encodeVertexBufferBound(grid.vertices(), 12));
  packed.resize(
      meshopt_encodeVertexBuffer(packed.data(), packed.size(), grid.positions.data(), grid.vertices(), 12));
  compress(file, positions, packed, grid.vertices(), 12, "ATTRIBUTES");
  packed.resize(meshopt_encodeIndexBufferBound(grid.indices.size(), grid.vertices()));
  packed.resize(
      meshopt_encodeIndexBuffer(packed.data(), packed.size(), grid.indices.data(), grid.indices.size()));
  compress(file, indices, packed, grid.indices.size(), 4, "TRIANGLES");
  return file;
}

std::string draco_bytes(const Grid& grid) {
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(int(grid.indices.size() / 3));
  const int positions = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  for (std::size_t i = 0; i < grid.indices.size(); i += 3)
    builder.SetAttributeValuesForFace(
        positions, draco::FaceIndex(std::uint32_t(i / 3)), &grid.positions[3 * grid.indices[i]],
        &grid.positions[3 * grid.indices[i + 1]], &grid.positions[3 * grid.indices[i + 2]]);
  const auto mesh = builder.Finalize();
  draco::Encoder encoder;
  encoder.SetEncodingMethod(draco::MESH_EDGEBREAKER_ENCODING);
  draco::EncoderBuffer buffer;
  REQUIRE(encoder.EncodeMeshToBuffer(*mesh, &buffer).ok());
  return {buffer.data(), buffer.size()};
}

/// Its accessors have no data: these are Draco's.
GltfFile draco_grid(const Grid& grid) {
  GltfFile file;
  const int positions =
      file.add("accessors", {{"componentType", 5126}, {"count", grid.vertices()}, {"type", "VEC3"}});
  const int indices =
      file.add("accessors", {{"componentType", 5125}, {"count", grid.indices.size()}, {"type", "SCALAR"}});
  file.show({{"attributes", {{"POSITION", positions}}}, {"indices", indices}});
  file.primitive()["extensions"]["KHR_draco_mesh_compression"] = {
      {"bufferView", file.view(draco_bytes(grid))}, {"attributes", {{"POSITION", 0}}}};
  return file;
}

double area(const LoadedScene& loaded) {
  double sum = 0;
  const Mesh& mesh = only_mesh(loaded);
  for (const auto& [a, b, c] : mesh.triangles)
    sum +=
        0.5 * double(cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]).z);
  return sum;
}

}  // namespace

TEST_CASE("gltf: what meshoptimizer packed comes out as it was") {
  const Grid grid;
  const LoadedScene loaded = meshopt_grid(grid).load();
  CHECK(loaded.warnings.empty());
  const Mesh& mesh = only_mesh(loaded);
  REQUIRE(mesh.positions.size() == grid.vertices());
  CHECK(mesh.positions[20] == Vec3{3, 1, 0});
  CHECK(mesh.triangles.size() == grid.indices.size() / 3);
  CHECK(area(loaded) == 256);
}

TEST_CASE("gltf: what is wrong with packed data is said before memory is taken") {
  GltfFile file = meshopt_grid(Grid());
  auto& extension = file.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"];
  const std::string place = "test.gltf: /bufferViews/0/extensions/EXT_meshopt_compression";
  extension["count"] = 2000000000;
  CHECK(file.error().find(place + ": 2000000000 elements of 12 bytes cannot come of ") == 0);
  extension["count"] = 288;
  CHECK(file.error() == place + ": the compressed data are damaged");
  extension["byteStride"] = 10;
  CHECK(file.error() == place + ": ATTRIBUTES of the filter \"NONE\" do not have 10 bytes an element");
  extension["mode"] = "LINES";
  CHECK(file.error() == place + "/mode: this is \"LINES\"; valid is ATTRIBUTES, TRIANGLES or INDICES");
}

TEST_CASE("gltf: what Draco packed comes out as it was") {
  const Grid grid;
  const LoadedScene loaded = draco_grid(grid).load();
  CHECK(loaded.warnings.empty());
  CHECK(only_mesh(loaded).positions.size() == grid.vertices());
  CHECK(area(loaded) == Approx(256).epsilon(1e-3));
}

TEST_CASE("gltf: joints of what Draco packed are its own, in its order, and a strip is triangles") {
  // A row of triangles; of each vertex a joint of its own number, 1 above, is all that moves it.
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(3);
  const int positions = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  const int joints = builder.AddAttribute(draco::GeometryAttribute::GENERIC, 4, draco::DT_UINT8);
  const int weights = builder.AddAttribute(draco::GeometryAttribute::GENERIC, 4, draco::DT_FLOAT32);
  const float place[5][3] = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {2, 0, 0}};
  const std::uint8_t joint[5][4] = {{0}, {1}, {2}, {3}, {4}};
  const float whole[4] = {1, 0, 0, 0};
  const unsigned corners[3][3] = {{4, 3, 2}, {0, 2, 1}, {1, 2, 3}};
  for (unsigned i = 0; i < 3; ++i) {
    const auto& [a, b, c] = corners[i];
    const draco::FaceIndex face(i);
    builder.SetAttributeValuesForFace(positions, face, place[a], place[b], place[c]);
    builder.SetAttributeValuesForFace(joints, face, joint[a], joint[b], joint[c]);
    builder.SetAttributeValuesForFace(weights, face, whole, whole, whole);
  }
  const auto mesh = builder.Finalize();
  const auto id = [&](int attribute) { return mesh->attribute(attribute)->unique_id(); };
  draco::Encoder encoder;
  encoder.SetEncodingMethod(draco::MESH_EDGEBREAKER_ENCODING);
  draco::EncoderBuffer buffer;
  REQUIRE(encoder.EncodeMeshToBuffer(*mesh, &buffer).ok());
  GltfFile file;
  const auto empty = [&](int component, const char* type) {
    return file.add("accessors", {{"componentType", component}, {"count", 5}, {"type", type}});
  };
  file.show({{"attributes",
              {{"POSITION", empty(5126, "VEC3")},
               {"JOINTS_0", empty(5121, "VEC4")},
               {"WEIGHTS_0", empty(5126, "VEC4")}}},
             {"mode", 5}});
  file.primitive()["extensions"]["KHR_draco_mesh_compression"] = {
      {"bufferView", file.view({buffer.data(), buffer.size()})},
      {"attributes", {{"POSITION", id(positions)}, {"JOINTS_0", id(joints)}, {"WEIGHTS_0", id(weights)}}}};
  file.json["nodes"][0]["skin"] = 0;
  auto& skin = file.json["skins"][0]["joints"];
  for (int i = 0; i < 5; ++i) {
    skin.push_back(file.json["nodes"].size());
    file.add_node({{"translation", {0, 0, i}}});
  }
  const LoadedScene loaded = file.load();
  CHECK(loaded.warnings.empty());
  const Mesh& moved = only_mesh(loaded);
  CHECK(moved.triangles.size() == 3);
  REQUIRE(moved.positions.size() == 5);
  for (const Vec3& p : moved.positions)
    CHECK(p.z == Approx(2 * std::round(p.x) + std::round(p.y)).margin(1e-5));
  // Of too few numbers each, none is read beyond them.
  for (const char* name : {"JOINTS_0", "WEIGHTS_0"}) {
    GltfFile narrow = file;
    const std::size_t accessor = narrow.primitive()["attributes"][name];
    narrow.json["accessors"][accessor]["type"] = "SCALAR";
    CHECK(narrow.error() == "test.gltf: /accessors/" + std::to_string(accessor) +
                                ": the type is SCALAR; what names this accessor takes VEC4");
  }
}

TEST_CASE("gltf: what is wrong with Draco's data has its place") {
  GltfFile file = draco_grid(Grid());
  const std::string place = "test.gltf: /meshes/0/primitives/0/extensions/KHR_draco_mesh_compression";
  auto& extension = file.primitive()["extensions"]["KHR_draco_mesh_compression"];
  extension["attributes"]["POSITION"] = 5;
  CHECK(file.error() == place + "/attributes/POSITION: the compressed mesh has no attribute of this number");
  extension["attributes"] = {{"NORMAL", 0}};
  CHECK(file.error() == place + "/attributes/NORMAL: the primitive itself has no attribute of this name");
  extension["attributes"] = {{"POSITION", 0}};
  file.buffer[0] = 'X';
  CHECK(file.error().find(place + ": the compressed mesh is damaged: ") == 0);
}

}  // namespace twinray
