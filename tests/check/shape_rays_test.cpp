// SPDX-License-Identifier: Apache-2.0
// Each class of rays is what it says: an engine that is never asked the hard question always agrees.
#include "check/shape_rays.h"

#include <bit>
#include <cmath>

#include "check/judge.h"
#include "tests/support/catch.h"
#include "tests/support/crosscheck.h"
#include "tests/support/instances.h"
#include "tests/support/shapes.h"

namespace twinray::test {
namespace {

constexpr int count = 2000;

/// A closed sphere of radius 1 as a mesh, and the rays that are made from it.
struct Source {
  std::shared_ptr<const Geometry> geometry = share({icosphere_mesh(3)});
  std::unique_ptr<Accelerator> engine = build_accelerator(Backend::bvh, geometry);
  ShapeRays rays{geometry, *engine, 9};

  std::vector<Ray> of(RayClass ray_class) const {
    std::vector<Ray> all;
    for (std::uint64_t i = 0; i < count; ++i) all.push_back(rays.ray(ray_class, i));
    return all;
  }
  const Mesh& mesh() const { return *geometry->mesh(0); }
};

/// The share of rays for which something is true.
template <typename Property>
double share_of(const std::vector<Ray>& rays, Property&& property) {
  return double(std::count_if(rays.begin(), rays.end(), property)) / double(rays.size());
}

double length_of(const Vec3& v) {
  return std::sqrt(double(v.x) * v.x + double(v.y) * v.y + double(v.z) * v.z);
}

/// The least distance of the line of a ray from a vertex of the mesh.
double distance_from_vertices(const Ray& ray, const Mesh& mesh) {
  double least = 1e9;
  for (const Vec3& p : mesh.positions)
    least = std::min(least, length_of(cross(ray.direction, p - ray.origin)) / length_of(ray.direction));
  return least;
}

/// The least distance of the line of a ray from an edge of the mesh, in units of what float tests round by.
double margin_of_edges(const Ray& ray, const Mesh& mesh) {
  double least = 1e9;
  for (const auto& [i, j, k] : mesh.triangles) {
    const auto judgement = judge_triangle(ray, mesh.positions[i], mesh.positions[j], mesh.positions[k]);
    if (judgement.position != LinePosition::edge_on)
      least = std::min(least, std::fabs(judgement.edge_margin_ulps()));
  }
  return least;
}

/// Of the bits of all rays, in their order (FNV-1a by words).
std::uint64_t hash_of(const std::vector<Ray>& rays) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const Ray& ray : rays)
    for (const float x : {ray.origin.x, ray.origin.y, ray.origin.z, ray.direction.x, ray.direction.y,
                          ray.direction.z, ray.t_min, ray.t_max})
      hash = (hash ^ std::bit_cast<std::uint32_t>(x)) * 0x100000001b3u;
  return hash;
}

bool is_negative_zero(float x) { return x == 0 && std::signbit(x); }

}  // namespace

TEST_CASE("every other random ray ends at its second point") {
  const Source source;
  const std::vector<Ray> rays = source.of(RayClass::random);
  CHECK(share_of(rays, [](const Ray& ray) { return ray.t_max == 1; }) == Approx(0.5).margin(0.05));
  const double hits = share_of(rays, [&](const Ray& ray) { return source.engine->any_hit(ray); });
  CHECK(hits > 0.2);
  CHECK(hits < 0.8);
}

TEST_CASE("vertex rays go through a vertex, edge rays through an edge, within rounding") {
  const Source source;
  const double few_ulps = 8 * 0x1p-24 * 3;  // A target 3 away, each coordinate rounded.
  CHECK(share_of(source.of(RayClass::vertices),
                 [&](const Ray& ray) { return distance_from_vertices(ray, source.mesh()) < few_ulps; }) == 1);
  const std::vector<Ray> edges = source.of(RayClass::edges);
  CHECK(share_of(edges, [&](const Ray& ray) { return margin_of_edges(ray, source.mesh()) < 8; }) > 0.99);
  CHECK(share_of(edges, [&](const Ray& ray) { return distance_from_vertices(ray, source.mesh()) > 1e-3; }) >
        0.9);
}

