// SPDX-License-Identifier: Apache-2.0
#include "io/ply/reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "io/gzip.h"
#include "io/ply/ply.h"
#include "tests/support/catch.h"

namespace twinray {
namespace {

const std::string square =
    "ply\nformat ascii 1.0\ncomment made by hand\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property double z\nproperty uchar red\nproperty float s\nproperty float t\nelement face 1\n"
    "property list uchar int vertex_indices\nproperty int material\nend_header\n"
    "0 0 0 255 0 0\n1 0 0 255 1 0\n1 1 0 255 1 1\n0 1 0 255 0 1\n4 0 1 2 3 7\n";

std::string replaced(std::string text, const std::string& old, const std::string& anew) {
  const std::size_t at = text.find(old);
  REQUIRE(at != std::string::npos);
  return text.replace(at, old.size(), anew);
}

std::string ply_error(const std::string& bytes) {
  try {
    read_ply(bytes, "a.ply");
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

/// A binary file of one triangle, its numbers in the order that the format says.
std::string binary(bool is_big) {
  std::string bytes = std::string("ply\nformat binary_") + (is_big ? "big" : "little") +
                      "_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty short z\n"
                      "element face 1\nproperty list uchar uint vertex_index\nend_header\n";
  const auto add = [&](auto number) {
    std::string raw(reinterpret_cast<const char*>(&number), sizeof number);
    if (is_big) std::reverse(raw.begin(), raw.end());
    bytes += raw;
  };
  for (int i = 0; i < 3; ++i) add(float(i)), add(float(i * i) + 0.5f), add(std::int16_t(-i));
  bytes += '\3';
  for (std::uint32_t i = 0; i < 3; ++i) add(i);
  return bytes;
}

}  // namespace

TEST_CASE("an ASCII PLY file is read with what a mesh has no use for in it") {
  const PlyMesh ply = read_ply(square, "a.ply");
  CHECK(ply.mesh.positions.size() == 4);
  CHECK(ply.mesh.positions[2] == Vec3{1, 1, 0});
  CHECK(ply.mesh.uvs[2] == Vec2{1, 1});
  CHECK(ply.mesh.triangles == std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}});
  CHECK(ply.mesh.uv_indices == ply.mesh.triangles);
  CHECK(ply.mesh.normals.empty());
  CHECK(read_ply("\xef\xbb\xbf" + square, "a.ply").mesh.positions == ply.mesh.positions);
}

TEST_CASE("binary PLY files of both byte orders hold the same mesh") {
  for (const bool is_big : {false, true}) {
    const Mesh mesh = read_ply(binary(is_big), "a.ply").mesh;
    CHECK(mesh.positions == std::vector<Vec3>{{0, 0.5f, 0}, {1, 1.5f, -1}, {2, 4.5f, -2}});
    CHECK(mesh.triangles == std::vector<Triangle>{{0, 1, 2}});
  }
}

TEST_CASE("what is written as PLY is read with all its bits") {
  Mesh mesh;
  mesh.positions = {{0.1f, 1e-30f, 3}, {1e12f, -0.0f, 5}, {7, 8, 9.3f}};
  mesh.normals = {{0, 0, 1}, {0, 0.6f, 0.8f}, {1, 0, 0}};
  mesh.uvs = {{0.25f, 0}, {1, -3}, {0.5f, 0.5f}};
  mesh.triangles = mesh.normal_indices = mesh.uv_indices = {{0, 1, 2}};
  const Mesh read = read_ply(ply_bytes(mesh), "a.ply").mesh;
  CHECK(read.positions == mesh.positions);
  CHECK(read.normals == mesh.normals);
  CHECK(read.uvs == mesh.uvs);
  CHECK(read.triangles == mesh.triangles);
}

TEST_CASE("polygons of a PLY file are cut, and faces of two corners are counted") {
  const std::string text =
      "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 2\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0\n2 0 0\n2 2 0\n1 0.5 0\n0 2 0\n5 0 1 2 3 4\n2 0 1\n";
  const PlyMesh ply = read_ply(text, "a.ply");
  CHECK(ply.mesh.triangles.size() == 3);
  CHECK(ply.flat_faces == 1);
}

TEST_CASE("a concave face of four corners is cut within, whichever corner comes first") {
  const Vec3 corners[] = {{-10, 0, 0}, {0, -1, 0}, {-1, 0, 0}, {0, 1, 0}};
  for (int first = 0; first < 4; ++first) {
    std::string text =
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    for (int i = 0; i < 4; ++i) {
      const Vec3& corner = corners[(first + i) % 4];
      text += fmt::format("{} {} {}\n", corner.x, corner.y, corner.z);
    }
    const Mesh mesh = read_ply(text + "4 0 1 2 3\n", "a.ply").mesh;
    REQUIRE(mesh.triangles.size() == 2);
    float area = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
      const Vec3& p = mesh.positions[a];
      area += std::fabs(cross(mesh.positions[b] - p, mesh.positions[c] - p).z) / 2;
    }
    CHECK(area == Approx(9));
  }
}

