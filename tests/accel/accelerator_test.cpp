// SPDX-License-Identifier: Apache-2.0
// What the interface itself promises, whatever the engine.
#include "accel/accelerator.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>

#include "tests/support/catch.h"
#include "tests/support/flush_denormals.h"
#include "tests/support/shapes.h"

using namespace twinray;
using namespace twinray::test;

namespace {

/// All engines of this build over a geometry, both trees of ours among them.
std::vector<std::unique_ptr<Accelerator>> all_engines(const std::shared_ptr<const Geometry>& geometry) {
  std::vector<std::unique_ptr<Accelerator>> all;
  for (const Backend backend : available_backends()) all.push_back(build_accelerator(backend, geometry));
  all.push_back(build_accelerator(Backend::bvh, geometry, {.bvh_width = 2}));
  for (const std::string& simd : available_instruction_sets())
    all.push_back(build_accelerator(Backend::bvh, geometry, {.simd = simd}));
  return all;
}

struct Answers {
  std::vector<Hit> hits, batch;
  std::vector<bool> blocked;
  std::vector<std::uint8_t> blocked_batch;
  friend bool operator==(const Answers&, const Answers&) = default;
};

Answers answers_of(const Accelerator& engine, const std::vector<Ray>& rays) {
  Answers answers;
  for (const Ray& ray : rays) {
    answers.hits.push_back(engine.closest_hit(ray));
    answers.blocked.push_back(engine.any_hit(ray));
  }
  answers.batch.resize(rays.size());
  answers.blocked_batch.resize(rays.size());
  engine.closest_hits(rays, answers.batch);
  engine.any_hits(rays, answers.blocked_batch);
  return answers;
}

#ifndef NDEBUG
/// How a child process ends that does `work`.
template <typename Work>
int signal_of(const Work& work) {
  const pid_t child = fork();
  if (child == 0) {
    close(STDERR_FILENO);
    work();
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
}
#endif

}  // namespace

TEST_CASE("an accelerator knows its geometry, its box and how many primitives there are") {
  const auto geometry = share({soup(30, 0.3f, 1), random_spheres(4, 0.2f, 2)});
  for (const auto& engine : all_engines(geometry)) {
    CHECK(&engine->geometry() == geometry.get());
    CHECK(engine->bounds() == geometry->bounds());
    CHECK(engine->stats().primitives == 34);
  }
}

TEST_CASE("what an engine cannot know of its tree is absent") {
  const auto geometry = share({soup(30, 0.3f, 1)});
  CHECK(!build_accelerator(Backend::brute_force, geometry)->stats().tree);
  for (const int width : {2, 8}) {
    const auto engine = build_accelerator(Backend::bvh, geometry, {.bvh_width = width});
    REQUIRE(engine->stats().tree);
    CHECK(engine->stats().tree->leaves > 1);
    const auto empty = build_accelerator(Backend::bvh, share({}), {.bvh_width = width});
    REQUIRE(empty->stats().tree);
    CHECK(empty->stats().tree->nodes == 0);
  }
  for (const Backend backend : available_backends())
    if (backend == Backend::embree || backend == Backend::embree_native)
      CHECK(!build_accelerator(backend, geometry)->stats().tree);
}

TEST_CASE("a query that counts has the answer of one that does not") {
  const auto geometry = share({soup(300, 0.3f, 1), random_spheres(10, 0.2f, 2)});
  const std::vector<Ray> rays = random_rays(200, geometry->bounds(), 3);
  for (const auto& engine : all_engines(geometry)) {
    QueryCounts counts;
    for (const Ray& ray : rays) {
      CHECK(engine->closest_hit({ray, &counts}) == engine->closest_hit(ray));
      CHECK(engine->any_hit({ray, &counts}) == engine->any_hit(ray));
    }
  }
}

// Without assertions the lesser length counts; with them the program stops.
TEST_CASE("a batch whose spans differ in length writes behind none of them") {
  const auto geometry = share({soup(300, 0.3f, 1)});
  const std::vector<Ray> rays = random_rays(20, geometry->bounds(), 3);
  for (const auto& engine : all_engines(geometry)) {
    std::vector<Hit> hits(rays.size(), Hit{.t = -1});
    std::vector<std::uint8_t> blocked(rays.size(), 7);
#ifdef NDEBUG
    engine->closest_hits(rays, std::span(hits).first(12));
    engine->any_hits(rays, std::span(blocked).first(12));
    engine->closest_hits(std::span(rays).first(5), hits);
    engine->any_hits(std::span(rays).first(5), blocked);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      CHECK(hits[i] == (i < 12 ? engine->closest_hit(rays[i]) : Hit{.t = -1}));
      CHECK(blocked[i] == (i < 12 ? std::uint8_t(engine->any_hit(rays[i])) : 7));
    }
#else
    CHECK(signal_of([&] { engine->closest_hits(rays, std::span(hits).first(12)); }) == SIGABRT);
    CHECK(signal_of([&] { engine->any_hits(rays, std::span(blocked).first(12)); }) == SIGABRT);
#endif
  }
}

TEST_CASE("a caller who has switched denormal numbers off gets the same answers, and keeps his mode") {
  // So small that the products of the edge functions, and the distances, are denormal numbers.
  Mesh mesh = soup(300, 0.3f, 5);
  for (Vec3& p : mesh.positions) p = p * 0x1p-120f;
  const auto geometry = share({mesh});
  std::vector<Ray> rays = random_rays(500, geometry->bounds(), 6);
  for (Ray& ray : rays) ray.t_min = 0x1p-140f;
  // Embree 4's own triangles are never hit at this size; the canonical ones are.
  const Answers truth = answers_of(*build_accelerator(Backend::brute_force, geometry), rays);
  CHECK(std::count_if(truth.hits.begin(), truth.hits.end(), [](const Hit& hit) { return bool(hit); }) > 100);
  for (const auto& engine : all_engines(geometry)) {
    const Answers expected = answers_of(*engine, rays);
    const FlushDenormals flush;
    CHECK(answers_of(*engine, rays) == expected);
    CHECK(FlushDenormals::are_flushed());
  }
}
