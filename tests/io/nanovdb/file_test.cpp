// SPDX-License-Identifier: Apache-2.0
#include "io/nanovdb/file.h"

#include <cstring>

#include "tests/io/nanovdb/nvdb_bytes.h"
#include "tests/support/catch.h"
#include "tests/support/error_text.h"
#include "tests/support/text.h"

namespace twinray::test {
namespace {

std::string some_file(NvdbPacking packing = NvdbPacking::none) {
  return nvdb_bytes(
      {{.name = "smoke", .voxels = {{{1, 2, 3}, 4}}}, {.name = "heat", .voxels = {{{0, 0, 0}, 9}}}}, packing);
}

std::string error_of(const std::string& bytes, const std::string& grid = "smoke") {
  return error_text([&] { NvdbFile(bytes, "a.nvdb").grid(grid); });
}

/// With a number in place of that at an offset.
template <typename T>
std::string with(std::string bytes, std::size_t offset, T number) {
  std::memcpy(bytes.data() + offset, &number, sizeof number);
  return bytes;
}

}  // namespace

TEST_CASE("a NanoVDB file has the same grids however it is packed") {
  const std::string plain = some_file();
  const NvdbFile file(plain, "a.nvdb");
  CHECK(file.grid_names() == std::vector<std::string_view>{"smoke", "heat"});
  CHECK(file.has("heat"));
  CHECK_FALSE(file.has("density"));
  for (const NvdbPacking packing : {NvdbPacking::zip, NvdbPacking::blosc}) {
    const std::string packed = some_file(packing);
    CHECK(packed.size() < plain.size() / 4);
    const NvdbFile same(packed, "b.nvdb");
    CHECK(same.grid_names() == file.grid_names());
    for (const char* name : {"smoke", "heat"}) {
      const bool is_same = same.grid(name) == file.grid(name);
      CHECK(is_same);
    }
  }
  // Segments follow each other.
  const std::string two =
      plain + nvdb_bytes({{.name = "third", .voxels = {{{0, 0, 0}, 1}}}}, NvdbPacking::zip);
  CHECK(NvdbFile(two, "c.nvdb").has("third"));
  CHECK(NvdbFile(two, "c.nvdb").grid("third").size() > 1000);
}

TEST_CASE("a NanoVDB file that cannot be is refused with what is wrong") {
  const std::string plain = some_file(), zip = some_file(NvdbPacking::zip),
                    blosc = some_file(NvdbPacking::blosc);
  CHECK(error_of(plain) == "");
  CHECK(error_of(plain, "density") == "a.nvdb: has no grid \"density\"; it has \"smoke\", \"heat\"");
  CHECK(error_of("") == "a.nvdb: the NanoVDB file is cut off in its header");
  CHECK(error_of("PLY\nformat ascii and so on") == "a.nvdb: is not a NanoVDB file");
  CHECK(error_of(with(plain, 8, std::uint32_t(29u << 21))) ==
        "a.nvdb: is a NanoVDB file of version 29; only version 32 is read");
  CHECK(contains(error_of(with(plain, 14, std::uint16_t(7))), "a codec of number 7"));
  CHECK(error_of(plain.substr(0, 100)) == "a.nvdb: the NanoVDB file is cut off in the header of a grid");
  CHECK(error_of(plain.substr(0, 16 + 176 + 3)) ==
        "a.nvdb: the NanoVDB file is cut off in the name of a grid");
  CHECK(error_of(plain.substr(0, plain.size() - 1)) == "a.nvdb: the NanoVDB file is cut off in a grid");
  CHECK(contains(error_of(with(plain, 16, std::uint64_t(1) << 40)), "the most that are read are 1073741824"));
  CHECK(error_of(with(plain, 16, std::uint64_t(1) << 22)) == "a.nvdb: the NanoVDB file is cut off in a grid");
  // The packed bytes lie behind both headers and names, and the number of them.
  const std::size_t body = 16 + 2 * 176 + sizeof "smoke" + sizeof "heat";
  CHECK(error_of(with(zip, body + 40, std::uint64_t(0x1234567812345678))) ==
        "a.nvdb: what zlib has packed is damaged");
  CHECK(error_of(with(zip, body, std::uint64_t(1) << 60)) == "a.nvdb: the NanoVDB file is cut off in a grid");
  CHECK(error_of(with(zip, 16, std::uint64_t(300000))) == "a.nvdb: what zlib has packed is damaged");
  CHECK(error_of(with(blosc, body + 8 + 12, std::uint32_t(0x7fffffff))) ==
        "a.nvdb: what Blosc has packed is damaged");
  CHECK(error_of(with(blosc, 16, std::uint64_t(300000))) == "a.nvdb: what Blosc has packed is damaged");
}

}  // namespace twinray::test
