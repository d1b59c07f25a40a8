// SPDX-License-Identifier: Apache-2.0
#include "accel/canonical/triangle.h"

#include "check/judge.h"
#include "tests/support/catch.h"
#include "tests/support/hostile.h"
#include "tests/support/meshes.h"
#include "tests/support/trace.h"

namespace twinray {
namespace {

using test::Corners;
using test::HostilePair;
using test::Random;

// In units of u = 2^-24 of the largest component of vertex - origin. Each sheared vertex is off by up to 6 in
// its two components, 8.49 in all; so are the edges, and so is the point of the weights beside the ray.
constexpr double decision_margin = 8.5;
// That, seen along the ray (over the cosine), and 7 for the depths (3 each, sqrt(3) for their axis) and t.
constexpr double t_margin_lateral = 8.5, t_margin = 7;

TriangleJudgement judge(const HostilePair& pair) {
  return judge_triangle(pair.ray, pair.corners[0], pair.corners[1], pair.corners[2]);
}
std::optional<ShapeHit> trace(const HostilePair& pair) {
  return test::trace_triangle(pair.ray, pair.corners[0], pair.corners[1], pair.corners[2]);
}

/// The largest component of vertex - origin.
double scale_of(const HostilePair& pair) {
  double scale = 0;
  for (const Vec3& p : pair.corners)
    for (int k = 0; k < 3; ++k) scale = std::max(scale, std::fabs(double(p[k]) - pair.ray.origin[k]));
  return scale;
}

double t_bound(const TriangleJudgement& judgement, const Ray& ray) {
  const double d =
      std::sqrt(double(ray.direction.x) * ray.direction.x + double(ray.direction.y) * ray.direction.y +
                double(ray.direction.z) * ray.direction.z);
  return judgement.t.error + (t_margin_lateral / judgement.cosine + t_margin) * judgement.scale * 0x1p-24 / d;
}

using Wide = std::array<double, 3>;
Wide wide(const Vec3& a, const Vec3& b) { return {double(a.x) - b.x, double(a.y) - b.y, double(a.z) - b.z}; }
Wide outer(const Wide& a, const Wide& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double inner(const Wide& a, const Wide& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// How far, seen along the ray, the apex stands from the line of the edge p, q: negative where the triangle
/// shows its back.
double visible_height(const Ray& ray, const Vec3& p, const Vec3& q, const Vec3& apex) {
  const Wide d = wide(ray.direction, {}), beside = outer(d, wide(q, p));
  return inner(beside, wide(apex, p)) / std::sqrt(inner(beside, beside));
}

std::string describe(const HostilePair& pair) {
  std::string text;
  const auto add = [&](const Vec3& p) {
    char line[128];
    std::snprintf(line, sizeof line, "{%af, %af, %af}, ", p.x, p.y, p.z);
    text += line;
  };
  add(pair.ray.origin);
  add(pair.ray.direction);
  for (const Vec3& p : pair.corners) add(p);
  return text;
}

/// A fan of triangles about a hub, hardly bent, and a ray at one of its spokes, the hub among them.
struct Fan {
  std::vector<Vec3> positions;
  Ray ray;

  explicit Fan(Random& random) {
    const Vec3 shift = random.in_cube(std::ldexp(1.0f, random.between(-4, 8)));
    const float size = std::ldexp(1.0f, random.between(-8, 8));
    positions.push_back(shift);
    for (const auto& [x, y] :
         {std::pair{1.0f, 0.1f}, {0.3f, 0.9f}, {-0.8f, 0.6f}, {-0.7f, -0.7f}, {0.4f, -1.0f}})
      positions.push_back(shift + Vec3{x, y, random.uniform(-0.1f, 0.1f)} * size);
    const Vec3 spoke = positions[std::size_t(random.between(1, 5))] - positions[0];
    const float along = random.below(3) == 0 ? 0 : 0.5f * random.unit();
    const Vec3 target = test::nudged(random, positions[0] + spoke * along, random.below(3));
    const Vec3 away{random.uniform(-0.5f, 0.5f), random.uniform(-0.5f, 0.5f), random.below(2) ? 1.0f : -1.0f};
    ray.origin = target + away * std::ldexp(size, random.between(-2, 8));
    ray.direction = target - ray.origin;
  }
};

}  // namespace

TEST_CASE("a ray clearly through a triangle hits it, one clearly beside it does not") {
  Random random(31);
  int hits = 0, misses = 0, close = 0;
  const double largest_t = 0x1p127;  // beyond, t is not a float
  for (int i = 0; i < 150000; ++i) {
    const HostilePair pair = test::hostile_pair(random);
    const TriangleJudgement truth = judge(pair);
    if (truth.position == LinePosition::edge_on) continue;
    const double bound = t_bound(truth, pair.ray);
    const auto hit = trace(pair);
    const bool is_inside =
        truth.edge_margin_ulps() > decision_margin && truth.t.value > bound && truth.t.value < largest_t;
    const bool is_outside = truth.edge_margin_ulps() < -decision_margin || truth.t.value < -bound;
    hits += is_inside;
    misses += is_outside;
    close += !is_inside && !is_outside;
    if ((is_inside && !hit) || (is_outside && hit)) FAIL("draw " << i << ": " << describe(pair));
    if (!hit || hit->t == 0) continue;
    if (std::fabs(hit->t - truth.t.value) > bound) FAIL("t of draw " << i << ": " << describe(pair));
  }
  CHECK(hits > 20000);
  CHECK(misses > 10000);
  CHECK(close > 50000);
}

TEST_CASE("a hit's weights lie in the triangle, and their point beside the ray by rounding alone") {
  Random random(32);
  for (int i = 0; i < 200000; ++i) {
    const HostilePair pair = test::hostile_pair(random);
    const auto hit = trace(pair);
    if (!hit) continue;
    const auto& [a, b, c] = pair.corners;
    const double u = hit->u, v = hit->v, w = 1 - u - v;
    double p[3], d[3], along = 0, squared = 0, beside = 0;
    for (int k = 0; k < 3; ++k) {
      d[k] = pair.ray.direction[k];
      p[k] = w * a[k] + u * b[k] + v * c[k] - pair.ray.origin[k];
      along += p[k] * d[k];
      squared += d[k] * d[k];
    }
    for (int k = 0; k < 3; ++k) beside += std::pow(p[k] - along / squared * d[k], 2);
    // 8.49 as above, and the rounding of the two weights to float: one each.
    const double bound = 10.5 * scale_of(pair) * 0x1p-24;
    INFO("draw " << i << ": " << describe(pair));
    CHECK((u >= 0 && v >= 0 && u + v <= 1 + 0x1p-23));
    CHECK(std::sqrt(beside) <= bound);
  }
}

TEST_CASE("the interval is closed: a ray that ends or starts at its hit finds it again") {
  Random random(33);
  int tested = 0;
  for (int i = 0; i < 400000; ++i) {
    HostilePair pair = test::hostile_pair(random);
    const auto hit = trace(pair);
    if (!hit || hit->t < 0x1p-100f || hit->t > 0x1p100f) continue;
    ++tested;
    INFO("draw " << i << ": " << describe(pair));
    pair.ray.t_max = hit->t;
    const auto up_to = trace(pair);
    pair.ray.t_min = hit->t;
    const auto exactly = trace(pair);
    pair.ray.t_max = Aabb::infinity;
    const auto from = trace(pair);
    REQUIRE((up_to && exactly && from));
    CHECK((up_to->t == hit->t && exactly->t == hit->t && from->t == hit->t));
    pair.ray.t_min = std::nextafter(hit->t, Aabb::infinity);
    CHECK_FALSE(trace(pair).has_value());
    pair.ray.t_min = 0;
    pair.ray.t_max = std::nextafter(hit->t, 0.0f);
    CHECK_FALSE(trace(pair).has_value());
  }
  CHECK(tested > 100000);
}

TEST_CASE("the order of the vertices changes neither hit nor t") {
  Random random(34);
  for (int i = 0; i < 200000; ++i) {
    const HostilePair pair = test::hostile_pair(random);
    const auto& [a, b, c] = pair.corners;
    const auto hit = trace(pair), turned = test::trace_triangle(pair.ray, b, c, a),
               mirrored = test::trace_triangle(pair.ray, a, c, b);
    INFO("draw " << i << ": " << describe(pair));
    REQUIRE(hit.has_value() == turned.has_value());
    REQUIRE(hit.has_value() == mirrored.has_value());
    // t is rounded once, from a sum of doubles that are up to scale / |direction|.
    const double bound = hit ? hit->t * 0x1p-23 + scale_of(pair) * 0x1p-48 / max_abs(pair.ray.direction) : 0;
    if (hit) CHECK(std::fabs(hit->t - turned->t) <= bound);
    if (hit) CHECK(std::fabs(hit->t - mirrored->t) <= bound);
  }
}

TEST_CASE("no ray passes between two triangles that share an edge") {
  Random random(35);
  int crossed = 0;
  for (int i = 0; i < 60000; ++i) {
    HostilePair pair{.corners = test::hostile_triangle(random)};
    const auto& [a, b, c] = pair.corners;
    const Vec3 d = b + c - a;  // the neighbour over the edge b, c: the parallelogram's other half
    const Vec3 target = test::nudged(random, b + (c - b) * random.uniform(0.1f, 0.9f), random.below(3));
    pair.ray.origin = test::hostile_origin(random, pair.corners, target);
    pair.ray.direction = test::hostile_direction(random, pair.ray.origin, target);
    const TriangleJudgement first = judge(pair), second = judge_triangle(pair.ray, c, b, d);
    if (!(first.crosses() || second.crosses())) continue;
    // Beyond a silhouette both may be missed: the two must clearly lie on the two sides of their edge.
    const double unit = first.scale * 0x1p-24, least = 4 * decision_margin * unit;
    const double height = visible_height(pair.ray, b, c, a), other = visible_height(pair.ray, b, c, d);
    if (!(height * other < 0 && std::fabs(height) > least && std::fabs(other) > least)) continue;
    if (first.t.value > 0x1p127 || first.t.value < t_bound(first, pair.ray) ||
        second.t.value < t_bound(second, pair.ray))
      continue;
    // Through the shared edge, or within rounding of it, but away from its ends.
    if (std::fabs(first.edge_margin_ulps()) > 2 * decision_margin) continue;
    if (std::fabs(first.weights[0]) > 0.05 || std::min(first.weights[1], first.weights[2]) < 0.1) continue;
    const double visible_edge =
        std::min(std::fabs(visible_height(pair.ray, a, b, c)), std::fabs(visible_height(pair.ray, a, c, b)));
    if (visible_edge * 0.05 < least) continue;
    ++crossed;
    if (!trace(pair) && !test::trace_triangle(pair.ray, c, b, d))
      FAIL("draw " << i << ": " << describe(pair));
  }
  CHECK(crossed > 5000);
}

TEST_CASE("no ray passes through the hub or a spoke of a fan") {
  Random random(36);
  for (int i = 0; i < 40000; ++i) {
    const Fan fan(random);
    int hits = 0, truths = 0;
    for (int k = 1; k <= 5; ++k) {
      const Vec3 &p = fan.positions[0], &q = fan.positions[k], &r = fan.positions[k % 5 + 1];
      hits += test::trace_triangle(fan.ray, p, q, r).has_value();
      truths += judge_triangle(fan.ray, p, q, r).hits();
    }
    INFO("draw " << i);
    if (truths > 0) REQUIRE(hits > 0);
  }
}

TEST_CASE("from inside of a closed mesh every ray towards its edges and vertices hits") {
  Random random(37);
  for (const Mesh& shape : {test::icosphere_mesh(1), test::tetrahedron_mesh(), test::box_mesh()})
    for (const float away : {0.0f, 1.0f, 100.0f}) {
      const Vec3 centre = Vec3{0.37f, -0.61f, 0.83f} * away;
      const Geometry geometry({test::placed(shape, 1, centre, true)});
      const Mesh& mesh = *geometry.mesh(0);
      for (int i = 0; i < 8000; ++i) {
        const Triangle& triangle = mesh.triangles[std::size_t(random.below(int(mesh.triangles.size())))];
        const Vec3 &a = mesh.positions[triangle[0]], &b = mesh.positions[triangle[1]];
        const Vec3 target = random.below(2) ? a : a + (b - a) * random.unit();
        const Vec3 origin = centre + random.in_ball() * 0.2f;
        INFO(mesh.name << " away " << away << " draw " << i);
        REQUIRE(test::trace_all(geometry, {.origin = origin, .direction = target - origin}));
      }
    }
}

TEST_CASE("a ray along an edge's own line, in the plane, misses without harm") {
  const Vec3 a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0};
  CHECK_FALSE(test::trace_triangle({.origin = {-1, 0, 0}, .direction = {1, 0, 0}}, a, b, c));
  CHECK_FALSE(test::trace_triangle({.origin = {-1, 0.25f, 0}, .direction = {1, -0.0f, 0}}, a, b, c));
  CHECK_FALSE(test::trace_triangle({.origin = {-1, 0.25f, 0}, .direction = {1, 0.5f, -0.0f}}, a, b, c));
}

TEST_CASE("a triangle with coincident vertices is never hit") {
  Random random(38);
  for (int i = 0; i < 100000; ++i) {
    HostilePair pair = test::hostile_pair(random);
    auto& [a, b, c] = pair.corners;
    c = b;
    if (random.below(4) == 0) a = b;
    if (trace(pair)) FAIL("draw " << i << ": " << describe(pair));
  }
}

TEST_CASE("a triangle of three points on a line is never hit, however the ray is aimed") {
  Random random(91);
  for (int i = 0; i < 100000; ++i) {
    // Corners p, p + d, p + k d with few bits each: exactly on a line.
    Vec3 p, d;
    for (int k = 0; k < 3; ++k) {
      p[k] = float(random.between(-1000, 1000)) * 0x1p-6f;
      d[k] = float(random.between(-1000, 1000)) * 0x1p-6f;
    }
    const Vec3 far = p + d * float(random.between(2, 9));
    const Vec3 target = p + d * random.uniform(0, 2);
    const Vec3 origin = random.in_cube(20);
    CHECK_FALSE(test::trace_triangle({.origin = origin, .direction = target - origin}, p, p + d, far));
  }
}

TEST_CASE("a hit's t, u and v are those of plain geometry where nothing rounds") {
  const auto hit =
      test::trace_triangle({.origin = {1, 2, 8}, .direction = {0, 0, -2}}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0});
  REQUIRE(hit);
  CHECK(hit->t == 4);
  CHECK(hit->u == 0.25f);
  CHECK(hit->v == 0.5f);
}

}  // namespace twinray
