// SPDX-License-Identifier: Apache-2.0
// Private: surfaces whose scattering lanes work out, a list for each kind of lobe: number k of each column
// belongs to the k-th of them.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/lobes/coated_diffuse.h"
#include "core/lobes/lambert.h"
#include "core/lobes/principled.h"
#include "core/lobes/rough_conductor.h"
#include "integrators/interaction.h"
#include "integrators/wave/columns.h"

namespace twinray {

/// What all of these lobes have: an Interaction.
struct LobeSurfaces {
  std::size_t size = 0;
  bool has_maps = false;                ///< Whether maps bend the normals of some.
  Words surface;                        ///< Which of the wave's surfaces, in their order.
  Columns3 tangent, bitangent, normal;  ///< Interaction::frame.
  Columns3 wo;                          ///< Interaction::wo_local.
  Floats terminator;                    ///< Interaction::terminator_alpha_squared.
  Columns3 throughput;                  ///< Of the path that has come there.

  void clear();

 protected:
  void add(std::size_t surface, const Interaction& at);
};

/// Lambert surfaces whose normals maps bend.
struct LambertSurfaces : LobeSurfaces {
  Columns3 reflectance;

  void add(std::size_t surface, const Interaction& at, const LambertLobe& lobe);
};

/// Alphas of facets.
struct FacetColumns {
  Floats x, y;

  void set(std::size_t i, const Ggx& facets);
};

/// Coats, as Coat has them; not rough ones of two alphas.
struct CoatColumns {
  FacetColumns facets;  ///< 0 if they are smooth.
  Floats ior;
  Words row;  ///< Where GgxDielectricReflectance::row of a rough coat begins in `rows`.
  std::vector<std::array<float, 16>> rows;  ///< Those of neighbours are often the same.

  void set(std::size_t i, const Coat& coat);
};

struct CoatedDiffuseSurfaces : LobeSurfaces {
  CoatColumns coat;
  Floats average;  ///< What the coat reflects of light from all directions.
  Columns3 base;   ///< CoatedDiffuseLobe::base.

  void clear();
  void add(std::size_t surface, const Interaction& at, const CoatedDiffuseLobe& lobe);
};

/// MultipleScattering, and the lobe's factor of it.
struct MultipleColumns {
  Floats alpha, average_loss;
  Columns3 factor;

  void set(std::size_t i, const MultipleScattering& multiple, const Rgb& factor);
};

struct RoughConductorSurfaces : LobeSurfaces {
  FacetColumns facets;
  Columns3 eta, k, reflectance;  ///< As the lobe has them.
  MultipleColumns multiple;
  Floats most_once, most_multiple;  ///< The largest channels: average_fresnel's, the factor's.

  void add(std::size_t surface, const Interaction& at, const RoughConductorLobe& lobe);
};

/// Principled surfaces of metal and gloss alone: PrincipledLobe::bare.
struct PrincipledSurfaces : LobeSurfaces {
  Floats metal, opaque;              ///< Weights.
  Columns3 metal_normal, metal_dip;  ///< TintedFresnel.
  MultipleColumns multiple;
  CoatColumns gloss;
  Columns3 specular_color;
  Columns3 diffuse;
  Floats roughness, scale, average, several;  ///< RoughDiffuseLobe; the last one is gray.

  void clear();
  void add(std::size_t surface, const Interaction& at, const BarePrincipled& base);
};

/// Where the paths go on that have come to a list's surfaces: Scattering, but for what does not change. The
/// throughput of paths that end is black.
struct LobePaths {
  Columns3 throughput, direction, origin;
  Floats pdf;
  Words seeking, kind;
};

}  // namespace twinray
