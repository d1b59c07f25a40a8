// SPDX-License-Identifier: Apache-2.0
// What a user of the installed libraries writes: a geometry, rays, and the same answer from each engine.
#include <cstdio>
#include <memory>
#include <vector>

#include "accel/accelerator.h"
#include "canonical_table.h"
#include "core/error.h"
#include "io/picture/image_file.h"

namespace {

using namespace twinray;

/// A square of side 4 at z = 0 with a sphere of radius 1 in its middle.
std::shared_ptr<const Geometry> sphere_on_square() {
  Mesh square{.name = "square",
              .positions = {{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}},
              .triangles = {{0, 1, 2}, {0, 2, 3}}};
  SphereSet ball{.name = "ball", .spheres = {{{0, 0, 0}, 1}}};
  return std::make_shared<const Geometry>(std::vector<Shape>{std::move(square), std::move(ball)});
}

/// Downward rays over the square and past it; every row crosses the sphere, both triangles and their edge.
std::vector<Ray> rays_from_above() {
  std::vector<Ray> rays;
  for (int y = -20; y <= 20; ++y)
    for (int x = -20; x <= 20; ++x)
      rays.push_back({.origin = {0.11f * x, 0.11f * y, 5}, .direction = {0.01f * y, 0.02f, -1}});
  return rays;
}

int count_hits(const Accelerator& engine, const std::vector<Ray>& rays) {
  int hits = 0;
  for (const Ray& ray : rays) hits += !engine.closest_hit(ray).is_miss();
  return hits;
}

int count_differences(const Accelerator& engine, const Accelerator& oracle, const std::vector<Ray>& rays) {
  int differences = 0;
  for (const Ray& ray : rays) differences += engine.closest_hit(ray) != oracle.closest_hit(ray);
  return differences;
}

/// The table holds for this program's compiler flags, whatever they are.
int count_wrong_bits(Backend backend) {
  const std::vector<std::string> wrong = test::canonical_mismatches(backend);
  for (const std::string& row : wrong) std::printf("%s: %s\n", backend_name(backend).c_str(), row.c_str());
  return int(wrong.size());
}

/// What OpenImageIO does is loaded while the program runs: from the folder that twinray is installed in.
bool keeps_pictures() {
  Image image(2, 1);
  image.at(1, 0) = {0.25f, 7, 1e-3f};
  write_image("consumer.exr", image);
  return read_image("consumer.exr").pixels == image.pixels;
}

int run() {
  if (!keeps_pictures()) {
    std::puts("an EXR is not read as it was written");
    return 1;
  }
  const auto geometry = sphere_on_square();
  const auto rays = rays_from_above();
  const auto oracle = build_accelerator(Backend::brute_force, geometry);
  const int hits = count_hits(*oracle, rays);
  if (hits == 0 || hits == int(rays.size())) {
    std::printf("%d of %zu rays hit; some should, and some should not\n", hits, rays.size());
    return 1;
  }
  for (const Backend backend : available_backends()) {
    if (backend == Backend::embree_native) continue;  // its own triangles: not promised to be the same bits
    const int differences = count_differences(*build_accelerator(backend, geometry), *oracle, rays);
    if (differences > 0) {
      std::printf("%s: %d of %zu hits differ\n", backend_name(backend).c_str(), differences, rays.size());
      return 1;
    }
    if (count_wrong_bits(backend) > 0) return 1;
  }
  return 0;
}

}  // namespace

int main() {
  try {
    return run();
  } catch (const twinray::Error& error) {
    std::puts(error.what());
    return 1;
  }
}
