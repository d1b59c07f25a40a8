// SPDX-License-Identifier: Apache-2.0
#include "io/picture/cryptomatte.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <map>

#include "tests/support/catch.h"

namespace twinray {

TEST_CASE("names are hashed as by MurmurHash3 of 32 bits") {
  // By another program (mmh3 5.2).
  CHECK(murmur_hash("") == 0);
  CHECK(murmur_hash("a") == 0x3c2569b2);
  CHECK(murmur_hash("ab") == 0x9bbfd75f);
  CHECK(murmur_hash("abc") == 0xb3dd93fa);
  CHECK(murmur_hash("hello") == 0x248bfa47);
  CHECK(murmur_hash("The quick brown fox jumps over the lazy dog") == 0x2e4ff723);
}

TEST_CASE("an id is the hash, made a number that every program keeps") {
  CHECK(cryptomatte_id("hello") == 0x248bfa47);
  CHECK(murmur_hash("thing119") == 0x005694cc);
  CHECK(cryptomatte_id("thing119") == 0x00d694cc);
  CHECK(murmur_hash("thing479") == 0xffb21574);
  CHECK(cryptomatte_id("thing479") == 0xff321574);
  for (int i = 0; i < 3000; ++i)
    CHECK(std::isnormal(std::bit_cast<float>(cryptomatte_id("thing" + std::to_string(i)))));
}

TEST_CASE("a name that is not UTF-8 has the id of its letters in Latin-1") {
  const std::string latin = "T\xfcr", utf8 = "T\xc3\xbcr";
  CHECK(cryptomatte_id(latin) == cryptomatte_id(utf8));
  CHECK(cryptomatte_id(latin) == 0xe445a089);
  const ImageMetadata metadata =
      cryptomatte_metadata("CryptoObject", std::vector<std::string>{latin, "T\xf6r"});
  CHECK(metadata.back().second == fmt::format("{{\"T\xc3\xb6r\":\"{:08x}\",\"T\xc3\xbcr\":\"{:08x}\"}}",
                                              cryptomatte_id("T\xc3\xb6r"), cryptomatte_id(utf8)));
}

TEST_CASE("a file says how ids are made, and of which names") {
  const std::vector<std::string> names{"lamp \"left\"", "b"};
  const ImageMetadata metadata = cryptomatte_metadata("CryptoObject", names);
  const std::map<std::string, std::string> found(metadata.begin(), metadata.end());
  CHECK(found.size() == 4);
  CHECK(found.at("cryptomatte/3ae39a5/name") == "CryptoObject");
  CHECK(found.at("cryptomatte/3ae39a5/hash") == "MurmurHash3_32");
  CHECK(found.at("cryptomatte/3ae39a5/conversion") == "uint32_to_float32");
  CHECK(found.at("cryptomatte/3ae39a5/manifest") ==
        "{\"b\":\"95de7e03\",\"lamp \\\"left\\\"\":\"624870d5\"}");
}

TEST_CASE("what covers most of a pixel comes first, and what does not fit is left out") {
  std::vector<MatteCoverage> coverages{{0x3f800000, 0.25f}, {0x40000000, 0.5f}, {0x3f000000, 0.25f}};
  float ranks[8] = {9, 9, 9, 9, 9, 9, 9, 9};
  write_ranks(coverages, ranks);
  const float expected[] = {2, 0.5f, 0.5f, 0.25f, 1, 0.25f, 0, 0};
  CHECK(std::equal(ranks, ranks + 8, expected));
  write_ranks(coverages, std::span(ranks).first(4));
  CHECK(std::equal(ranks, ranks + 4, expected));
}

}  // namespace twinray
