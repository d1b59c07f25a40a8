// SPDX-License-Identifier: Apache-2.0
// Lights of pbrt's format. "scale" is photometric there: light of a spectrum or of a black body has the
// luminance that scale says; light of an rgb color that color times scale.
#pragma once
#include <memory>
#include <optional>
#include <string>

#include "core/light.h"
#include "core/transform.h"
#include "io/pbrt/context.h"
#include "io/pbrt/parameters.h"

namespace twinray {

/// What an AreaLightSource makes of the shapes that follow.
struct PbrtAreaLight {
  Rgb radiance;
  float power = 0;  ///< > 0: of each piece; the radiance is `radiance` times what gives that power.
  bool is_two_sided = false;
  std::shared_ptr<const Image> picture;  ///< Times the radiance; null: even.

  /// Of a shape of this area in so many pieces (PbrtShape), as if all of them were equally large.
  Rgb radiance_of(double area, std::size_t pieces) const;
};

/// Reads an area light. Throws Error where it is of no known type.
PbrtAreaLight read_area_light(const std::string& type, const PbrtParameters& parameters,
                              PbrtContext& context);

/// Reads a light that is no shape. Nothing where it is left out, which a warning says.
std::optional<LightSource> read_light(const std::string& type, const PbrtParameters& parameters,
                                      const Transform& to_world, PbrtContext& context);

/// The same light, so many times as strong.
void scale_light(LightSource& light, float factor);

}  // namespace twinray
