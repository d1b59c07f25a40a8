// SPDX-License-Identifier: Apache-2.0
// Private: what is known of a wave of paths that have the same number of vertices.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/hit.h"
#include "core/light_patch.h"
#include "core/ray.h"
#include "core/rgb.h"
#include "core/sampler.h"
#include "integrators/direct_light.h"
#include "integrators/interaction.h"
#include "integrators/passages.h"
#include "integrators/walk_below.h"
#include "integrators/wave/columns.h"
#include "integrators/wave/lobe_surfaces.h"

namespace twinray {

/// Hashes of seed and pixel, PathKey::pixel: those of neighbouring samples are often the same.
class PixelKeys {
 public:
  std::uint64_t operator()(const SampleKey& sample) {
    if (sample.x != last_.x || sample.y != last_.y || sample.seed != last_.seed || is_first_) {
      pixel_ = PathKey(sample).pixel;
      last_ = sample;
      is_first_ = false;
    }
    return pixel_;
  }

 private:
  SampleKey last_;
  std::uint64_t pixel_ = 0;
  bool is_first_ = true;
};

/// Paths on their way. Written by the camera, compacted by whatever ends paths.
struct Paths {
  std::size_t size = 0;
  Words sample;         ///< Which of the wave's samples.
  Keys pixel;           ///< PathKey::pixel.
  Words index;          ///< PathKey::index.
  Columns3 throughput;  ///< Product of f |cos| / p of all vertices so far (solid angle), and of roulette.
  Words materials;      ///< How the next surface scatters, a Materials.
  Keys interiors;       ///< That they are in: Interiors' bits, where the scene has any.
  Words bounces;        ///< BounceCounts, where any kind of bounce has a limit.
  Floats eta_squared;   ///< Product of eta^2: where the camera is, radiance is that much smaller.
  Columns3 direction;   ///< Of the current ray, of any length.
  // Where the scene has textures:
  Floats cone_width;   ///< of the cone around the ray, where it starts or, once the paths have arrived, ends;
  Floats cone_spread;  ///< RayCone.

  Interiors interiors_at(std::size_t i) const { return Interiors(interiors.at(i)); }
};

/// Points of triangles, before they are worked out.
struct TrianglePoints {
  Columns3 a, b, c;  ///< Corners.
  Floats u, v;       ///< Weights of b and c.
};

/// Where points lie on surfaces, as SurfacePoint has it.
struct Points {
  Columns3 position;
  Columns3 normal;  ///< The geometric one.
  Floats offset;
};

/// The surfaces that the paths have come to: an Interaction each.
struct Surfaces {
  TrianglePoints triangle;
  Columns3 normal_a, normal_b, normal_c;  ///< At the corners; zero without.
  Points point;
  Columns3 shading;      ///< First the interpolated normal, then the one of the frame, on the viewer's side.
  Floats facing;         ///< 1, or -1 where the geometric normal looks away from the viewer.
  Floats wo_z;           ///< Cosine of the direction to the viewer and the shading normal.
  Columns3 reflectance;  ///< Of Lambert surfaces; the albedo of others.
  Words lets_through;    ///< 1 where light from behind counts, as a Receiver has it.
};

/// A surface that is not Lambert's, or a point in a medium: what it scatters is worked out alone, by the
/// functions of PathReference.
struct OtherSurface {
  std::uint32_t index;  ///< Among the surfaces.
  Interaction at;
  Rgb throughput = {};            ///< Of the path that has come there.
  ScatteredLight scattered = {};  ///< Direct light, where its parts are asked for.

  /// Makes the interaction, which is large, where it stays.
  OtherSurface(std::size_t i, const BsdfTable& bsdfs, const SurfacePoint& point, const Vec3& wo,
               const Viewing& viewing)
      : index(std::uint32_t(i)), at(bsdfs, point, wo, viewing) {}
  OtherSurface(std::size_t i, const Interaction& interaction) : index(std::uint32_t(i)), at(interaction) {}
};

/// A path that has gone from another surface into the body below it.
struct BodyWalk {
  std::uint32_t other;  ///< Among the other surfaces.
  WalkDraws draws;
  Rgb throughput;  ///< Of the path where the walk begins.
  WalkBelow walk;
};

/// A ray between surfaces.
struct PassingPath {
  std::uint32_t index;  ///< Of its path, or of the surface that it comes from.
  PassingRay ray;

