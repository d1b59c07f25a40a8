// SPDX-License-Identifier: Apache-2.0
#include "check/ceilings.h"

#include "tests/support/catch.h"

namespace twinray::test {
namespace {

/// A report of one class: so many rays alike, and so many that differ at an edge, as leaks or not.
CrosscheckReport report_of(RayClass ray_class, int identical, int odd, bool is_leak) {
  CrosscheckReport report(2);
  for (int i = 0; i < identical; ++i) report.add_explained(1, ray_class, Difference::identical);
  for (int i = 0; i < odd; ++i)
    report.add({.ray_class = ray_class,
                .number = std::uint64_t(i),
                .engine = 1,
                .difference = Difference::edge,
                .is_leak = is_leak},
               true);
  return report;
}

bool passes(RayClass ray_class, int identical, int odd, bool is_leak) {
  return !passed_ceilings(report_of(ray_class, identical, odd, is_leak)).empty();
}

}  // namespace

TEST_CASE("camera, bounce and random rays may be odd in one of ten thousand, and in no more") {
  for (const RayClass ray_class : {RayClass::camera, RayClass::bounce, RayClass::random}) {
    INFO(ray_class_name(ray_class));
    CHECK_FALSE(passes(ray_class, 19998, 2, false));
    CHECK(passes(ray_class, 19997, 3, false));
    CHECK_FALSE(passes(ray_class, 20, 1, false));  // Rounded up to a whole ray.
    CHECK(passes(ray_class, 20, 2, false));
  }
}

TEST_CASE("no ray may leak through an edge, and of those through vertices one in two hundred") {
  CHECK_FALSE(passes(RayClass::edges, 100, 50, false));
  CHECK(passes(RayClass::edges, 1000000, 1, true));
  CHECK_FALSE(passes(RayClass::vertices, 1990, 10, true));
  CHECK(passes(RayClass::vertices, 1989, 11, true));
  CHECK_FALSE(passes(RayClass::vertices, 0, 1000, false));
}

TEST_CASE("no other class of rays has a ceiling") {
  for (std::size_t i = 0; i < ray_class_count; ++i) {
    const auto ray_class = RayClass(i);
    const bool has_one = ray_class == RayClass::camera || ray_class == RayClass::bounce ||
                         ray_class == RayClass::random || ray_class == RayClass::edges ||
                         ray_class == RayClass::vertices;
    CHECK(ceiling_of(ray_class, 1000).has_value() == has_one);
    CHECK(passes(ray_class, 0, 1000, true) == has_one);
  }
}

TEST_CASE("a rounding is not odd") {
  CrosscheckReport report(2);
  for (int i = 0; i < 1000; ++i) report.add_explained(1, RayClass::camera, Difference::rounding);
  CHECK(passed_ceilings(report).empty());
}

}  // namespace twinray::test
