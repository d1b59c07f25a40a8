// SPDX-License-Identifier: Apache-2.0
#include "check/render_check.h"

#include "integrators/path.h"
#include "tests/support/catch.h"
#include "tests/support/estimate.h"
#include "tests/support/scenes.h"
#include "tests/support/wrong_engine.h"

namespace twinray::test {
namespace {

constexpr RayClass classes[] = {RayClass::camera, RayClass::shadow, RayClass::bounce};

RenderOptions small_frame(int threads) {
  return {.width = 24, .height = 18, .samples = 3, .seed = 5, .threads = threads};
}

struct Checked {
  RenderResult result;
  CrosscheckReport report;
  Image picture;
};

/// A path-traced picture by the bvh, each ray checked with another engine.
Checked render_checked(const Scene& scene, const Accelerator& other, bool is_canonical, int threads) {
  const auto bvh = build_accelerator(Backend::bvh, scene.geometry);
  RenderOptions options = small_frame(threads);
  RenderCheck check(scene.geometry, {"bvh", bvh.get()}, {"other", &other, is_canonical}, options, 4);
  options.observe = [&](const PixelSample& sample, std::span<const RecordedRay> rays) {
    check.observe(sample, rays);
  };
  RenderResult result = render(scene, *bvh, PathIntegrator(scene, {}), options);
  Image picture = check.picture(mean_image(result.film));
  return {std::move(result), check.report(), std::move(picture)};
}

int count_pixels(const Image& image, const Rgb& color) {
  return int(std::count(image.pixels.begin(), image.pixels.end(), color));
}

constexpr Rgb red{1, 0, 0}, yellow{1, 1, 0};

}  // namespace

TEST_CASE("a checked render has the bits of an ordinary one, and every ray of it is asked of both engines") {
  const Scene scene = small_room();
  const RenderResult plain = render_with(scene, PathIntegrator(scene, {}), small_frame(2));
  for (const Backend backend : available_backends()) {
    if (backend == Backend::embree_native) continue;
    INFO(backend_name(backend));
    const auto other = build_accelerator(backend, scene.geometry, {.bvh_width = 2});
    const Checked checked = render_checked(scene, *other, true, 2);
    CHECK(same_bits(checked.result.film, plain.film));
    CHECK(checked.result.rays == plain.rays);
    const std::uint64_t counts[] = {plain.rays.camera, plain.rays.shadow, plain.rays.bounce};
    for (int i = 0; i < 3; ++i) {
      const Tally& tally = checked.report.tally(1, classes[i]);
      CHECK(tally.rays == counts[i]);
      CHECK(tally.count(Difference::identical) == counts[i]);
    }
    CHECK(count_pixels(checked.picture, red) + count_pixels(checked.picture, yellow) == 0);
  }
}

TEST_CASE("a checked render finds each planted defect, names its samples and marks their pixels") {
  const Scene scene = small_room();
  // Those that a camera, shadow or bounce ray of this room can show.
  for (const Defect defect : {Defect::skipped_child, Defect::right_never_looked_at, Defect::t_max_lags,
                              Defect::last_primitive_lost}) {
    INFO(defect_name(defect));
    const auto wrong = build_wrong_engine(scene.geometry, defect);
    const Checked checked = render_checked(scene, *wrong, true, 2);
    CHECK(checked.report.unexplained() > 0);
    CHECK(count_pixels(checked.picture, red) > 0);
    for (const RayClass ray_class : classes)
      for (const Finding& finding : checked.report.findings(1, ray_class)) {
        CHECK(same_bits(ask(*wrong, finding.ray), finding.found));
        CHECK_FALSE(same_bits(finding.reference, finding.found));
        REQUIRE(finding.is_judged);
        CHECK(bool(finding.exact) == bool(finding.reference.closest));
        const RenderCheck numbers(scene.geometry, {"a", wrong.get()}, {"b", wrong.get()}, small_frame(1));
        const PixelSample sample = numbers.sample_of(finding);
        REQUIRE(sample.x < 24);
        REQUIRE(sample.y < 18);
        CHECK(sample.index < 3);
        CHECK(checked.picture.at(sample.x, sample.y) == red);
      }
  }
}

TEST_CASE("what a check reports does not depend on the number of threads") {
  const Scene scene = small_room();
  const auto wrong = build_wrong_engine(scene.geometry, Defect::skipped_child);
  const Checked one = render_checked(scene, *wrong, true, 1), seven = render_checked(scene, *wrong, true, 7);
  CHECK(one.picture.pixels == seven.picture.pixels);
  for (const RayClass ray_class : classes) {
    CHECK(one.report.tally(1, ray_class) == seven.report.tally(1, ray_class));
    const auto &a = one.report.findings(1, ray_class), &b = seven.report.findings(1, ray_class);
    REQUIRE(a.size() == b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      CHECK(a[i].number == b[i].number);
      CHECK(a[i].ray.direction == b[i].ray.direction);
    }
  }
}

#ifdef TWINRAY_WITH_EMBREE
TEST_CASE("differences of embree-native are judged") {
  const Scene scene = small_room();
  const auto witness = build_accelerator(Backend::embree_native, scene.geometry);
  const Checked checked = render_checked(scene, *witness, false, 2);
  CHECK(checked.report.unexplained() == 0);
  CHECK(checked.report.tally(1, RayClass::camera).count(Difference::rounding) > 0);
  CHECK(count_pixels(checked.picture, red) == 0);
}
#endif

TEST_CASE("a window of a checked picture is marked by its own pixels") {
  const Scene scene = small_room();
  const auto bvh = build_accelerator(Backend::bvh, scene.geometry);
  const auto wrong = build_wrong_engine(scene.geometry, Defect::t_max_lags);
  const Checked whole = render_checked(scene, *wrong, true, 1);
  RenderOptions options = small_frame(2);
  options.window = PixelRect{5, 3, 20, 15};
  RenderCheck check(scene.geometry, {"bvh", bvh.get()}, {"wrong", wrong.get()}, options);
  options.observe = [&](const PixelSample& sample, std::span<const RecordedRay> rays) {
    check.observe(sample, rays);
  };
  const RenderResult part = render(scene, *bvh, PathIntegrator(scene, {}), options);
  const Image picture = check.picture(mean_image(part.film));
  REQUIRE(picture.width == 15);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) CHECK(picture.at(x, y) == whole.picture.at(x + 5, y + 3));
}

}  // namespace twinray::test
