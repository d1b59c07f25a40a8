// SPDX-License-Identifier: Apache-2.0
// The camera, the film and the other statements before WorldBegin: how the scene is seen.
#pragma once
#include <optional>
#include <string>

#include "core/camera.h"
#include "core/transform.h"
#include "io/pbrt/context.h"
#include "io/pbrt/lens_file.h"
#include "io/pbrt/parameters.h"
#include "io/render_defaults.h"

namespace twinray {

/// The frame of a camera in its own units at distance 1, and its lens.
struct PbrtCamera {
  bool is_given = false;
  Projection projection = Projection::perspective;
  float fov_degrees = 90;         ///< Of the frame's shorter side.
  float frame_aspect = 0;         ///< Width over height; 0: that of the film.
  std::array<float, 4> window{};  ///< x and y from and to, in place of the frame's shape.
  bool has_window = false;
  float lens_radius = 0, focal_distance = 1e6f;
  std::vector<LensSurface> lens;  ///< Of a realistic camera, in millimeters; of others none.
  Shutter shutter{0, 1};
  std::optional<Transform> to_world;  ///< Nothing where it flattens.
  PbrtPlace place;

  /// "perspective", "realistic"
  std::string kind() const { return lens.empty() ? projection_name(projection) : "realistic"; }
};

struct PbrtFilm {
  RenderDefaults defaults;
  float iso = 100;
  float diagonal = 35;  ///< In millimeters, of a realistic camera's film.
};

/// But for its place.
PbrtCamera read_camera(const std::string& type, const PbrtParameters& parameters, PbrtContext& context);
PbrtFilm read_film(const std::string& type, const PbrtParameters& parameters, PbrtContext& context);
/// Sets the samples per pixel.
void read_sampler(const std::string& type, const PbrtParameters& parameters, RenderDefaults& defaults,
                  PbrtContext& context);
/// Sets the greatest number of scattering events.
void read_integrator(const std::string& type, const PbrtParameters& parameters, RenderDefaults& defaults,
                     PbrtContext& context);
/// Sets the pixel filter.
void read_filter(const std::string& type, const PbrtParameters& parameters, RenderDefaults& defaults,
                 PbrtContext& context);

/// The camera in the world. Throws Error where its transform flattens, or its lens makes nothing sharp.
Camera place_camera(const PbrtCamera& camera, const PbrtFilm& film, PbrtContext& context);

}  // namespace twinray
