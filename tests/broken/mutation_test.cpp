// SPDX-License-Identifier: Apache-2.0
// Random damage to a valid scene: loading either succeeds or throws Error. The sanitizers watch the rest.
#include <algorithm>
#include <fstream>
#include <functional>
#include <iterator>
#include <random>

#include "tests/support/catch.h"
#include "tests/support/collada_text.h"
#include "tests/support/obj_text.h"

namespace twinray {
namespace {

std::string read_text(const std::string& path) {
  std::ifstream stream(path);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string read_scene(const std::string& name) {
  return read_text(std::string(TWINRAY_SOURCE_DIR) + "/scenes/" + name);
}

void damage(std::string& text, std::mt19937& random) {
  static const std::string letters = "<>/\"'#= 019.-+ekx&!?[]\n";
  const std::size_t at = random() % text.size();
  const std::size_t length = std::min<std::size_t>(1 + random() % 12, text.size() - at);
  switch (random() % 6) {
    case 0:
      text[at] = letters[random() % letters.size()];
      break;
    case 1:
      text[at] = char(random() % 256);
      break;
    case 2:
      text.erase(at, length);
      break;
    case 3:
      text.insert(at, text.substr(random() % (text.size() - length + 1), length));
      break;
    case 4:
      text.replace(at, length, std::to_string(random()));
      break;
    default:
      if (random() % 8 == 0) text.resize(at + 1);
  }
}

/// Loads damaged copies of a text.
void check_damaged(const std::string& whole, const std::function<void(const std::string&)>& load) {
  REQUIRE(!whole.empty());
  std::mt19937 random(184);
  int loaded = 0, refused = 0;
  for (int round = 0; round < 3000; ++round) {
    std::string text = whole;
    for (unsigned n = 1 + random() % 3; n > 0; --n) damage(text, random);
    INFO("round " << round);
    try {
      load(text);
      ++loaded;
    } catch (const Error&) {
      ++refused;
    }
  }
  CHECK(loaded > 100);
  CHECK(refused > 100);
}

}  // namespace

TEST_CASE("a damaged scene loads or is refused, and never does more") {
  check_damaged(read_scene("lights.dae"), [](const std::string& text) { load_collada(text); });
}

TEST_CASE("a damaged OBJ file, or its materials, loads or is refused, and never does more") {
  const std::string whole = read_text(TWINRAY_SOURCE_DIR "/tests/fuzz/seeds/obj/box");
  check_damaged(whole, [](const std::string& text) {
    const std::size_t end = text.find('\xff');
    const std::string materials = end == text.npos ? "" : text.substr(end + 1);
    test::load_obj_text(text.substr(0, end), {{"a.mtl", materials}});
  });
}

}  // namespace twinray