TEST_CASE("vertex rays go through vertices of instances, as often as of copies") {
  const auto geometry = share_instanced({icosphere_mesh(0)}, {{icosphere_mesh(1)}}, {Kind::rigid}, 2, 3);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> names;
  const auto copies = flattened(*geometry, names);
  const auto engine = build_accelerator(Backend::bvh, geometry);
  const ShapeRays rays(geometry, *engine, 9);
  constexpr double few_ulps = 1e-5;
  std::vector<int> through(copies->shapes().size());
  for (std::uint64_t i = 0; i < 2000; ++i)
    for (std::uint32_t shape = 0; shape < through.size(); ++shape)
      through[shape] +=
          distance_from_vertices(rays.ray(RayClass::vertices, i), *copies->mesh(shape)) < few_ulps;
  // 20 triangles stand in the scene, and twice 80.
  CHECK(through[0] == Approx(2000 * 20 / 180.0).epsilon(0.2));
  CHECK(through[1] == Approx(2000 * 80 / 180.0).epsilon(0.2));
  CHECK(through[2] == Approx(2000 * 80 / 180.0).epsilon(0.2));
}

TEST_CASE("axis rays run along one axis, with zeros of both signs in the other components") {
  const Source source;
  const std::vector<Ray> rays = source.of(RayClass::axes);
  for (const Ray& ray : rays) {
    REQUIRE(std::fabs(ray.direction.x) + std::fabs(ray.direction.y) + std::fabs(ray.direction.z) == 1);
    REQUIRE(max_abs(ray.direction) == 1);
  }
  for (int axis = 0; axis < 3; ++axis) {
    CHECK(share_of(rays, [&](const Ray& ray) { return is_negative_zero(ray.direction[axis]); }) > 0.25);
    CHECK(share_of(rays, [&](const Ray& ray) { return ray.direction[axis] == -1; }) > 0.1);
    CHECK(share_of(rays, [&](const Ray& ray) { return ray.direction[axis] == 1; }) > 0.1);
  }
}

TEST_CASE("box-face rays lie in the plane of a face of a triangle's box") {
  const Source source;
  std::vector<float> faces[3];
  for (const auto& [i, j, k] : source.mesh().triangles) {
    const Aabb box =
        triangle_bounds(source.mesh().positions[i], source.mesh().positions[j], source.mesh().positions[k]);
    for (int axis = 0; axis < 3; ++axis)
      faces[axis].insert(faces[axis].end(), {box.lower[axis], box.upper[axis]});
  }
  const std::vector<Ray> rays = source.of(RayClass::box_faces);
  for (const Ray& ray : rays) {
    bool is_in_face = false;
    for (int axis = 0; axis < 3; ++axis)
      is_in_face |= ray.direction[axis] == 0 &&
                    std::count(faces[axis].begin(), faces[axis].end(), ray.origin[axis]) > 0;
    REQUIRE(is_in_face);
  }
  CHECK(share_of(rays, [](const Ray& ray) {
          return is_negative_zero(ray.direction.x) || is_negative_zero(ray.direction.y) ||
                 is_negative_zero(ray.direction.z);
        }) > 0.4);
}

TEST_CASE("grazing rays lie nearly in the plane of a triangle, some of them quite") {
  const Source source;
  const auto least_cosine = [&](const Ray& ray) {
    double least = 1;
    for (const auto& [i, j, k] : source.mesh().triangles) {
      const auto& p = source.mesh().positions;
      const auto judgement = judge_triangle(ray, p[i], p[j], p[k]);
      if (length_of(cross(ray.direction, p[i] - ray.origin)) > length_of(ray.direction)) continue;
      least = std::min(least, judgement.position == LinePosition::edge_on ? 0 : judgement.cosine);
    }
    return least;
  };
  CHECK(share_of(source.of(RayClass::grazing), [&](const Ray& ray) { return least_cosine(ray) < 1e-4; }) >
        0.95);
}

