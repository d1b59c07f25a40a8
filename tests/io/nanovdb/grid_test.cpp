// SPDX-License-Identifier: Apache-2.0
#include "io/nanovdb/grid.h"

#include <cmath>
#include <cstring>
#include <limits>

#include "core/error.h"
#include "tests/io/nanovdb/nvdb_bytes.h"
#include "tests/support/catch.h"
#include "tests/support/error_text.h"
#include "tests/support/random.h"
#include "tests/support/text.h"

namespace twinray::test {
namespace {

NvdbGrid read(const NvdbContent& content, const Transform& to_world = {}) {
  const std::string bytes = nvdb_bytes({content});
  return read_nvdb_grid(NvdbFile(bytes, "a.nvdb"), content.name, to_world);
}

std::vector<NvdbVoxel> some_voxels() {
  Random random(4);
  std::vector<NvdbVoxel> voxels;
  for (int i = 0; i < 300; ++i)  // Over several leaves, on both sides of 0.
    voxels.push_back({{int(random.below(40)) - 20, int(random.below(20)) - 3, int(random.below(300)) - 150},
                      random.uniform(0, 4)});
  return voxels;
}

/// Where a voxel lies in the scene, by the grid's own map.
Vec3 place_of(const NvdbContent& content, const std::array<int, 3>& at) {
  const auto along = [&](std::size_t k) { return float(content.origin[k] + content.voxel_size * at[k]); };
  return {along(0), along(1), along(2)};
}

std::string error_of(const NvdbContent& content) {
  return error_text([&] { read(content); });
}

}  // namespace

TEST_CASE("a NanoVDB grid has its values where its voxels are, and falls to 0 between them") {
  NvdbContent content{.voxels = some_voxels(), .voxel_size = 0.5, .origin = {1, -2, 30}};
  const Transform turned = Transform::rotation({1, 1, 0}, 30) * Transform::scaling(2, 1, 1);
  for (const Transform& to_world : {Transform{}, turned}) {
    const NvdbGrid grid = read(content, to_world);
    CHECK(grid.negative == 0);
    // The last of several values at one place counts.
    for (std::size_t i = 0; i < content.voxels.size(); ++i) {
      const auto& [at, value] = content.voxels[i];
      bool is_last = true;
      for (std::size_t k = i + 1; k < content.voxels.size(); ++k) is_last &= content.voxels[k].at != at;
      if (is_last)
        CHECK(grid.densities->at(to_world.point(place_of(content, at))) ==
              Approx(double(value)).epsilon(1e-3).margin(1e-3));
    }
    CHECK(grid.densities->at(to_world.point(place_of(content, {500, 0, 0}))) == 0);
  }
  const NvdbGrid one = read({.voxels = {{{5, 6, 7}, 3}}});
  CHECK(one.densities->at({5, 6, 7}) == Approx(3));
  CHECK(one.densities->at({5.5f, 6, 7}) == Approx(1.5));
  CHECK(one.densities->at({4.25f, 6, 7}) == Approx(0.75));
  CHECK(one.densities->at({4, 6, 7}) == Approx(0).margin(1e-6));
}

TEST_CASE("a NanoVDB grid of fewer bits has its values but for their steps") {
  using Type = NvdbContent::Type;
  NvdbContent content{.voxels = some_voxels()};
  const NvdbGrid exact = read(content);
  for (const auto& [type, step] : {std::pair{Type::fp4, 4.0 / 15},
                                   {Type::fp8, 4.0 / 255},
                                   {Type::fp16, 4.0 / 65535},
                                   {Type::fpn, 0.05}}) {
    content.type = type;
    const NvdbGrid grid = read(content);
    REQUIRE(grid.densities->size() == exact.densities->size());
    for (const NvdbVoxel& voxel : content.voxels) {
      const Vec3 at = place_of(content, voxel.at);
      CHECK(std::fabs(grid.densities->at(at) - exact.densities->at(at)) < step);
    }
  }
}

TEST_CASE("values that are the same in a whole node are the grid's") {
  NvdbContent content;
  for (int x = 0; x < 16; ++x)
    for (int y = 0; y < 8; ++y)
      for (int z = 0; z < 8; ++z) content.voxels.push_back({{x, y, z}, x < 8 ? 2.0f : 3.0f});
  std::string bytes = nvdb_bytes({content});
  const NvdbGrid grid = read_nvdb_grid(NvdbFile(bytes, "a.nvdb"), "density", {});
  CHECK(grid.densities->at({4, 4, 4}) == Approx(2));
  CHECK(grid.densities->at({12, 4, 4}) == Approx(3));
  CHECK(grid.densities->at({-1.5f, 4, 4}) == 0);
}

TEST_CASE("a NanoVDB grid without anything is empty, and negative numbers are counted") {
  const NvdbGrid empty = read({});
  CHECK(empty.densities->at({0, 0, 0}) == 0);
  const NvdbGrid some = read({.voxels = {{{0, 0, 0}, -1}, {{1, 0, 0}, -2}, {{2, 0, 0}, 3}}});
  CHECK(some.negative == 2);
  CHECK(some.densities->at({0, 0, 0}) == 0);
  CHECK(some.densities->at({2, 0, 0}) == Approx(3));
}

TEST_CASE("NanoVDB grids that are no densities are refused with what they are") {
  const std::string place = "a.nvdb: the grid \"density\": ";
  CHECK(error_of({.voxels = {{{0, 0, 0}, 1}}, .type = NvdbContent::Type::whole}) ==
        place + "its values are of the type Int32; valid are Float, Fp4, Fp8, Fp16 and FpN");
  CHECK(error_of({.voxels = {{{0, 0, 0}, 1}}, .is_level_set = true}) ==
        place + "it is a level set, or of another class than a fog volume");
  CHECK(error_of({.voxels = {{{0, 0, 0}, std::numeric_limits<float>::infinity()}}}) ==
        place + "a number of the grid is inf; it must be finite and >= 0");
  CHECK(contains(error_of({.voxels = {{{0, 0, 0}, 1}, {{40000, 0, 0}, 1}}}), "each must be from 1 to 16384"));
  CHECK(error_of({.voxels = {{{0, 0, 0}, 1}}, .voxel_size = 1e-200}) ==
        place + "it lies in a box that is flat or too large");
}

TEST_CASE("a NanoVDB grid that is damaged anywhere ends with an error, or as some grid") {
  const std::string bytes = nvdb_bytes({{.voxels = some_voxels()}});
  Random random(8);
  int errors = 0;
  for (int i = 0; i < 150; ++i) {
    std::string damaged = bytes;
    // Its headers, root and first nodes, or anywhere.
    const std::size_t end = i % 4 == 0 ? damaged.size() : 3000;
    for (int k = 0; k < 4; ++k) {
      const std::size_t at = 16 + 176 + 8 + random.below(std::uint32_t(end - 300));
      const std::uint64_t number = i % 3 == 0   ? ~std::uint64_t(0)
                                   : i % 3 == 1 ? random.below(1 << 20)
                                                : std::uint64_t(random.below(1 << 31)) << random.below(32);
      std::memcpy(damaged.data() + at, &number, 1 + random.below(8));
    }
    try {
      read_nvdb_grid(NvdbFile(damaged, "a.nvdb"), "density", {});
    } catch (const Error& error) {
      CHECK(std::string_view(error.what()).starts_with("a.nvdb: "));
      ++errors;
    }
  }
  CHECK(errors > 10);
}

}  // namespace twinray::test
