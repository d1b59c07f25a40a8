// SPDX-License-Identifier: Apache-2.0
#include "cli/statistics_report.h"

#include <limits>

#include "tests/support/catch.h"
#include "tests/support/text.h"

namespace twinray::test {
namespace {

RenderResult result_of(const RayCounts& rays, double seconds) {
  return {{.film = Film(8, 8, {0, 0, 8, 8}), .rays = rays, .seconds = seconds}};
}

}  // namespace

TEST_CASE("speed and counts are those of all rays") {
  RayCounts rays{.camera = 1000000, .shadow = 2000000, .bounce = 3000000};
  rays.queries = {.nodes = 12000000, .boxes = 24000000, .leaves = 3000000, .primitives = 9000000};
  RenderArguments arguments;
  AccelStats accel;
  accel.tree.emplace();
  arguments.render.counting = true;
  const std::string text = statistics_text(arguments, accel, result_of(rays, 2));
  CHECK(contains(text, "6000000 (1000000 camera, 2000000 shadow, 3000000 bounce)\n"));
  CHECK(contains(text, " 3.0000 million rays per second\n"));
  CHECK(contains(text, "2.0000 nodes, 4.0000 boxes, 0.5000 leaves, 1.5000 intersection tests"));
  accel.tree.reset();
  CHECK(contains(statistics_text(arguments, accel, result_of(rays, 2)),
                 "Per ray        0.5000 leaves, 1.5000 intersection tests"));
  arguments.render.counting = false;
  CHECK_FALSE(contains(statistics_text(arguments, accel, result_of(rays, 2)), "leaves"));
}

TEST_CASE("nothing traced in no time has no speed") {
  RenderArguments arguments;
  arguments.render.counting = true;
  const std::string text = statistics_text(arguments, {}, result_of({}, 0));
  CHECK(contains(text, " 0.0000 million rays per second\n"));
  CHECK(contains(text, "0.0000 leaves, 0.0000 intersection tests"));
}

TEST_CASE("a rejected sample can be replayed, or its pixel rendered alone") {
  Film film(20, 10, {2, 1, 18, 9});
  CHECK(rejection_text(film, {}).empty());
  const float nan = std::numeric_limits<float>::quiet_NaN();
  film.add(7, 4, 9, {nan, 0, 0});
  film.add(5, 4, 3, {0, nan, 0});
  film.add(3, 6, 1, {0, 0, nan});
  const std::string text = rejection_text(film, {});
  CHECK(contains(text, "3 samples were rejected"));
  CHECK(contains(text, "pixel 5 4, sample 3;"));
  CHECK(contains(text, "; --replay 5 4 3 shows its path"));
  RenderArguments normals;
  normals.integrator = IntegratorKind::normals;
  CHECK(contains(rejection_text(film, normals), "; --crop 5 4 1 1 renders it alone"));
  normals.load.interpretation = Interpretation::cs184;
  CHECK(contains(rejection_text(film, normals),
                 "; -p 5 5 1 1 renders it alone"));  // 5 from the bottom of 10 rows
}

}  // namespace twinray::test
