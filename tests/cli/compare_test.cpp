// SPDX-License-Identifier: Apache-2.0
// How two pictures differ, as a user asks.
#include "cli/compare/command.h"

#include <map>

#include "cli/compare/maps.h"
#include "io/display/color_scale.h"
#include "io/picture/image_file.h"
#include "tests/support/catch.h"
#include "tests/support/html.h"
#include "tests/support/layered_exr.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/text.h"

namespace twinray::test {
namespace {

Image grey(float value) { return Image(40, 30, {value, value, value}); }

/// A reference, and a picture that is too bright in a few pixels.
struct Pair {
  explicit Pair(const std::string& ending)
      : picture(folder.file("a" + ending)), reference(folder.file("b" + ending)) {
    Image image = grey(0.25f);
    write_image(reference, image);
    for (int y = 20; y < 24; ++y)
      for (int x = 33; x < 37; ++x) image.at(x, y) = {0.75f, 0.25f, 0.25f};
    write_image(picture, image);
  }
  ProcessResult compare(const std::string& options = "") const {
    return run_program("compare " + quoted(picture) + " " + quoted(reference) + " " + options);
  }

  TemporaryFolder folder;
  std::string picture, reference;
};

/// The text behind a name at the beginning of a line, with single spaces.
std::string line_of(const std::string& text, const std::string& name) {
  const std::size_t begin = text.find("\n" + name);
  if (begin == text.npos) return "";
  const std::size_t start = text.find_first_not_of(' ', begin + 1 + name.size());
  std::string words;
  for (const char c : text.substr(start, text.find('\n', start) - start))
    if (c != ' ' || words.back() != ' ') words += c;
  return words;
}

}  // namespace

TEST_CASE("compare warns of the parts of a picture that it does not read") {
  const TemporaryFolder folder;
  write_text(folder.file("parts.exr"), exr_of_parts({{"left", 0.25f}, {"right", 4}}));
  write_image(folder.file("one.exr"), Image(1, 1, {0.25f, 0.25f, 0.25f}));
  const ProcessResult result =
      run_program("compare " + quoted(folder.file("parts.exr")) + " " + quoted(folder.file("one.exr")));
  CHECK(result.exit_code == 0);
  CHECK(contains(result.err, "parts.exr: it has 2 parts; the first one, \"left\", is read"));
  CHECK(contains(result.out, "all equal"));
}

TEST_CASE("compare says by how much radiance differs, in which channel and where") {
  const Pair pair(".exr");
  const ProcessResult result = pair.compare();
  CAPTURE(result.err);
  REQUIRE(result.exit_code == 0);
  CHECK(contains(result.out, "40 x 30 pixels of radiance, 16 of them differ"));
  // 16 of 1200 pixels differ by 0.5 in red.
  CHECK(line_of(result.out, "mean squared error") == "0.001111 0.003333 0 0");
  CHECK(line_of(result.out, "its root") == "0.03333 0.05774 0 0");
  CHECK(line_of(result.out, "relative MSE") == "0.01533 0.04598 0 0");
  CHECK(line_of(result.out, "mean signed error") == "+0.002222 +0.006667 +0 +0");
  CHECK(line_of(result.out, "of the mean") == "+0.889 % +2.67 % +0 % +0 %");
  CHECK(line_of(result.out, "largest difference") == "+0.5 in red of pixel 33 20");
  CHECK(contains(result.out, "\nFLIP (HDR) "));
  CHECK_FALSE(contains(result.out, "PSNR"));
  CHECK(line_of(result.out, "8 x 14") == "32 16 0.1091 +0.01519");
  CHECK(line_of(result.out, "16 x") == "");
}

TEST_CASE("compare takes pictures of a display as linear colours, and says their PSNR") {
  const Pair pair(".png");
  const ProcessResult result = pair.compare();
  REQUIRE(result.exit_code == 0);
  CHECK(contains(result.out, "40 x 30 pixels of what a display shows, 16 of them differ"));
  // 0.25 is byte 137 and 0.75 byte 225.
  CHECK(line_of(result.out, "PSNR") == "32.76 dB");
  CHECK(line_of(result.out, "largest difference") == "+0.5028 in red of pixel 33 20");
  CHECK(contains(result.out, "\nFLIP  "));
}

TEST_CASE("a picture of radiance against one of a display is compared as a display shows it") {
  const TemporaryFolder folder;
  write_image(folder.file("a.exr"), grey(7));
  write_image(folder.file("b.png"), grey(1));
  const ProcessResult result =
      run_program("compare " + quoted(folder.file("a.exr")) + " " + quoted(folder.file("b.png")));
  CHECK(contains(result.out, "PSNR                no difference in 8 bits"));
  CHECK(contains(result.out, "FLIP                0.0000 in the mean"));
  CHECK(line_of(result.out, "mean squared error") == "0 0 0 0");
}

TEST_CASE("parts of a frame that are others are not compared, in PNG either") {
  const TemporaryFolder folder;
  const auto render = [&](const std::string& name, const std::string& options) {
    const ProcessResult made =
        run_program(quoted(TWINRAY_SOURCE_DIR "/scenes/box.dae") + " -q -s 1 -r 40 30 " + options + " -o " +
                    quoted(folder.file(name)));
    REQUIRE(made.exit_code == 0);
  };
  render("a.png", "--crop 5 5 20 10");
  render("b.png", "--crop 6 5 20 10");
  render("b.exr", "--crop 6 5 20 10");
  render("whole.png", "-r 20 10");
  const auto compared = [&](const std::string& a, const std::string& b) {
    return run_program("compare -q " + quoted(folder.file(a)) + " " + quoted(folder.file(b)));
  };
  for (const char* other : {"b.png", "b.exr"}) {
    const ProcessResult result = compared("a.png", other);
    CHECK(result.exit_code == 1);
    CHECK(contains(result.err, "a.png shows x 5 to 25, y 5 to 15 of 40 x 30 pixels"));
  }
  CHECK(compared("b.png", "b.exr").exit_code == 0);
  CHECK(compared("a.png", "whole.png").exit_code == 0);  // That says nothing of parts.
}

TEST_CASE("compare says that pictures are equal, and lists no tiles") {
  const Pair pair(".exr");
  const ProcessResult result =
      run_program("compare " + quoted(pair.reference) + " " + quoted(pair.reference) + " --fail-above=0");
  CHECK(result.exit_code == 0);
  CHECK(contains(result.out, "all equal"));
  CHECK(line_of(result.out, "largest difference") == "none");
  CHECK_FALSE(contains(result.out, "Where"));
}

TEST_CASE("a limit that is exceeded gives exit code 1 and says by what") {
  const Pair pair(".exr");
  CHECK(pair.compare("-q --fail-above=0.0012").exit_code == 0);
  CHECK(pair.compare("-q --fail-above=rmse:0.034 --fail-above=relative-mse:0.016").exit_code == 0);
  const ProcessResult above = pair.compare("-q --fail-above 0.0011");
  CHECK(above.exit_code == 1);
  CHECK(above.out.empty());
  CHECK(above.err == "twinray: mse is 0.001111, above 0.0011\n");
  CHECK(pair.compare("-q --fail-above=rmse:1 --fail-above=relative-mse:0.015").err ==
        "twinray: relative-mse is 0.01533, above 0.015\n");
  CHECK(contains(pair.compare("-q --fail-above=flip:1e-6").err, "twinray: flip is 0.0"));
}

TEST_CASE("wrong command lines of compare are refused with what would be valid") {
  const std::map<std::string, std::string> wrong{
      {"", "PICTURE is missing"},
      {"a.exr", "REFERENCE is missing"},
      {"a.exr b.exr --fail-above=x", "--fail-above: \"x\" is not a number from 0 to 1e+30"},
      {"a.exr b.exr --fail-above=ssim:1",
       "--fail-above: there is no \"ssim\"; valid are mse, rmse, relative-mse, flip"},
      {"a.exr b.exr c.exr", "c.exr"}};
  for (const auto& [options, message] : wrong) {
    CAPTURE(options);
    const ProcessResult result = run_program("compare " + options);
    CHECK(result.exit_code == 2);
    CHECK(contains(result.err, message));
    CHECK(contains(result.err, "\nusage: twinray compare PICTURE REFERENCE [options]"));
  }
}

TEST_CASE("pictures that cannot be compared are errors that say why, and no page is written") {
  const Pair pair(".exr");
  Image broken = grey(1);
  broken.at(7, 5).g = std::numeric_limits<float>::quiet_NaN();
  write_image(pair.folder.file("nan.exr"), broken);
  write_image(pair.folder.file("small.exr"), Image(8, 9));
  write_text(pair.folder.file("text.png"), "no picture");
  const std::map<std::string, std::string> wrong{
      {"nan.exr", "nan.exr: pixel 7 5 is not finite: it cannot be compared"},
      {"small.exr", "small.exr 8 x 9: only pictures of one size are compared"},
      {"none.exr", "none.exr: there is no such file"},
      {"text.png", "text.png: cannot be read: it does not begin as a PNG picture does"},
      {"a.dae", "a.dae: not a picture that can be read; valid endings are .exr"}};
  const std::string page = pair.folder.file("page.html");
  for (const auto& [name, message] : wrong) {
    CAPTURE(name);
    const ProcessResult result = run_program("compare " + quoted(pair.picture) + " " +
                                             quoted(pair.folder.file(name)) + " --html=" + quoted(page));
    CHECK(result.exit_code == 1);
    CHECK(contains(result.err, message));
    CHECK(result.out.empty());
    CHECK_FALSE(std::filesystem::exists(page));
  }
}

TEST_CASE("parts of a frame are compared with the same part, and with whole pictures of their size") {
  const TemporaryFolder folder;
  const auto written = [&](const std::string& name, const ImageFrame& frame) {
    write_exr(folder.file(name), Image(4, 3, white), {}, frame);
    return quoted(folder.file(name));
  };
  const std::string part = written("a.exr", {2, 1, 20, 10}), same = written("b.exr", {2, 1, 20, 10}),
                    other = written("c.exr", {5, 1, 20, 10}), whole = written("d.exr", {});
  CHECK(run_program("compare " + part + " " + same).exit_code == 0);
  CHECK(run_program("compare " + part + " " + whole).exit_code == 0);
  const ProcessResult refused = run_program("compare " + part + " " + other);
  CHECK(refused.exit_code == 1);
  CHECK(contains(refused.err, "a.exr shows x 2 to 6, y 1 to 4 of 20 x 10 pixels, "));
  CHECK(contains(refused.err, "c.exr x 5 to 9, y 1 to 4 of 20 x 10 pixels: only pictures of one part of a"));
}

TEST_CASE("the page of a comparison is whole: a slider, two maps, the numbers of the table") {
  const Pair pair(".exr");
  REQUIRE(pair.compare("-q --html=" + quoted(pair.folder.file("page.html"))).exit_code == 0);
  const std::string page = read_text(pair.folder.file("page.html"));
  CHECK(html_fault(page) == "");
  CHECK(html_load(page) == "");
  CHECK(count(page, "data:image/png;base64,") == 5);
  CHECK(count(page, "type=\"range\"") == 1);
  CHECK(contains(page, "<td>mean squared error</td><td>0.001111</td><td>0.003333</td>"));
  CHECK(contains(page, "<td>8 x 14</td><td>32</td><td>16</td><td>0.1091</td>"));
  CHECK(contains(page, "<rect x=\"32\" y=\"16\" width=\"8\" height=\"14\""));
  CHECK(contains(page, "full colour from a difference of 0.106 on"));
}

TEST_CASE("two renders with their variances differ by no more than noise") {
  const TemporaryFolder folder;
  const auto rendered = [&](int seed) {
    const std::string file = folder.file(fmt::format("{}.exr", seed));
    const ProcessResult result =
        run_program(fmt::format("render {} -s 16 -r 40 30 -q --layers=variance,samples --seed {} -o {}",
                                quoted(TWINRAY_SOURCE_DIR "/scenes/spheres.dae"), seed, quoted(file)));
    REQUIRE(result.exit_code == 0);
    return quoted(file);
  };
  const std::string first = rendered(1), second = rendered(2);
  const ProcessResult result = run_program("compare " + first + " " + second);
  CHECK(contains(line_of(result.out, "Welch's test"), "noise explains the difference"));
}

TEST_CASE("pictures with variances are tested for more than noise, tile by tile") {
  constexpr std::size_t pixels = 32 * 16;
  // 9 samples a pixel, with a variance of the mean of 0.01: over 256 pixels the mean is known to 0.00625.
  Channels channels;
  for (const char* name : {"R", "G", "B"}) channels[name].assign(pixels, 1.0f);
  channels["variance.Y"].assign(pixels, 0.01f);
  channels["samples.X"].assign(pixels, 9);
  const TemporaryFolder folder;
  write_text(folder.file("a.exr"), layered_exr(32, 16, channels));
  const auto against = [&](float right) {
    Channels other = channels;
    for (const char* name : {"R", "G", "B"})
      for (std::size_t i = 0; i < pixels; ++i) other[name][i] = i % 32 < 16 ? 1.0f : right;
    write_text(folder.file("b.exr"), layered_exr(32, 16, other));
    const ProcessResult result =
        run_program("compare " + quoted(folder.file("a.exr")) + " " + quoted(folder.file("b.exr")) +
                    " --html=" + quoted(folder.file("page.html")));
    CAPTURE(result.err);
    CHECK(result.exit_code == 0);
    return line_of(result.out, "Welch's test");
  };
  // By 1.13 and 5.66 standard errors; over all tiles the difference is half, its standard error 0.71 of that.
  CHECK(against(1.01f) == "p = 0.59: noise explains the difference");
  CHECK(against(1.05f) == "p = 4.9e-08: 1 of 2 tiles differ by more than noise");
  const std::string page = read_text(folder.file("page.html"));
  CHECK(html_fault(page) == "");
  CHECK(contains(page, "stroke=\"#111\"><title>-4.76 %, p = "));
}

TEST_CASE("pictures without variances, or of single samples, are not tested") {
  const Pair pair(".exr");
  CHECK_FALSE(contains(pair.compare().out, "Welch"));
  Channels channels;
  for (const char* name : {"R", "G", "B", "variance.Y", "samples.X"}) channels[name].assign(16, 1);
  write_text(pair.folder.file("one.exr"), layered_exr(4, 4, channels));
  channels["R"][0] = 9;
  write_text(pair.folder.file("two.exr"), layered_exr(4, 4, channels));
  CHECK_FALSE(contains(run_program("compare " + quoted(pair.folder.file("one.exr")) + " " +
                                   quoted(pair.folder.file("two.exr")))
                           .out,
                       "Welch"));
}

TEST_CASE("maps show where a picture is brighter or darker, and how much people see of it") {
  const Image reference = grey(0.5f);
  Image picture = reference;
  picture.at(1, 0) = {1, 1, 1};
  picture.at(2, 0) = {0, 0, 0};
  CHECK(compare::full_difference(picture, reference) == Approx(0.5));
  const ByteImage map = compare::signed_picture(picture, reference, 0.5);
  const auto bytes = [&](std::size_t x) {
    return std::vector<int>(map.bytes.begin() + 3 * std::ptrdiff_t(x),
                            map.bytes.begin() + 3 * std::ptrdiff_t(x) + 3);
  };
  CHECK(bytes(0) == std::vector<int>{255, 255, 255});
  CHECK(bytes(1) == std::vector<int>{191, 13, 26});
  CHECK(bytes(2) == std::vector<int>{0, 77, 178});
  FlipMap flip(2, 1);
  flip.values = {0, 1};
  const ByteImage shown = compare::flip_picture(flip), scale = compare::flip_scale();
  CHECK(std::equal(shown.bytes.begin(), shown.bytes.begin() + 3, scale.bytes.begin()));
  CHECK(std::equal(shown.bytes.begin() + 3, shown.bytes.end(), scale.bytes.end() - 3));
}

}  // namespace twinray::test
