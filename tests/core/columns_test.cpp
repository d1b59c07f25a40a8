// SPDX-License-Identifier: Apache-2.0
#include "core/columns.h"

#include <algorithm>
#include <cstdint>

#include "core/error.h"
#include "tests/support/catch.h"
#include "tests/support/random.h"

namespace twinray::test {

TEST_CASE("a column has all first bytes of its numbers, then all second ones") {
  ColumnWriter writer;
  const std::uint32_t numbers[] = {0x04030201, 0x14131211, 0x24232221};
  writer.put(std::span<const std::uint32_t>(numbers));
  const std::vector<int> expected{0x01, 0x11, 0x21, 0x02, 0x12, 0x22, 0x03, 0x13, 0x23, 0x04, 0x14, 0x24};
  std::vector<int> bytes;
  for (const std::byte byte : writer.bytes()) bytes.push_back(int(byte));
  CHECK(bytes == expected);
}

TEST_CASE("columns of any length come back as they were, one after the other") {
  struct Pair {
    std::uint32_t a = 0, b = 0;
    bool operator==(const Pair&) const = default;
  };
  Random random(5);
  for (const std::size_t count : {0u, 1u, 2047u, 2048u, 2049u, 10000u}) {
    CAPTURE(count);
    std::vector<Pair> pairs(count);
    std::vector<float> floats(count);
    for (std::size_t i = 0; i < count; ++i) {
      pairs[i] = {std::uint32_t(random.below(1u << 31)), std::uint32_t(random.below(1u << 31))};
      floats[i] = random.uniform(-1e9f, 1e9f);
    }
    ColumnWriter writer;
    writer.put(std::span<const Pair>(pairs));
    writer.put_value(std::uint64_t(77));
    writer.put(std::span<const float>(floats));
    CHECK(writer.bytes().size() == count * 12 + 8);
    ColumnReader reader(writer.bytes());
    CHECK(reader.take_column<Pair>(count) == pairs);
    CHECK(reader.take_value<std::uint64_t>() == 77);
    CHECK(reader.is_at_end() == (count == 0));
    CHECK(reader.take_column<float>(count) == floats);
    CHECK(reader.is_at_end());
  }
}

TEST_CASE("a column that is not there is an error, however long it is said to be") {
  ColumnWriter writer;
  writer.put_value(std::uint32_t(1));
  ColumnReader reader(writer.bytes());
  CHECK_THROWS_WITH(reader.take_value<std::uint64_t>(), "it ends early");
  CHECK_THROWS_AS(reader.take_column<std::uint64_t>(std::size_t(1) << 61), Error);
  CHECK(reader.take_value<std::uint32_t>() == 1);
}

}  // namespace twinray::test