  /// Makes the ray, which is large, where it stays.
  PassingPath(std::uint32_t i, const Passages& passages, const Way& way) : index(i), ray(passages, way) {}
};

/// Light that may arrive at each surface: a LightSample each, its shadow ray in parts.
struct LightSamples {
  Floats ux, uy;            ///< The draws.
  TrianglePoints triangle;  ///< Of a mesh light: on it.
  Floats density;           ///< Likewise: per area, times the light's area.
  Points point;
  Columns3 direction;
  Columns3 radiance;
  Floats pdf;
  Columns3 origin, towards;
  Floats t_max;
  Words source;  ///< Of a group of lights: the one that was chosen.

  Ray ray(std::size_t i) const {
    return {.origin = origin.at(i), .direction = towards.at(i), .t_max = t_max[i]};
  }
};

/// Which light of a group each surface is lit by.
struct LightPicks {
  Words light;         ///< Of the scene; 0 where there is none.
  Floats probability;  ///< That it is chosen; 0 where none is.
  Floats finer;        ///< LightSet::finer_bits of the draws.
};

/// What each surface receives of the corners of a light's patches; of as many as it has.
struct PatchCorners {
  Floats weights[PatchLight::most][4];
};

/// What of it is scattered to the viewer.
struct Connections {
  Columns3 scattered;       ///< f L |cos|; zero where nothing is.
  std::size_t size = 0;     ///< How many are not black:
  Words surface;            ///< the surface of each of those, in order,
  std::vector<Ray> rays;    ///< and its ray towards the light.
  std::vector<Hit> hits;    ///< What these hit, by hemisphere sampling,
  std::vector<Rgb> passed;  ///< and what interiors leave on the way there.
  Columns3 arriving;        ///< Visibility, or the radiance that was found; for each surface.
  Columns3 of_light, sum;   ///< Added up so far, for each surface.
};

/// All of it, for one thread.
struct Wave {
  Paths paths;
  Surfaces surfaces;
  PatchCorners corners;
  LightPicks picks;
  LightSamples light;
  Connections connections;
  std::vector<OtherSurface> others;         ///< In the order of the surfaces.
  std::vector<std::uint32_t> alone;         ///< Which of these no lanes know.
  std::vector<std::uint32_t> placed_alone;  ///< The surfaces whose points no lanes find.
  LambertSurfaces lambert;                  ///< Those that lanes know, by their lobes.
  CoatedDiffuseSurfaces coated_diffuse;
  RoughConductorSurfaces rough_conductor;
  PrincipledSurfaces principled;
  std::vector<BodyWalk> walks;       ///< Of the paths that have gone into bodies from their last surfaces.
  std::vector<PassingPath> passing;  ///< Rays of paths, or towards lights, between surfaces.
  std::vector<std::uint32_t> going;  ///< Which of either go on,
  std::vector<Ray> followed_rays;    ///< by these rays,
  std::vector<Hit> followed_hits;    ///< which hit this.
  Columns3 scattered_at_lobes;       ///< Of a light's sample, at a list's surfaces.
  LobePaths lobe_paths;
  Floats ux, uy;        ///< Draws of a direction, or of roulette.
  Floats lobe, unused;  ///< Draws of how other surfaces scatter, and what comes with them.
  Floats flight;        ///< Of how far paths get in media that scatter,
  Floats glow;          ///< and where they see media that emit;
  std::vector<std::optional<Flight>> flights;  ///< where they start in one, by that.
  // Where there are textures: where they are asked for, and draws of their pixels (TexturePoint).
  Floats texture_u, texture_v, footprint;
  Floats second_u, second_v, second_footprint;  ///< Where a mesh has a second set of coordinates.
  Floats texture_x, texture_y;
  Words kept;     ///< The paths that go on; until they arrive, the surfaces that they come from.
  Floats pdf;     ///< At each surface: of the direction that goes on, per solid angle.
  Words kind;     ///< Likewise: how it is scattered, a ScatterKind; where that has a limit.
  Words seeking;  ///< Likewise: which light its ray is to bring, a Seeking.
  Words follows;  ///< Of each sample: 1 where its path was scattered by mirrors and the like alone.
  // Of each sample, where the light's parts are asked for: its FirstScattering.
  Words first_is_other;  ///< 0 where it is that of a matte surface; else 1, and it is
  Columns3 first_diffuse;
  Words first_transmitted;
  std::vector<Rgb> group_sums;  ///< Of each path, where light groups are asked for: LightGroups' sums.
  std::vector<Environment::View> views;  ///< Of some rays that leave the scene: those of distant lights.
  Columns3 origin;                       ///< Of their rays.
  std::vector<Ray> rays;                 ///< Of the paths, as accelerators take them.
  std::vector<Hit> hits;
};

}  // namespace twinray
