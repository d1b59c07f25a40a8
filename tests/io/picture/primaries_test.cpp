// SPDX-License-Identifier: Apache-2.0
#include "io/picture/primaries.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string>

#include "io/picture/image_file.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

/// Replaces what an EXR says of its red, green, blue and white: x and y of each.
void set_chromaticities(const std::string& path, const std::array<float, 8>& numbers) {
  std::string text = read_text(path);
  const std::string attribute("chromaticities\0chromaticities\0\x20\0\0\0", 34);
  const std::size_t at = text.find(attribute);
  REQUIRE(at != std::string::npos);
  std::memcpy(text.data() + at + attribute.size(), numbers.data(), sizeof numbers);
  write_text(path, text);
}

}  // namespace

TEST_CASE("colors of an EXR by other primaries are brought to ours, numbers are not") {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.exr");
  const auto read_by = [&](const std::array<float, 8>& primaries, const Rgb& color,
                           PictureRole role = PictureRole::color) {
    write_exr(path, Image(1, 1, color));
    set_chromaticities(path, primaries);
    return read_image(path, {role, PictureChannels::color}).pixels[0];
  };
  constexpr std::array ours{0.64f, 0.33f, 0.3f, 0.6f, 0.15f, 0.06f, 0.3127f, 0.329f},
      rec2020{0.708f, 0.292f, 0.17f, 0.797f, 0.131f, 0.046f, 0.3127f, 0.329f},
      acescg{0.713f, 0.293f, 0.165f, 0.83f, 0.128f, 0.044f, 0.32168f, 0.33767f};
  const Rgb color{0.3f, 0.5f, 0.7f};
  const auto check_near = [](const Rgb& a, const Rgb& b) {
    CAPTURE(a.r, a.g, a.b, b.r, b.g, b.b);
    const Rgb difference = a - b;
    CHECK(std::max({std::fabs(difference.r), std::fabs(difference.g), std::fabs(difference.b)}) < 1e-3f);
  };
  CHECK(read_by(ours, color) == color);
  check_near(read_by(rec2020, color), {0.1533f, 0.5232f, 0.7274f});
  check_near(read_by(acescg, color), {0.1423f, 0.5239f, 0.7354f});
  CHECK(read_by(rec2020, color, PictureRole::data) == color);
  CHECK(read_by(rec2020, {1, 1, 1}) == Rgb{1, 1, 1});
  CHECK(read_by(rec2020, {0, 1, 0}).r == 0);  // Ours cannot say it.
  CHECK(read_by(rec2020, {-1, 1, 0}).r < 0);
  CHECK(read_by({}, color) == color);  // No primaries at all.
}

}  // namespace twinray::test
