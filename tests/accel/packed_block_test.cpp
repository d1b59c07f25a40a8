// SPDX-License-Identifier: Apache-2.0
// Leaves in little memory: every kind of block comes back with its bits.
#include "accel/compact/packed_block.h"

#include <array>
#include <cstring>
#include <vector>

#include "tests/support/catch.h"
#include "tests/support/cut_outs.h"
#include "tests/support/shapes.h"

using namespace twinray;
using namespace twinray::test;

namespace {

std::vector<std::uint16_t> packed_words(const PrimitiveBlock& block) {
  std::vector<std::uint16_t> words(packed::max_words + packed_slack);
  words.resize(pack(block, words.data()));
  REQUIRE(words.size() % packed_unit == 0);
  return words;
}

/// Whether two blocks are equal bit by bit in the lanes that are used.
bool same_blocks(const PrimitiveBlock& a, const PrimitiveBlock& b) {
  if (a.count != b.count || a.triangles != b.triangles || a.spheres != b.spheres || a.others != b.others ||
      a.cut_outs != b.cut_outs)
    return false;
  for (std::uint32_t lane = 0; lane < a.count; ++lane) {
    if (a.ids[lane] != b.ids[lane]) return false;
    for (int corner = 0; corner < 3; ++corner)
      for (int axis = 0; axis < 3; ++axis)
        if (std::memcmp(&a.corners[corner][axis][lane], &b.corners[corner][axis][lane], sizeof(float)) != 0)
          return false;
  }
  return true;
}

/// Packs the block of these primitives, sees that it comes back, and returns how many words it took.
std::size_t words_of(const Geometry& geometry, const std::vector<PrimitiveId>& ids) {
  const PrimitiveBlock block = make_block(geometry, ids);
  const std::vector<std::uint16_t> words = packed_words(block);
  CHECK(same_blocks(unpacked(words.data()), block));
  return words.size();
}

/// Quads in a row along an axis, each of two triangles, from a corner on.
Mesh strip(const Vec3& corner, float size, int quads) {
  Mesh mesh;
  for (int i = 0; i <= quads; ++i)
    for (const float y : {0.0f, size}) mesh.positions.push_back(corner + Vec3{float(i) * size, y, y * 0.5f});
  for (std::uint32_t i = 0; i < std::uint32_t(quads); ++i) {
    mesh.triangles.push_back({2 * i, 2 * i + 2, 2 * i + 1});
    mesh.triangles.push_back({2 * i + 1, 2 * i + 2, 2 * i + 3});
  }
  return mesh;
}

constexpr std::size_t verbatim_words = packed::max_words;

}  // namespace

TEST_CASE("neighbours in a mesh are packed into a third of their block") {
  for (const Vec3& corner : {Vec3{1, 1, 1}, Vec3{-1, -1, -1}, Vec3{-70, 3, 1000}}) {
    const auto geometry = share({strip(corner, 1e-3f, 4)});
    CHECK(words_of(*geometry, {{0, 0}, {0, 1}, {0, 2}, {0, 3}}) == 36);  // 12 + 4 + 3 times 6, filled up
    CHECK(words_of(*geometry, {{0, 2}, {0, 3}, {0, 4}}) == 32);          // 12 + 3 + 3 times 5, filled up
    CHECK(words_of(*geometry, {{0, 5}}) == 24);                          // 12 + 1 + 3 times 3, filled up
  }
}

TEST_CASE("coordinates of many binades, and of both signs, are packed whole") {
  const auto across = share({strip({-1, -1, -1}, 1, 2)});
  CHECK(words_of(*across, {{0, 0}, {0, 1}, {0, 2}, {0, 3}}) == 12 + 4 + 3 * 12);
  Mesh mesh = strip({1, 1, 1}, 1e-3f, 2);
  for (Vec3& p : mesh.positions) p.y -= 1;  // From 0 on: one axis alone is wide.
  const auto geometry = share({mesh});
  CHECK(words_of(*geometry, {{0, 0}, {0, 1}, {0, 2}, {0, 3}}) == 40);  // 12 + 4 + 6 + 12 + 6, filled up
  mesh.positions[0].x = -0.0f;
  mesh.positions[2].x = 0.0f;
  const auto signed_zeros = share({mesh});
  words_of(*signed_zeros, {{0, 0}, {0, 1}});
}

