// SPDX-License-Identifier: Apache-2.0
#include "core/light_patch.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "core/mesh_area.h"
#include "core/warp.h"

namespace twinray {
namespace {

double area_of(const Mesh& mesh, std::uint32_t triangle) {
  return area_vector(mesh, mesh.triangles[triangle]).area();
}

Vec3 vertex(const Mesh& mesh, std::uint32_t triangle, int corner) {
  return mesh.positions[mesh.triangles[triangle][std::size_t(corner)]];
}

/// Which corner of a patch each vertex of a triangle is.
std::array<std::uint8_t, 3> corners_of(const LightPatch& patch, const Mesh& mesh, std::uint32_t triangle) {
  std::array<std::uint8_t, 3> found;
  for (int i = 0; i < 3; ++i) {
    const auto at = std::find(patch.corners.begin(), patch.corners.end(), vertex(mesh, triangle, i));
    found[std::size_t(i)] = std::uint8_t(at - patch.corners.begin());
  }
  return found;
}

/// The parallelogram of two triangles of one winding that share the edge opposite to the corner `apex` of the
/// first, if they form one.
std::optional<LightPatch> parallelogram(const Mesh& mesh, std::uint32_t first, std::uint32_t second,
                                        int apex) {
  // From the corner after the apex around: the diagonal's ends are corners 0 and 2.
  const Vec3 p0 = vertex(mesh, first, (apex + 1) % 3), p2 = vertex(mesh, first, (apex + 2) % 3);
  const Vec3 p1 = vertex(mesh, first, apex);
  for (int other = 0; other < 3; ++other) {
    // The second triangle goes along the diagonal the other way.
    if (vertex(mesh, second, (other + 1) % 3) != p2 || vertex(mesh, second, (other + 2) % 3) != p0) continue;
    const Vec3 p3 = vertex(mesh, second, other);
    constexpr float slack = 0x1p-20f;  // Of the diagonal: coordinates of a file have seven digits.
    if (length(p0 + p2 - p1 - p3) > slack * length(p2 - p0)) return std::nullopt;
    LightPatch patch;
    patch.corners = {p0, p1, p2, p3};
    patch.is_parallelogram = true;
    return patch;
  }
  return std::nullopt;
}

LightPatch single_triangle(const Mesh& mesh, std::uint32_t triangle) {
  const Vec3 a = vertex(mesh, triangle, 0), b = vertex(mesh, triangle, 1), c = vertex(mesh, triangle, 2);
  LightPatch patch;
  patch.corners = {a, b, (b + c) * 0.5f, c};
  return patch;
}

/// The patch that begins with a triangle: with the first of the others that completes a parallelogram, which
/// is taken out of them.
LightPatch next_patch(const Mesh& mesh, std::vector<std::uint32_t>& others) {
  const std::uint32_t first = others.front();
  others.erase(others.begin());
  for (auto other = others.begin(); other != others.end(); ++other)
    for (int apex = 0; apex < 3; ++apex)
      if (auto patch = parallelogram(mesh, first, *other, apex)) {
        patch->triangles = {first, *other};
        patch->corner_of = {corners_of(*patch, mesh, first), corners_of(*patch, mesh, *other)};
        others.erase(other);
        return *patch;
      }
  LightPatch patch = single_triangle(mesh, first);
  patch.triangles = {first, first};
  return patch;
}

/// cos cos / distance^2 between a receiver and a corner, without the common factor of a light's radiance.
float corner_weight(const Receiver& receiver, const Vec3& corner, const Vec3& normal, EmissionSide side) {
  const auto positive = [](float x) { return x > 0 ? x : 0; };
  const Vec3 between = corner - receiver.position;
  const float squared = length_squared(between);
  const float front = -dot(normal, between);
  const float emitted = side == EmissionSide::both    ? std::fabs(front)
                        : side == EmissionSide::front ? positive(front)
                                                      : positive(-front);
  return (positive(receiver.facing(between)) / squared) * (emitted / squared);
}

/// Where in [0, 1] a draw falls by a density that grows from a to b, both > 0, to a common factor.
float linear_sample(float u, float a, float b) {
  return std::min(u * (a + b) / (a + std::sqrt(a * a * (1 - u) + b * b * u)), 1.0f);
}

float bilinear(const std::array<float, 4>& corners, float x, float y) {
  const float left = corners[0] * (1 - y) + corners[3] * y;
  const float right = corners[1] * (1 - y) + corners[2] * y;
  return left * (1 - x) + right * x;
}

/// Of a parallelogram's point (x, y), the weight of each corner: all but one of a triangle's half.
std::array<float, 4> corner_shares(float x, float y) {
  if (y <= x) return {1 - x, x - y, y, 0};
  return {1 - y, 0, x, y - x};
}

}  // namespace

PatchLight patch_light(const Mesh& mesh, EmissionSide side, double area) {
  constexpr float least_share = 1e-6f;  // Densities of a smaller patch could overflow.
  PatchLight light{.side = side};
  if (mesh.triangles.size() > 2 * PatchLight::most || !(area > 0)) return light;
  std::vector<std::uint32_t> rest(mesh.triangles.size());
  std::iota(rest.begin(), rest.end(), 0u);
  std::erase_if(rest, [&](std::uint32_t triangle) { return area_of(mesh, triangle) == 0; });
  while (!rest.empty()) {
    LightPatch patch = next_patch(mesh, rest);
    const auto [first, second] = patch.triangles;
    const double own = area_of(mesh, first) + (second != first ? area_of(mesh, second) : 0);
    patch.share = float(own / area);
    patch.normal = area_vector(mesh, mesh.triangles[first]).normal();
    if (light.patches.size() == PatchLight::most || patch.share < least_share) return {};
    light.patches.push_back(patch);
  }
  return light;
}

PatchWeights::PatchWeights(const PatchLight& light, const Receiver& receiver) : light_(light) {
  float mean = 0;
  for (std::size_t i = 0; i < light.patches.size(); ++i) {
    const LightPatch& patch = light.patches[i];
    for (std::size_t k = 0; k < 4; ++k)
      corners_[i][k] = corner_weight(receiver, patch.corners[k], patch.normal, light.side);
    mean += probability(i);
  }
  const bool is_known = mean > 0 && std::isfinite(mean);
  for (std::size_t i = 0; i < light.patches.size(); ++i)
    for (float& weight : corners_[i])
      weight = is_known ? (weight / mean + PatchLight::floor) * (1 / (1 + PatchLight::floor)) : 1;
}

float PatchWeights::probability(std::size_t patch) const {
  const auto& [a, b, c, d] = corners_[patch];
  return light_.patches[patch].share * (0.25f * ((a + b) + (c + d)));
}

PatchWeights::Choice PatchWeights::choose(Vec2 u) const {
  float total = 0;
  for (std::size_t i = 0; i < light_.patches.size(); ++i) total += probability(i);
  const float target = u.x * total;
  std::size_t chosen = 0;
  float before = 0;
  for (; chosen + 1 < light_.patches.size() && before + probability(chosen) <= target; ++chosen)
    before += probability(chosen);
  const float within = std::min((target - before) / probability(chosen), 0x1.fffffep-1f);
  const LightPatch& patch = light_.patches[chosen];
  const auto& corners = corners_[chosen];
  const float y = linear_sample(u.y, corners[0] + corners[1], corners[3] + corners[2]);
  const float x =
      linear_sample(within, corners[0] * (1 - y) + corners[3] * y, corners[1] * (1 - y) + corners[2] * y);
  const float density = bilinear(corners, x, y);
  const std::size_t half = y <= x ? 0 : 1;
  if (!patch.is_parallelogram) {
    const Vec2 weights = square_to_triangle({x, y});
    return {patch.triangles[half], weights.x, weights.y, density};
  }
  const std::array<float, 4> shares = corner_shares(x, y);
  const auto& corner = patch.corner_of[half];
  return {patch.triangles[half], shares[corner[1]], shares[corner[2]], density};
}

float PatchWeights::density(std::uint32_t triangle, float u, float v) const {
  std::size_t chosen = 0;
  while (light_.patches[chosen].triangles[0] != triangle && light_.patches[chosen].triangles[1] != triangle)
    ++chosen;
  const LightPatch& patch = light_.patches[chosen];
  if (!patch.is_parallelogram) {  // square_to_triangle took half of the smaller coordinate from both.
    const float half = std::min(u, v);
    return bilinear(corners_[chosen], u + half, v + half);
  }
  const std::size_t half = patch.triangles[0] == triangle ? 0 : 1;
  std::array<float, 4> shares{};
  const float weights[] = {1 - u - v, u, v};
  for (std::size_t i = 0; i < 3; ++i) shares[patch.corner_of[half][i]] = weights[i];
  return bilinear(corners_[chosen], shares[1] + shares[2], shares[2] + shares[3]);
}

}  // namespace twinray
