// SPDX-License-Identifier: Apache-2.0
#include "core/alpha_test.h"

#include <algorithm>
#include <bit>
#include <memory>

#include "core/hash.h"
#include "core/octahedron.h"
#include "core/scene_textures.h"
#include "core/surface.h"
#include "core/textured_material.h"

namespace twinray {
namespace {

/// Whether the ray leaves a sphere there: its line hits it twice, by chances that must not be the same.
bool is_leaving(const Geometry& geometry, const Vec3& direction, const Hit& hit) {
  return !geometry.mesh(hit.mesh) && dot(octahedral_decode(hit.u, hit.v), direction) > 0;
}

/// In [0, 1): a hash of ray and primitive, of an instance in its own space. It does not know u and v, so
/// engines whose rounding differs choose alike.
float random_of(const Geometry& geometry, const Vec3& origin, const Vec3& direction, const Hit& hit) {
  std::uint64_t hash = mix((std::uint64_t(hit.mesh) << 32 | hit.primitive) + hash_step);
  for (int axis = 0; axis < 3; ++axis) {
    const std::uint64_t start = std::bit_cast<std::uint32_t>(origin[axis]);
    hash = mix(hash + (start << 32 | std::bit_cast<std::uint32_t>(direction[axis])) * index_step);
  }
  if (is_leaving(geometry, direction, hit)) hash = mix(hash + stream_step);
  if (hit.instance != no_instance) hash = mix(hash + (hit.instance + 1ull) * hash_step);
  return float(hash >> 40) * 0x1p-24f;
}

/// The textures, with all pictures that alphas are made of in memory: traversal must not wait for a tile.
std::vector<Texture> for_traversal(std::span<const Texture> textures, std::span<const std::uint32_t> alphas) {
  std::vector<Texture> copies(textures.begin(), textures.end());
  for (const std::uint32_t alpha : alphas)
    if (alpha != no_texture) keep_in_memory(copies, alpha);
  return copies;
}

}  // namespace

float alpha_at(std::span<const Texture> textures, std::uint32_t texture, TexturePoint at) {
  at.is_smooth = true;
  const float alpha = evaluate(textures, texture, at).r;
  return alpha > 0 ? std::min(alpha, 1.0f) : 0;
}

AlphaTest::AlphaTest(std::vector<Texture> textures, std::vector<std::uint32_t> alphas)
    : textures_(std::move(textures)), alphas_(std::move(alphas)), by_position_(go_by_position(textures_)) {}

bool AlphaTest::accepts(const Geometry& geometry, const Vec3& origin, const Vec3& direction,
                        const Hit& hit) const noexcept {
  const std::uint32_t texture = alphas_[hit.mesh];
  if (texture == no_texture) return true;
  const TexturePoint at = by_position_[texture] ? texture_point(surface_at(geometry, hit))
                                                : TexturePoint{.uv = texture_coordinates(geometry, hit)};
  const float alpha = alpha_at(textures_, texture, at);
  if (alpha == 0 || alpha == 1) return alpha == 1;
  return random_of(geometry, origin, direction, hit) < alpha;
}

Geometry cut_out(std::vector<Shape> shapes, std::span<const ShapeBinding> bindings,
                 std::span<const Texture> textures, Instancing instancing) {
  std::vector<std::uint32_t> alphas;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    alphas.push_back(bindings[i].alpha);
    std::visit([&](auto& shape) { shape.is_opaque = alphas[i] == no_texture; }, shapes[i]);
  }
  if (std::all_of(alphas.begin(), alphas.end(), [](std::uint32_t alpha) { return alpha == no_texture; }))
    return Geometry(std::move(shapes), nullptr, std::move(instancing));
  std::vector<Texture> looked_up = for_traversal(textures, alphas);
  return Geometry(std::move(shapes),
                  std::make_shared<const AlphaTest>(std::move(looked_up), std::move(alphas)),
                  std::move(instancing));
}

}  // namespace twinray
