// SPDX-License-Identifier: Apache-2.0
// Binary glTF files, whole and damaged.
#include "io/gltf/container.h"

#include <cstring>

#include "tests/io/gltf/file.h"
#include "tests/support/catch.h"

namespace twinray {
namespace {

using nlohmann::json;
using test::gltf_triangle;
using test::GltfFile;

void append_word(std::string& bytes, std::size_t word) {
  for (int i = 0; i < 4; ++i) bytes.push_back(char(word >> (8 * i)));
}

/// The file as .glb: its JSON and, if it is wanted, its buffer as a chunk.
std::string binary(const GltfFile& file) {
  json whole = file.json;
  whole["buffers"] = {{{"byteLength", file.buffer.size()}}};
  std::string text = whole.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  std::string buffer = file.buffer;
  buffer.resize((buffer.size() + 3) / 4 * 4);
  std::string bytes = "glTF";
  append_word(bytes, 2);
  append_word(bytes, 12 + 8 + text.size() + 8 + buffer.size());
  append_word(bytes, text.size());
  bytes += "JSON" + text;
  append_word(bytes, buffer.size());
  return bytes + std::string("BIN\0", 4) + buffer;
}

/// A binary file whose header says another length.
std::string with_length(std::string bytes, std::size_t length) {
  std::string word;
  append_word(word, length);
  return bytes.replace(8, 4, word);
}

}  // namespace

TEST_CASE("gltf: a binary file holds the same scene") {
  const LoadedScene loaded = read_gltf(binary(gltf_triangle()), "test.glb");
  CHECK(loaded.summary.triangles == 1);
  CHECK(loaded.warnings.empty());
}

TEST_CASE("gltf: a binary file that is damaged says where") {
  const std::string bytes = binary(gltf_triangle());
  const std::string start = "test.glb: not a binary glTF file: ";
  CHECK(test::glb_error(bytes.substr(0, 8)) ==
        "test.glb: not a binary glTF file: 8 bytes are less than its header");
  CHECK(test::glb_error(bytes.substr(0, 100)).find("the file ends after 100") != std::string::npos);
  std::string other = bytes;
  other[4] = 1;
  CHECK(test::glb_error(other) == "test.glb: not a binary glTF file: its version is 1; valid is 2");
  other = bytes;
  other[16] = 'X';
  CHECK(test::glb_error(other) == "test.glb: not a binary glTF file: the first chunk must be the JSON one");
  other = bytes;
  std::memset(&other[12], 0xff, 3);
  CHECK(test::glb_error(other).find("the chunk at byte 12 says") != std::string::npos);
  CHECK(test::glb_error("glTX" + bytes.substr(4)) ==
        start + "its first bytes are 67 6c 54 58; valid are 67 6c 54 46, \"glTF\"");
  CHECK(test::glb_error("\x1f\x8b") == start + "2 bytes are less than its header");
  const std::string size = std::to_string(bytes.size());
  CHECK(test::glb_error(with_length(bytes, 19)) ==
        start + "its header says 19 bytes, which are too few for a chunk; the file has " + size);
  const std::string buffer = std::to_string(bytes.size() - 44);
  CHECK(test::glb_error(with_length(bytes, bytes.size() - 4)) ==
        start + "the chunk at byte " + buffer + " says 36 bytes, and the file's header, which says " +
            std::to_string(bytes.size() - 4) + " in all, leaves it 32");
  CHECK(test::glb_error(with_length(bytes.substr(0, bytes.size() - 38), bytes.size() - 38)) ==
        start + "the chunk at byte " + buffer + " is cut: of its header of 8 bytes there are 6");
}

TEST_CASE("gltf: what lies behind the end of a binary file is named, but for what aligns it") {
  const std::string bytes = binary(gltf_triangle());
  const auto warnings = read_gltf(bytes + "abc", "test.glb").warnings;
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].text() == "test.glb: /: the header of this binary file says " +
                                  std::to_string(bytes.size()) + " bytes; the 3 behind them are not read");
  CHECK(read_gltf(with_length(bytes + "abc", bytes.size() + 3), "test.glb").warnings.empty());
}

}  // namespace twinray