TEST_CASE("surface rays start on a triangle") {
  const Source source;
  for (const Ray& ray : source.of(RayClass::surface)) {
    const double radius = length_of(ray.origin);  // The faces of this mesh lie a little below its sphere.
    REQUIRE(radius > 0.97);
    REQUIRE(radius < 1.0001);
  }
}

TEST_CASE("the interval of an ends ray begins or ends at a hit, or right beside it") {
  const Source source;
  int at_min = 0, at_max = 0, both = 0, behind = 0, before = 0;
  for (const Ray& ray : source.of(RayClass::ends)) {
    Ray open{.origin = ray.origin, .direction = ray.direction};
    const float t = source.engine->closest_hit(open).t;
    if (std::isinf(t)) continue;
    at_min += ray.t_min == t && ray.t_max > t;
    at_max += ray.t_max == t && ray.t_min == 0;
    both += ray.t_min == t && ray.t_max == t;
    behind += ray.t_min == std::nextafter(t, INFINITY);
    before += ray.t_max == std::nextafter(t, 0.0f);
  }
  for (const int found : {at_min, at_max, both, behind, before}) CHECK(found > count / 20);
}

TEST_CASE("direction rays have every length that a float can have") {
  const Source source;
  const std::vector<Ray> rays = source.of(RayClass::directions);
  const auto within = [&](float low, float high) {
    return share_of(
        rays, [&](const Ray& ray) { return max_abs(ray.direction) >= low && max_abs(ray.direction) < high; });
  };
  CHECK(within(0x1p-149f, 0x1p-126f) > 0.05);  // denormal
  CHECK(within(0x1p-126f, 0x1p-41f) > 0.2);
  CHECK(within(0x1p-41f, 0x1p41f) > 0.2);
  CHECK(within(0x1p41f, 0x1p120f) > 0.2);
  CHECK(within(0x1p120f, INFINITY) > 0.01);
}

TEST_CASE("far rays start from five to ten million sizes away") {
  const Source source;
  const std::vector<Ray> rays = source.of(RayClass::far);
  const auto within = [&](float low, float high) {
    return share_of(rays,
                    [&](const Ray& ray) { return max_abs(ray.origin) >= low && max_abs(ray.origin) < high; });
  };
  CHECK(within(0.5f, 6) > 0.1);
  CHECK(within(6, 50) > 0.1);
  CHECK(within(100, 2e3f) > 0.1);
  CHECK(within(2e3f, 2e4f) > 0.1);
  CHECK(within(2e4f, 2e5f) > 0.02);
  CHECK(within(2e5f, 2e7f) > 0.005);
}

TEST_CASE("the rays of a moved, shrunk or grown scene are of many classes") {
  const Source source;
  for (const RayClass ray_class : {RayClass::moved, RayClass::shrunk, RayClass::grown}) {
    const std::vector<Ray> rays = source.of(ray_class);
    CHECK(share_of(rays, [](const Ray& ray) {
            return (ray.direction.x == 0) + (ray.direction.y == 0) + (ray.direction.z == 0) == 2;
          }) > 0.1);
    CHECK(share_of(rays, [](const Ray& ray) { return ray.t_max == 1; }) > 0.04);
    CHECK(share_of(rays, [](const Ray& ray) { return ray.t_min > 0; }) > 0.03);
  }
}

TEST_CASE("the rays of a seed are the same on every machine") {
  constexpr std::uint64_t hashes[] = {
      0x89a3628b46d38dc6u, 0xff7c425e3d71dd53u, 0x8a30d3282c204f5u,  0xa67d46e2b8f82229u, 0xdb5ea6f563ded7e4u,
      0xc9f6d08c1433f0du,  0x949ec2991362d8bfu, 0xe38502591e8acb9du, 0xa547a476a057e8c6u, 0x1ab9444796798598u,
      0x349de7bacd77e960u, 0x869e6545ccf5d79fu, 0x125b8a40cfec0fe7u};
  const Source source;
  auto hash = std::begin(hashes);
  for (const RayClass ray_class : shape_ray_classes()) {
    INFO(ray_class_name(ray_class) << " rays");
    CHECK(hash_of(source.of(ray_class)) == *hash++);
  }
}

}  // namespace twinray::test
