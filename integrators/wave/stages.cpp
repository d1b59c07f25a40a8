// SPDX-License-Identifier: Apache-2.0
// The stages of a wave, compiled once for each instruction set.
#include "integrators/wave/stages.h"

#include "core/instruction_sets.h"

#define HWY_TARGET_INCLUDE "integrators/wave/stages.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
#include "integrators/wave/camera-inl.h"
#include "integrators/wave/coats-inl.h"
#include "integrators/wave/draws-inl.h"
#include "integrators/wave/lambert-inl.h"
#include "integrators/wave/lamps-inl.h"
#include "integrators/wave/light-inl.h"
#include "integrators/wave/light_tree-inl.h"
#include "integrators/wave/metals-inl.h"
#include "integrators/wave/patches-inl.h"
#include "integrators/wave/principled-inl.h"
#include "integrators/wave/scatter-inl.h"
#include "integrators/wave/sphere_light-inl.h"
#include "integrators/wave/surfaces-inl.h"

HWY_BEFORE_NAMESPACE();
namespace twinray::HWY_NAMESPACE {
namespace {

template <typename LobeLanes, typename Lobes>
LobeStages<Lobes> lobe_stages() {
  return {scatter_light_at<LobeLanes, Lobes>, scatter_paths_at<LobeLanes, Lobes>};
}

WaveStages stages() {
  return {simd_name(hwy::TargetName(HWY_TARGET)),
          draw,
          place_in_pixels,
          aim_pinhole,
          find_facets,
          find_points,
          find_interactions,
          weigh_patches,
          choose_of_patches,
          sample_mesh_light,
          choose_lights,
          sample_lamps,
          sample_sphere_light,
          sample_hemisphere,
          scatter_light,
          make_shadow_rays,
          add_connections,
          scatter_paths,
          keep_paths,
          move_up_words,
          move_up_floats,
          lobe_stages<LambertLanes, LambertSurfaces>(),
          lobe_stages<CoatedDiffuseLanes, CoatedDiffuseSurfaces>(),
          lobe_stages<RoughConductorLanes, RoughConductorSurfaces>(),
          lobe_stages<PrincipledLanes, PrincipledSurfaces>()};
}

}  // namespace
}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if HWY_ONCE
#include "core/supported_sets.h"

namespace twinray {

std::vector<WaveStages> wave_stages() {
  std::vector<WaveStages> stages;
  TWINRAY_APPEND_SUPPORTED(stages, stages());
  return stages;
}

std::optional<WaveStages> wave_stages_of(const std::string& simd) {
  const std::vector<WaveStages> all = wave_stages();
  if (simd == "scalar" || all.empty()) return std::nullopt;
  return chosen(all, simd);
}

}  // namespace twinray
#endif
