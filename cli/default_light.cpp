// SPDX-License-Identifier: Apache-2.0
#include "cli/default_light.h"

#include <algorithm>
#include <variant>

#include "core/interiors.h"
#include "core/warp.h"

namespace twinray {
namespace {

/// A measure of a light that is black where it sends none.
struct Strength {
  Rgb operator()(const MeshLight& light) const { return mean_radiance(light); }
  Rgb operator()(const SphereLight& light) const { return light.radiance; }
  Rgb operator()(const PointLight& light) const { return light.intensity; }
  Rgb operator()(const SpotLight& light) const { return light.intensity; }
  Rgb operator()(const DirectionalLight& light) const { return light.irradiance; }
  Rgb operator()(const AmbientLight& light) const { return light.radiance; }
  Rgb operator()(const SunLight& light) const { return light.irradiance; }
  Rgb operator()(const EnvironmentLight& light) const { return of_picture(*light.map, light.scale); }
  Rgb operator()(const GoniometricLight& light) const { return of_picture(*light.map, light.intensity); }
  Rgb operator()(const ProjectionLight& light) const { return of_picture(*light.picture, light.intensity); }
  /// The first pixel that is not black, times a scale.
  static Rgb of_picture(const Image& picture, const Rgb& scale) {
    for (const Rgb& pixel : picture.pixels)
      if (!is_black(scale * pixel)) return scale * pixel;
    return {};
  }
};

}  // namespace

bool is_lit(const Scene& scene) {
  return has_glow(scene.materials) ||
         std::any_of(scene.lights.begin(), scene.lights.end(),
                     [](const Light& light) { return !is_black(std::visit(Strength{}, light.source)); });
}

std::vector<Light> default_lights(const Camera& camera) {
  constexpr float sky = 0.5f, head = pi * (1 - sky / 2);
  constexpr Attenuation none{1, 0, 0};
  std::vector<Light> lights{{"sky", AmbientLight{{0, 1, 0}, Rgb{sky, sky, sky}}}};
  if (camera.projection == Projection::orthographic)
    lights.push_back({"headlight", DirectionalLight{camera.forward, Rgb{head, head, head}}});
  else
    lights.push_back({"headlight", PointLight{camera.position, Rgb{head, head, head}, none}});
  return lights;
}

}  // namespace twinray
