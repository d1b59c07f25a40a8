// SPDX-License-Identifier: Apache-2.0
#include "accel/accelerator.h"
#include "tests/support/catch.h"
#include "tests/support/shapes.h"

using namespace twinray;
using namespace twinray::test;

namespace {

/// A ray from within a closed mesh through a vertex, a point of an edge or a point of a face.
Ray outward_ray(const Mesh& mesh, const Vec3& origin, Random& random) {
  const Triangle& triangle = mesh.triangles[std::size_t(random.below(int(mesh.triangles.size())))];
  const Vec3 &a = mesh.positions[triangle[0]], &b = mesh.positions[triangle[1]],
             &c = mesh.positions[triangle[2]];
  const int feature = random.below(3);
  const float s = random.unit(), t = random.unit() * (1 - s);
  const Vec3 target = feature == 0 ? a : feature == 1 ? a * s + b * (1 - s) : a * s + b * t + c * (1 - s - t);
  return {.origin = origin, .direction = target - origin};
}

/// How many of `count` rays leave a closed mesh around `center` without a hit.
int leaks(const Accelerator& accelerator, const Mesh& mesh, const Vec3& center, int count) {
  Random random(201);
  int leaked = 0;
  for (int i = 0; i < count; ++i) {
    // Half of the origins lie at the centre, where rays through vertices are the most exact.
    const Vec3 origin = center + random.in_cube(random.below(2) ? 0.0f : 0.4f);
    const Ray ray = outward_ray(mesh, origin, random);
    leaked += !accelerator.any_hit(ray) || !accelerator.closest_hit(ray);
  }
  return leaked;
}

std::vector<Backend> canonical_backends() {
  std::vector<Backend> backends = available_backends();
  std::erase(backends, Backend::embree_native);
  return backends;
}

}  // namespace

TEST_CASE("a closed sphere leaks no ray of a million") {
  const Mesh mesh = icosphere_mesh(6);
  const auto geometry = share({mesh});
  for (const Backend backend : canonical_backends()) {
    const int count = backend == Backend::brute_force ? 500 : 1000000;
    CAPTURE(backend_name(backend));
    CHECK(leaks(*build_accelerator(backend, geometry), mesh, {}, count) == 0);
  }
}

TEST_CASE("a closed sphere far from the origin leaks no ray") {
  // There the vertices lie on a grid of 2^-6, about an eighth of an edge: an uneven, but still closed mesh.
  const Vec3 center{148376, 1234, -223423};
  Mesh mesh = icosphere_mesh(5);
  for (Vec3& p : mesh.positions) p = center + p * 2;
  drop_degenerate_triangles(mesh);
  const auto geometry = share({mesh});
  for (const Backend backend : canonical_backends()) {
    const int count = backend == Backend::brute_force ? 500 : 100000;
    CAPTURE(backend_name(backend));
    CHECK(leaks(*build_accelerator(backend, geometry), mesh, center, count) == 0);
  }
}