TEST_CASE("what is wrong with a PLY file is named, with its place") {
  CHECK(ply_error("plx") == "a.ply:1:1: not a PLY file: its first line must be \"ply\"\n  plx\n  ^");
  CHECK(ply_error("ply\nformat ascii 1.0\n") ==
        "a.ply:3:1: the header does not end: \"end_header\" is missing\n  \n  ^");
  CHECK(ply_error(replaced(square, "ascii", "text"))
            .starts_with("a.ply:2:8: there is no format \"text\"; valid are ascii"));
  CHECK(ply_error(replaced(square, "float x", "flot x"))
            .starts_with("a.ply:5:10: \"flot\" is not a type of numbers"));
  CHECK(ply_error(replaced(square, "vertex 4", "vertex -4"))
            .starts_with("a.ply:4:16: \"-4\" is not the number of an element"));
  CHECK(ply_error(replaced(square, "4 0 1 2 3", "4 0 1 2 4"))
            .starts_with("a.ply:19:9: the index 4 is out of range; valid are whole numbers from 0 to 3"));
  CHECK(ply_error(replaced(square, "1 0 0 255", "1 nan 0 255"))
            .starts_with("a.ply:16:15: the position of vertex 1 is not finite"));
  for (const char* word : {"1 1e999 0 255", "1 -1e39 0 255"})
    CHECK_THAT(ply_error(replaced(square, "1 0 0 255", word)),
               Catch::Contains(": the position of vertex 1 is not finite"));
  CHECK(
      ply_error(replaced(square, "1 0 0 255", "1 x 0 255")).starts_with("a.ply:16:3: \"x\" is not a number"));
  CHECK(ply_error(replaced(square, "vertex 4", "vertex 400000000")) ==
        "a.ply: the header promises 400000000 elements \"vertex\", and the file is too short for them");
  CHECK(ply_error(replaced(square, "float y", "float why")) ==
        "a.ply: the vertices need the properties x, y and z");
  CHECK(ply_error(replaced(square, "element face 1", "element fase 1")) ==
        "a.ply: the PLY file has no element \"face\", so it holds points alone");
  CHECK(ply_error(replaced(square, "element face 1", "element tristrips 1")) ==
        "a.ply: the PLY file has no element \"face\"; strips of triangles (\"tristrips\") are not read");
  CHECK(ply_error(binary(false).substr(0, binary(false).size() - 1)) ==
        "a.ply: the file ends too early, after 210 bytes");
}

TEST_CASE("a gzip file is unpacked, and a damaged one named") {
  const std::string packed(
      "\x1f\x8b\x08\x00\x00\x00\x00\x00\x02\xff\xcb\x48\xcd\xc9\xc9\x07\x00\x86\xa6\x10\x36\x05\x00\x00\x00",
      25);
  CHECK(is_gzip(packed));
  CHECK(unpack_gzip(packed, "a.gz") == "hello");
  CHECK(unpack_gzip(packed + packed, "a.gz") == "hellohello");
  CHECK_THROWS_WITH(unpack_gzip(packed.substr(0, 20), "a.gz"), "a.gz: the gzip file is cut off");
  std::string wrong = packed;
  wrong[19] = 'x';
  CHECK_THROWS_WITH(unpack_gzip(wrong, "a.gz"), "a.gz: the gzip file is damaged: incorrect data check");
}

}  // namespace twinray
