// SPDX-License-Identifier: Apache-2.0
// Private: surfaces whose scattering lanes work out, a list for each kind of lobe: number k of each column
// belongs to the k-th of them.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/lobes/coated_diffuse.h"
#include "core/lobes/rough_conductor.h"
#include "integrators/interaction.h"
#include "integrators/wave/columns.h"

namespace twinray {

/// What all of these lobes have: an Interaction, and facets.
struct LobeSurfaces {
  std::size_t size = 0;
  Words surface;                        ///< Which of the wave's surfaces, in their order.
  Columns3 tangent, bitangent, normal;  ///< Interaction::frame.
  Columns3 wo;                          ///< Interaction::wo_local.
  Floats alpha_x, alpha_y;              ///< Of the facets; 0 if they are smooth.
  Columns3 throughput;                  ///< Of the path that has come there.

 protected:
  void add(std::size_t surface, const Interaction& at, float alpha_x, float alpha_y);
};

struct CoatedDiffuseSurfaces : LobeSurfaces {
  Floats ior;      ///< Of the coat.
  Floats average;  ///< What the coat reflects of light from all directions.
  Words row;       ///< Where GgxDielectricReflectance::row of a rough coat begins in `rows`.
  std::vector<std::array<float, 16>> rows;  ///< Those of neighbours are often the same.
  Columns3 base;                            ///< CoatedDiffuseLobe::base.

  void clear();
  void add(std::size_t surface, const Interaction& at, const CoatedDiffuseLobe& lobe);
};

struct RoughConductorSurfaces : LobeSurfaces {
  Columns3 eta, k, reflectance;  ///< As the lobe has them.
  Columns3 multiple_factor;
  Floats loss_alpha, average_loss;  ///< Of MultipleScattering.
  Floats most_once, most_multiple;  ///< The largest channels: average_fresnel's, multiple_factor's.

  void clear() { size = 0; }
  void add(std::size_t surface, const Interaction& at, const RoughConductorLobe& lobe);
};

/// Where the paths go on that have come to a list's surfaces: Scattering, but for what does not change. The
/// throughput of paths that end is black.
struct LobePaths {
  Columns3 throughput, direction, origin;
  Floats pdf;
  Words seeking, kind;
};

}  // namespace twinray
