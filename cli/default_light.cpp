// SPDX-License-Identifier: Apache-2.0
#include "cli/default_light.h"

#include <algorithm>
#include <variant>

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
  return std::any_of(scene.lights.begin(), scene.lights.end(),
                     [](const Light& light) { return !is_black(std::visit(Strength{}, light.source)); });
}

Light headlight(const Camera& camera) {
  if (camera.projection == Projection::orthographic)
    return {"headlight", DirectionalLight{camera.forward, Rgb{pi, pi, pi}}};
  constexpr Attenuation none{1, 0, 0};
  return {"headlight", PointLight{camera.position, Rgb{pi, pi, pi}, none}};
}

}  // namespace twinray
