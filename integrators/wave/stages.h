// SPDX-License-Identifier: Apache-2.0
// Private: the stages of a wave that run in lanes, compiled once for each instruction set. Each gives the
// bits of the scalar code that it names, for the first `size` paths.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/filter_sampler.h"
#include "integrators/wave/requests.h"
#include "integrators/wave/wave.h"

namespace twinray {

/// What lanes do at surfaces with one kind of lobe.
template <typename Lobes>
struct LobeStages {
  /// LightSamples -> what each of the list's surfaces scatters of them: scattered_sample, but for what
  /// interiors absorb.
  void (*scatter_light)(const Lobes&, const Surfaces&, const LightSamples&, const MisRequest&,
                        Columns3& scattered);
  /// Draws of a direction -> where the paths of the list's surfaces go on: twinray::scatter.
  void (*scatter_paths)(const Lobes&, const Surfaces&, const DirectionDraws&, LobePaths&);
};

struct WaveStages {
  std::string name;  ///< Of the instruction set: "avx512", "avx2", "sse4".
  /// Keys of pixels, indices of samples -> draws in the unit square.
  void (*draw)(const Keys& pixels, const Words& index, std::size_t size, const DrawRequest&, Floats& x,
               Floats& y);
  /// Draws -> places in pixels, and their weights: FilterSampler::place.
  void (*place_in_pixels)(const FilterSampler&, std::size_t size, Floats& x, Floats& y, Floats& weights);
  /// Places in the frame, in pixels -> directions: camera_ray.
  void (*aim_pinhole)(const PinholeRequest&, const Floats& x, const Floats& y, std::size_t size,
                      Columns3& directions);
  /// Corners -> Points::normal, offset: Facet.
  void (*find_facets)(const TrianglePoints&, Points&, std::size_t size);
  /// Surfaces::triangle, normal_a, b, c -> point.position, shading: triangle_point and the shading normal.
  void (*find_points)(Surfaces&, std::size_t size);
  /// Surfaces -> shading, facing, wo_z: Interaction.
  void (*find_interactions)(const Paths&, Surfaces&);
  /// Surfaces -> what they receive of the light's corners: the constructor of PatchWeights.
  void (*weigh_patches)(const PatchLight&, const Surfaces&, std::size_t size, PatchCorners&);
  /// That and draws -> LightSamples::triangle, point.normal, point.offset, density: PatchWeights::choose.
  void (*choose_of_patches)(const PatchTable&, const PatchCorners&, LightSamples&, std::size_t size);
  /// LightSamples::triangle, point.normal, point.offset, density -> the rest of them: LightSet::sample of a
  /// mesh light.
  void (*sample_mesh_light)(const Surfaces&, const MeshLightRequest&, LightSamples&, std::size_t size);
  /// Draws -> which of a group's lights, and what is left of the draws: LightTree::pick.
  void (*choose_lights)(const LightSet::Group&, const Surfaces&, Floats& u, std::size_t size, LightPicks&);
  /// Both -> LightSamples: LightSet::sample_chosen, where the lights are lamps. One for each
  /// light of the scene.
  void (*sample_lamps)(std::span<const Lamp>, const LightPicks&, const Surfaces&, LightSamples&,
                       std::size_t size);
  /// Draws -> LightSamples: LightSet::sample of a sphere light.
  void (*sample_sphere_light)(const Surfaces&, const SphereLightRequest&, LightSamples&, std::size_t size);
  /// Draws -> directions, with the radiance 1: uniform in the hemisphere.
  void (*sample_hemisphere)(const Surfaces&, LightSamples&, std::size_t size);
  /// LightSamples -> Connections::scattered: Interaction::scattered of Lambert surfaces times the radiance
  /// and the weight.
  void (*scatter_light)(const Surfaces&, const LightSamples&, std::size_t size, const MisRequest&,
                        Connections&);
  /// Connections::scattered -> size, surface, rays.
  void (*make_shadow_rays)(const LightSamples&, std::size_t size, Connections&);
  /// Connections::scattered * arriving / pdf, added to of_light.
  void (*add_connections)(const LightSamples&, std::size_t size, Connections&);
  /// Draws of a direction -> throughput, direction, pdf, origin: Bsdf::sample of Lambert surfaces, and
  /// spawn_ray. The throughput of paths that end is black.
  void (*scatter_paths)(const Surfaces&, Wave&);
  /// Throughput -> kept: the paths that go on. Returns how many.
  std::size_t (*keep_paths)(Wave&);
  /// Moves numbers kept[0] < kept[1] < ... of a column to its front.
  void (*move_up_words)(const Words& kept, std::size_t size, Words& column);
  void (*move_up_floats)(const Words& kept, std::size_t size, Floats& column);
  LobeStages<LambertSurfaces> lambert;
  LobeStages<CoatedDiffuseSurfaces> coated_diffuse;
  LobeStages<RoughConductorSurfaces> rough_conductor;
  LobeStages<PrincipledSurfaces> principled;
};

/// Those that this machine can run, the fastest first; none where it has no such instruction set.
std::vector<WaveStages> wave_stages();

/// Those of one of available_instruction_sets(); none for "scalar", or where this machine has no lanes.
std::optional<WaveStages> wave_stages_of(const std::string& simd);

}  // namespace twinray
