// SPDX-License-Identifier: Apache-2.0
// What a crosscheck says of single rays, with an engine whose answers the test makes up.
#include <cmath>
#include <functional>

#include "check/render_check.h"
#include "tests/support/catch.h"
#include "tests/support/shapes.h"

namespace twinray::test {
namespace {

/// Answers what it is told.
class MadeUp final : public Accelerator {
 public:
  MadeUp(std::shared_ptr<const Geometry> geometry, std::function<Hit(const Ray&)> answer)
      : Accelerator(std::move(geometry)), answer_(std::move(answer)) {}

 private:
  Hit closest(Query query) const noexcept override { return answer_(query.ray); }
  bool any(Query query) const noexcept override { return bool(answer_(query.ray)); }

  std::function<Hit(const Ray&)> answer_;
};

constexpr float pi = 3.14159265f;

/// The unit square around the origin in z = 0, turned by an angle about z.
std::shared_ptr<const Geometry> turned_square(float angle) {
  const float c = 0.70710678f * std::cos(angle), s = 0.70710678f * std::sin(angle);
  Mesh mesh;
  add_triangle(mesh, {c, s, 0}, {-s, c, 0}, {-c, -s, 0});
  add_triangle(mesh, {c, s, 0}, {-c, -s, 0}, {s, -c, 0});
  return share({mesh});
}

Ray from_above(float x, float y) { return {.origin = {x, y, 1}, .direction = {0, 0, -1}}; }

Finding finding(std::uint64_t number, Difference difference, bool is_leak) {
  return {.ray_class = RayClass::random,
          .number = number,
          .engine = 1,
          .difference = difference,
          .is_leak = is_leak};
}

}  // namespace

TEST_CASE("of findings the unexplained ones are kept first, then leaks, then others") {
  CrosscheckReport report(2, 3);
  report.add(finding(1, Difference::tie, false), false);
  report.add(finding(2, Difference::edge, false), true);
  report.add(finding(8, Difference::edge, true), true);
  report.add(finding(7, Difference::edge, true), true);
  report.add(finding(9, Difference::unexplained, false), true);
  const std::vector<Finding>& kept = report.findings(1, RayClass::random);
  REQUIRE(kept.size() == 3);
  CHECK(kept[0].number == 9);
  CHECK(kept[1].number == 7);
  CHECK(kept[2].number == 8);
}

TEST_CASE("a ray that is lost inside of a surface leaks, one that is lost on its outline does not") {
  // Outlines in every direction: some lie so that most of the circle around the ray is inside.
  for (int i = 0; i < 72; ++i) {
    const float angle = float(i) * pi / 36;
    CAPTURE(i);
    const auto geometry = turned_square(angle);
    const auto sound = build_accelerator(Backend::bvh, geometry, {.threads = 1});
    const MadeUp blind(geometry, [](const Ray&) { return Hit{}; });
    const Crosscheck check(geometry, {{"bvh", sound.get()}, {"blind", &blind, false}});
    CrosscheckReport report(2);
    constexpr float inside = 0.5f - 1e-6f;  // A few ulps from the middle of a side.
    const float side = angle + pi / 4;
    check.check(from_above(inside * std::cos(side), inside * std::sin(side)), RayClass::edges, 0, report);
    check.check(from_above(0, 0), RayClass::vertices, 1,
                report);  // On the diagonal: an edge of both triangles.
    CHECK(report.tally(1, RayClass::edges).hit_or_miss == 1);
    CHECK(report.tally(1, RayClass::edges).leaks == 0);
    CHECK(report.tally(1, RayClass::vertices).leaks == 1);
  }
}

TEST_CASE("a pixel with an unexplained difference is red, whatever else it has") {
  const auto geometry = turned_square(0);
  const auto sound = build_accelerator(Backend::bvh, geometry, {.threads = 1});
  // On the diagonal it names the other triangle, which is a tie; elsewhere it says nonsense.
  const MadeUp wrong(geometry, [&](const Ray& ray) {
    Hit hit = sound->closest_hit(ray);
    if (ray.origin.x == 0 && ray.origin.y == 0)
      hit = {.t = hit.t, .u = 0.5f, .v = 0, .primitive = 1 - hit.primitive, .mesh = 0};
    else
      hit.t *= 2;
    return hit;
  });
  const RenderOptions options{.width = 3, .height = 1, .samples = 2, .threads = 1};
  RenderCheck check(geometry, {"bvh", sound.get()}, {"wrong", &wrong, false}, options);
  const RecordedRay explained{.ray = from_above(0, 0)}, unexplained{.ray = from_above(0.1f, 0.2f)};
  check.observe({0, 0, 0}, std::span(&explained, 1));
  check.observe({1, 0, 0}, std::span(&unexplained, 1));
  check.observe({1, 0, 1}, std::span(&explained, 1));
  check.observe({2, 0, 0}, std::span(&explained, 1));
  check.observe({2, 0, 1}, std::span(&unexplained, 1));
  const Image picture = check.picture(Image(3, 1));
  constexpr Rgb red{1, 0, 0}, yellow{1, 1, 0};
  CHECK(picture.at(0, 0) == yellow);
  CHECK(picture.at(1, 0) == red);
  CHECK(picture.at(2, 0) == red);
}

}  // namespace twinray::test
