// SPDX-License-Identifier: Apache-2.0
#include "core/check_light.h"

#include <fmt/format.h>

#include <cmath>

#include "core/error.h"

namespace twinray {
namespace {

/// Whether vectors are of unit length and at right angles, but for the rounding of a file's numbers.
bool is_orthonormal(const Vec3& a, const Vec3& b, const Vec3& c) {
  constexpr float tolerance = 1e-4f;
  const auto is = [](float product, float expected) { return std::fabs(product - expected) <= tolerance; };
  return is(dot(a, a), 1) && is(dot(b, b), 1) && is(dot(c, c), 1) && is(dot(a, b), 0) && is(dot(a, c), 0) &&
         is(dot(b, c), 0);
}

struct Check {
  const std::string& name;

  /// The picture of a light that is called so.
  void picture(const char* kind, const std::shared_ptr<const Image>& image) const {
    if (!image || image->pixels.empty()) throw Error(fmt::format("{} is {} without a picture", name, kind));
  }
  void map(const char* kind, const std::shared_ptr<const Image>& image, MapLayout layout) const {
    picture(kind, image);
    if (layout == MapLayout::equal_area && image->width != image->height)
      throw Error(fmt::format("{} is {} whose equal-area picture has {} x {} pixels; it must be a square",
                              name, kind, image->width, image->height));
  }
  void rotation(const char* kind, const Transform& turn) const {
    if (!is_orthonormal(turn.vector({1, 0, 0}), turn.vector({0, 1, 0}), turn.vector({0, 0, 1})))
      throw Error(fmt::format("{} is {} whose rotation also scales or shears", name, kind));
  }
  void amount(const char* kind, const char* what, const Rgb& c) const {
    if (!is_finite(c) || c.r < 0 || c.g < 0 || c.b < 0)
      throw Error(fmt::format("{} is {} whose {} is ({}, {}, {}); each must be finite and not negative", name,
                              kind, what, c.r, c.g, c.b));
  }

  void operator()(const MeshLight& light) const {
    if (light.picture) picture("a mesh light", light.picture);
    const float* const numbers = &light.uv.m[0][0];
    if (!std::all_of(numbers, numbers + 6, [](float x) { return std::isfinite(x); }))
      throw Error(fmt::format(
          "{} is a mesh light whose picture lies at no place; all six numbers must be finite", name));
    if (light.filter != TextureFilter::nearest && light.filter != TextureFilter::bilinear)
      throw Error(
          fmt::format("{} is a mesh light whose picture is filtered by mip-maps; valid are nearest and "
                      "bilinear",
                      name));
  }
  void operator()(const EnvironmentLight& light) const {
    map("an environment", light.map, light.layout);
    rotation("an environment", light.rotation);
    amount("an environment", "scale", light.scale);
  }
  void operator()(const GoniometricLight& light) const {
    map("a goniometric light", light.map, light.layout);
    rotation("a goniometric light", light.rotation);
    amount("a goniometric light", "intensity", light.intensity);
  }
  void operator()(const ProjectionLight& light) const {
    picture("a projection light", light.picture);
    if (!is_orthonormal(light.right, light.up, light.forward))
      throw Error(
          fmt::format("{} is a projection light whose axes are not unit vectors at right angles", name));
    if (!(light.tan_half_width > 0) || !(light.tan_half_height > 0) || !std::isfinite(light.tan_half_width) ||
        !std::isfinite(light.tan_half_height))
      throw Error(
          fmt::format("{} is a projection light whose frame is {} x {}; each must be finite and "
                      "positive",
                      name, light.tan_half_width, light.tan_half_height));
    amount("a projection light", "intensity", light.intensity);
  }
  void operator()(const SunLight& light) const {
    if (!(light.diameter_degrees > 0 && light.diameter_degrees < 180))
      throw Error(fmt::format("{} is a sun of {} degrees; valid are more than 0 and less than 180", name,
                              light.diameter_degrees));
    amount("a sun", "irradiance", light.irradiance);
  }
  void operator()(const SpotLight& light) const {
    if (!(light.penumbra_degrees >= 0 && light.penumbra_degrees <= 0.5f * light.falloff_angle_degrees))
      throw Error(
          fmt::format("{} is a spot whose penumbra is {} degrees wide; valid are 0 to {}, half of its "
                      "cone",
                      name, light.penumbra_degrees, 0.5f * light.falloff_angle_degrees));
  }
  template <typename Other>
  void operator()(const Other&) const {}
};

}  // namespace

void check_numbers(const LightSource& source, const std::string& name) { std::visit(Check{name}, source); }

}  // namespace twinray
