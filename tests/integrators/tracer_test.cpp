// SPDX-License-Identifier: Apache-2.0
#include "integrators/tracer.h"

#include <algorithm>

#include "integrators/path.h"
#include "integrators/render.h"
#include "tests/support/catch.h"
#include "tests/support/estimate.h"
#include "tests/support/scenes.h"

namespace twinray::test {
namespace {

/// The eight-wide BVH, which notes how many rays it is asked for at a time.
class BatchEngine final : public Accelerator {
 public:
  explicit BatchEngine(const Scene& scene)
      : Accelerator(scene.geometry), inner_(build_accelerator(Backend::bvh, scene.geometry)) {}
  std::size_t largest_batch() const { return largest_batch_; }

 private:
  Hit closest(Query query) const noexcept override { return inner_->closest_hit(query); }
  bool any(Query query) const noexcept override { return inner_->any_hit(query); }
  void closest_batch(std::span<const Ray> rays, Hit* answers) const noexcept override {
    largest_batch_ = std::max(largest_batch_, rays.size());
    inner_->closest_hits(rays, {answers, rays.size()});
  }
  void any_batch(std::span<const Ray> rays, std::uint8_t* answers) const noexcept override {
    inner_->any_hits(rays, {answers, rays.size()});
  }

  std::unique_ptr<Accelerator> inner_;
  mutable std::size_t largest_batch_ = 0;  ///< Of one thread alone.
};

/// The same, one ray at a time whatever it is asked.
class SingleEngine final : public Accelerator {
 public:
  explicit SingleEngine(const Scene& scene)
      : Accelerator(scene.geometry), inner_(build_accelerator(Backend::bvh, scene.geometry)) {}

 private:
  Hit closest(Query query) const noexcept override { return inner_->closest_hit(query); }
  bool any(Query query) const noexcept override { return inner_->any_hit(query); }

  std::unique_ptr<Accelerator> inner_;
};

}  // namespace

TEST_CASE("a picture has the same bits and rays whether its engine traces batches or single rays") {
  const Scene scene = small_room();
  const PathIntegrator path(scene, {.max_depth = 4, .samples_per_light = 2});
  const RenderOptions options{.width = 20, .height = 15, .samples = 8, .seed = 5, .threads = 1};
  const BatchEngine batches(scene);
  const SingleEngine singly(scene);
  const RenderResult expected = render(scene, singly, path, options);
  const RenderResult result = render(scene, batches, path, options);
  CHECK(same_bits(result.film, expected.film));
  CHECK(result.rays == expected.rays);
  CHECK(batches.largest_batch() >= 256);
}

TEST_CASE("a tracer that counts adds up what each ray did, in batches or not") {
  const Scene scene = small_room();
  const BatchEngine batches(scene);
  Tracer together(batches, true), alone(batches, true);
  std::vector<Ray> rays;
  for (int i = 0; i < 20; ++i) rays.push_back({{0, 0, 0}, {float(i) - 10, 3, 5}});
  std::vector<Hit> hits(rays.size());
  together.camera_hits(rays, hits);
  for (std::size_t i = 0; i < rays.size(); ++i) CHECK(alone.camera_hit(rays[i]) == hits[i]);
  CHECK(together.counts() == alone.counts());
  CHECK(together.counts().queries.nodes > 0);
  CHECK(batches.largest_batch() == 0);
}

}  // namespace twinray::test