TEST_CASE("ids that lie far apart, and of several meshes, are packed whole") {
  Mesh mesh = strip({1, 1, 1}, 1e-3f, 2);
  const Triangle last = mesh.triangles[1];
  mesh.triangles.resize(70000, mesh.triangles[0]);
  mesh.triangles.push_back(last);
  const auto geometry = share({mesh, strip({1, 1, 1}, 1e-3f, 1)});
  CHECK(words_of(*geometry, {{0, 0}, {0, 65535}}) == 24);      // 12 + 2 + 3 times 3, filled up
  CHECK(words_of(*geometry, {{0, 0}, {0, 65536}}) == 32);      // 12 + 2 times 4 + 3 times 3, filled up
  CHECK(words_of(*geometry, {{0, 70000}, {1, 0}}) == 32);      // 12 + 2 times 4 + 3 times 4
  CHECK(words_of(*geometry, {{0, 69999}, {0, 70000}}) == 28);  // 12 + 2 + 3 times 4, filled up
}

TEST_CASE("what shares too little, spheres and tiny triangles are stored as they are") {
  Mesh tiny = strip({0, 0, 0}, 1e-20f, 1);
  const auto geometry = share({soup(4, 0.1f, 1), random_spheres(4, 0.1f, 2), tiny});
  CHECK(words_of(*geometry, {{0, 0}, {0, 1}, {0, 2}, {0, 3}}) == verbatim_words);  // 12 corners
  CHECK(words_of(*geometry, {{0, 0}, {0, 1}}) < verbatim_words);                   // 6
  CHECK(words_of(*geometry, {{1, 0}, {1, 3}}) == verbatim_words);
  CHECK(words_of(*geometry, {{0, 0}, {1, 3}}) == verbatim_words);
  CHECK(words_of(*geometry, {{2, 0}, {2, 1}}) == verbatim_words);
}

TEST_CASE("cut-outs are packed as cut-outs, and stored as they are beside others") {
  const auto geometry =
      share_cut_out({strip({1, 1, 1}, 1e-3f, 2), strip({1, 1, 1}, 1e-3f, 2)}, {random_alpha(1)});
  CHECK(words_of(*geometry, {{0, 0}, {0, 1}, {0, 2}, {0, 3}}) == 36);
  CHECK(words_of(*geometry, {{0, 0}, {1, 1}}) == verbatim_words);
}

TEST_CASE("blocks of random triangles that share corners come back with their bits") {
  Random random(5);
  std::size_t shared = 0, verbatim = 0;
  for (int i = 0; i < 20000; ++i) {
    Mesh mesh;
    const int corners = 3 + random.below(12);
    const Vec3 middle = random.in_cube(random.below(2) ? 1 : 1000);
    for (int k = 0; k < corners; ++k)
      mesh.positions.push_back(middle + random.in_cube(random.below(4) ? 0.01f : 100));
    const int triangles = 1 + random.below(4);
    while (int(mesh.triangles.size()) < triangles) {
      Triangle triangle;
      for (std::uint32_t& index : triangle) index = std::uint32_t(random.below(corners));
      mesh.triangles.push_back(triangle);
    }
    drop_degenerate_triangles(mesh);
    if (mesh.triangles.empty()) continue;
    std::vector<PrimitiveId> ids;
    for (std::uint32_t k = 0; k < mesh.triangles.size(); ++k) ids.push_back({0, k});
    const auto geometry = share({std::move(mesh)});
    CAPTURE(i);
    (words_of(*geometry, ids) == verbatim_words ? verbatim : shared) += 1;
  }
  CHECK(shared > 10000);
  CHECK(verbatim > 100);
}
