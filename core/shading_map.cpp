// SPDX-License-Identifier: Apache-2.0
#include "core/shading_map.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/angle.h"
#include "core/elementary.h"
#include "core/frame.h"
#include "core/measured_brdf.h"
#include "core/tangents.h"
#include "core/textured_material.h"

namespace twinray {
namespace {

/// How far in texture coordinates a bump map is asked to both sides: pbrt's step where there is no footprint.
constexpr float bump_step = 0.0005f;

/// A vector without its part along a unit vector.
Vec3 across(const Vec3& v, const Vec3& n) { return v - n * dot(v, n); }

/// A vector as a unit normal; `otherwise` where it is none.
Vec3 unit_or(const Vec3& v, const Vec3& otherwise) {
  const float squared = length_squared(v);
  return squared > 0 && std::isfinite(squared) ? v / std::sqrt(squared) : otherwise;
}

/// The direction that a map says at a point, in the map's axes. Between pixels it turns from one to the next:
/// of stochastic filters, surfaces would look as if they were made of facets as large as pixels.
Vec3 direction_of(const Scene& scene, std::uint32_t map, const SurfacePoint& point) {
  TexturePoint at = texture_point(point);
  at.is_smooth = true;
  const Rgb color = evaluate(scene.textures, map, at);
  return {2 * color.r - 1, 2 * color.g - 1, 2 * color.b - 1};
}

Vec3 by_normal_map(const Scene& scene, std::uint32_t map, const SurfacePoint& point,
                   const Tangents& tangents) {
  const Vec3& n = point.shading_normal;
  const Vec3 normal = direction_of(scene, map, point);
  if (normal.x == 0 && normal.y == 0) return n;
  return unit_or(Frame(n, tangents.du).to_world(normal), n);
}

Vec3 by_bump_map(const Scene& scene, std::uint32_t map, const SurfacePoint& point, const Tangents& tangents) {
  const Vec3& n = point.shading_normal;
  const auto height = [&](float du, float dv) {
    TexturePoint at = texture_point(point);
    at.is_smooth = true;
    at.uv = {point.uv.x + du, point.uv.y + dv};
    at.position += tangents.du * du + tangents.dv * dv;
    return evaluate(scene.textures, map, at).r;
  };
  const float rise_u = (height(bump_step, 0) - height(-bump_step, 0)) / (2 * bump_step);
  const float rise_v = (height(0, bump_step) - height(0, -bump_step)) / (2 * bump_step);
  if (rise_u == 0 && rise_v == 0) return n;
  const Vec3 du = across(tangents.du, n), dv = across(tangents.dv, n);
  const Vec3 raised = unit_or(cross(du + n * rise_u, dv + n * rise_v), n);
  return dot(raised, n) < 0 ? -raised : raised;
}

struct IsAnisotropic {
  static bool differ(const Roughness& r) { return r.x != r.y; }
  static bool differ(float) { return false; }

  bool operator()(const Hair&) const { return true; }
  bool operator()(const Measured& model) const { return model.brdf->is_anisotropic(); }
  template <typename Model>
  bool operator()(const Model& model) const {
    bool found = false;
    if constexpr (requires { model.roughness; }) found = found || differ(model.roughness);
    if constexpr (requires { model.coat_roughness; }) found = found || differ(model.coat_roughness);
    if constexpr (requires { model.specular_roughness_anisotropy; })
      found = found || model.specular_roughness_anisotropy > 0;
    return found;
  }
};

}  // namespace

bool is_anisotropic(const SurfaceModel& model) { return std::visit(IsAnisotropic{}, model); }

bool is_anisotropic(const Material& material) {
  constexpr MaterialInput inputs[] = {MaterialInput::roughness_u, MaterialInput::roughness_v,
                                      MaterialInput::coat_roughness_u, MaterialInput::coat_roughness_v,
                                      MaterialInput::specular_roughness_anisotropy};
  const auto is_one = [&](const TextureUse& use) {
    return std::find(std::begin(inputs), std::end(inputs), use.input) != std::end(inputs);
  };
  return is_anisotropic(material.model) ||
         std::any_of(material.textures.begin(), material.textures.end(), is_one);
}

Vec3 facet_tangent(const Scene& scene, const Material& material, const SurfacePoint& point, const Vec3& du) {
  Vec3 own{1, 0, 0};
  if (material.tangent_map != no_texture) own = direction_of(scene, material.tangent_map, point);
  if (own.x == 0 && own.y == 0) own.x = 1;
  const float turns = material.tangent_degrees / float(degrees_per_turn);
  const auto [sine, cosine] = sincos_turns(turns < 0 ? turns + 1 : turns);
  if (own.x > 0 && own.y == 0 && sine == 0) return du;
  return Frame(point.shading_normal, du)
      .to_world({cosine * own.x - sine * own.y, sine * own.x + cosine * own.y, 0});
}

Vec3 mapped_normal(const Scene& scene, const Material& material, const SurfacePoint& point) {
  if (!has_map(material)) return point.shading_normal;
  const auto tangents = tangents_at(*scene.geometry, point);
  if (!tangents) return point.shading_normal;
  if (material.normal_map != no_texture) return by_normal_map(scene, material.normal_map, point, *tangents);
  return by_bump_map(scene, material.bump_map, point, *tangents);
}

}  // namespace twinray
