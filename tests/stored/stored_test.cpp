// SPDX-License-Identifier: Apache-2.0
// Pictures of our scenes beside stored ones of 16,384 samples (render.sh): pixel by pixel, or tile by tile,
// by Welch's test with Sidak's correction. It passes whatever the random numbers are, and fails where the
// light is another. Surfaces are regularized: light that few samples find has no normal distribution.
#include <fmt/format.h>

#include "check/bias.h"
#include "core/scene_textures.h"
#include "integrators/path.h"
#include "integrators/render.h"
#include "io/picture/image_file.h"
#include "io/scene_file.h"
#include "tests/support/catch.h"
#include "tests/support/statistics.h"

namespace twinray::test {
namespace {

struct StoredScene {
  std::string file;
  int tile;  ///< The side of the tiles whose means are compared: a pixel where no light is rare.
};
const std::vector<StoredScene> scenes = {{"box.dae", 1},         {"lights.dae", 1}, {"spheres.dae", 1},
                                         {"still-life.pbrt", 3}, {"pawns.pbrt", 1}, {"layers.pbrt", 3},
                                         {"materials.pbrt", 3},  {"table.gltf", 3}};
constexpr int width = 24, height = 18;
/// Of a pixel's mean, what is not looked for: a part of the frame in which no sample fell.
constexpr double tolerance = 0.001;

/// Means, and how well they are known.
struct StoredPicture {
  explicit StoredPicture(const std::string& path)
      : mean(read_image(path)),
        variance(read_channel(path, "variance.Y")),
        samples(read_channel(path, "samples.X")) {
    REQUIRE(mean.width == width);
    REQUIRE(mean.height == height);
    REQUIRE(variance.size() == mean.pixels.size());
    REQUIRE(samples.size() == mean.pixels.size());
  }
  MeanEstimate pixel(std::size_t i) const {
    return {double(luminance(mean.pixels[i])), double(variance[i]), double(samples[i]) - 1};
  }

  Image mean;
  std::vector<float> variance, samples;
};

/// Pictures of the default settings, each of a seed of its own.
PictureMoments pictures_of(const std::string& file) {
  const LoadedScene loaded = load_scene(TWINRAY_SOURCE_DIR "/scenes/" + file);
  Scene scene = loaded.scene;
  set_filter(scene.textures, TextureFilter::stochastic);
  scene.camera = fit_frame(scene.camera, width, height);
  const auto accelerator = build_accelerator(Backend::bvh, scene.geometry);
  const PathIntegrator path(scene, {.max_depth = 8, .regularize = true});
  PictureMoments moments;
  for (std::uint64_t seed = 1; seed <= 64; ++seed)
    moments.add(mean_image(
        render(scene, *accelerator, path, {.width = width, .height = height, .samples = 32, .seed = seed})
            .film));
  return moments;
}

BiasTest beside(const PictureMoments& moments, const StoredPicture& stored, int tile, double factor = 1) {
  const auto scaled = [&](std::size_t i) {
    const MeanEstimate pixel = stored.pixel(i);
    const double mean = pixel.mean * factor, rounding = mean * tolerance;
    return MeanEstimate{mean, pixel.variance * factor * factor + rounding * rounding, pixel.freedom};
  };
  const PixelMask all(std::size_t(width * height), 1);
  return test_means([&](std::size_t i) { return moments.pixel(i); }, scaled, {width, height, all}, tile);
}

}  // namespace

TEST_CASE("no pixel of our scenes differs from its stored mean by more than noise") {
  for (const auto& [file, tile] : scenes) {
    const StoredPicture stored(
        fmt::format(TWINRAY_SOURCE_DIR "/tests/stored/{}.exr", file.substr(0, file.find('.'))));
    const PictureMoments moments = pictures_of(file);
    const BiasTest test = beside(moments, stored, tile);
    const double seen = seen_error(std::sqrt(test.whole.picture.variance + test.whole.converged.variance),
                                   sidak_level(scenes.size())) /
                        test.whole.converged.mean;
    INFO(file << ": p " << test.p_value << ", of the whole " << test.whole.test.p_value
              << "; sees a mean that is " << 100 * seen << " % off");
    CHECK(test.p_value > sidak_level(scenes.size()));
    CHECK(seen < 0.02);
    CHECK(beside(moments, stored, tile, 1.02).p_value < sidak_level(scenes.size()));
  }
}

}  // namespace twinray::test
