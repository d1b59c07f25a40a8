// SPDX-License-Identifier: Apache-2.0
#include "integrators/denoise/open_image_denoise.h"

#include <cstdlib>
#include <filesystem>

#include "core/error.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

/// Sets variables of the environment for as long as it lives.
class Environment {
 public:
  explicit Environment(const std::string& library, const std::string& mode = "") {
    setenv("TWINRAY_OIDN", library.c_str(), 1);
    setenv("FAKE_DENOISER", mode.c_str(), 1);
  }
  ~Environment() {
    unsetenv("TWINRAY_OIDN");
    unsetenv("FAKE_DENOISER");
  }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;
};

constexpr const char* fake = TWINRAY_FAKE_DENOISER;

const Image noisy = Image(3, 2, {1, 2, -300});
const SurfaceFeatures features{Image(3, 2, {0.1f, 0.2f, 0.3f}), Image(3, 2, {0, 0, 1})};

}  // namespace

TEST_CASE("Open Image Denoise gets the picture, and clean albedo and normal") {
  const Environment environment(fake);
  const auto denoiser = OpenImageDenoise::find();
  REQUIRE(denoiser);
  CHECK(denoiser->version() == "2.4.3");
  const Image image = denoiser->denoised(noisy, denoiser->denoised(features));
  REQUIRE(image.pixels.size() == 6);
  for (const Rgb& pixel : image.pixels) {
    CHECK(pixel.r == Approx(1 + 10 * 0.2));
    CHECK(pixel.g == Approx(2 + 10 * 0.4));
    CHECK(pixel.b == 0);  // -300 + 10 * 0.6 + 100 * 2: light is not negative.
  }
}

TEST_CASE("Open Image Denoise is found somewhere within a folder, by its own name") {
  const TemporaryFolder folder;
  const Environment environment(folder.file(""));
  CHECK_THROWS_WITH(OpenImageDenoise::find(),
                    "TWINRAY_OIDN: there is no libOpenImageDenoise.so.2 in " + folder.file(""));
  std::filesystem::create_directories(folder.file("lib/python3/site-packages"));
  std::filesystem::copy_file(fake, folder.file("lib/python3/site-packages/libOpenImageDenoise.so.2"));
  REQUIRE(OpenImageDenoise::find());
}

TEST_CASE("what is no Open Image Denoise of version 2 is refused by name") {
  {
    const Environment environment("/nowhere/library.so");
    CHECK_THROWS_WITH(
        OpenImageDenoise::find(),
        Catch::Matchers::StartsWith("TWINRAY_OIDN: /nowhere/library.so: cannot open shared object file"));
  }
  {
    const Environment environment("libz.so.1");
    CHECK_THROWS_WITH(OpenImageDenoise::find(),
                      "libz.so.1: this is not Open Image Denoise 2: it has no oidnNewDevice");
  }
  const Environment environment(fake, "old");
  CHECK_THROWS_WITH(OpenImageDenoise::find(),
                    std::string(fake) + ": this is version 1.4.3 of Open Image Denoise; 2 is needed");
}

TEST_CASE("the words of Open Image Denoise's errors are ours") {
  const Environment environment(fake, "broken");
  const auto denoiser = OpenImageDenoise::find();
  REQUIRE(denoiser);
  CHECK_THROWS_WITH(denoiser->denoised(features), "Open Image Denoise: out of memory");
  CHECK_THROWS_WITH(denoiser->denoised(noisy, features), "Open Image Denoise: out of memory");
}

TEST_CASE("Open Image Denoise ends early where it is to stop, which is no error") {
  const Environment environment(fake);
  const auto denoiser = OpenImageDenoise::find();
  REQUIRE(denoiser);
  const auto red = [&](bool is_stopped) {
    return denoiser->denoised(noisy, features, [&] { return is_stopped; }).pixels.front().r;
  };
  CHECK(red(false) == Approx(1 + 10 * 0.1));
  CHECK(red(true) == 0);
}

}  // namespace twinray::test
