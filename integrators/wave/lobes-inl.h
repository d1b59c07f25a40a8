// SPDX-License-Identifier: Apache-2.0
// Private: what surfaces scatter whose lobes are known in lanes, compiled once for each instruction set. A
// class of lanes stands for a lobe: it is made of a list's surfaces, evaluates and samples.
#if defined(TWINRAY_WAVE_LOBES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TWINRAY_WAVE_LOBES_INL_H
#undef TWINRAY_WAVE_LOBES_INL_H
#else
#define TWINRAY_WAVE_LOBES_INL_H
#endif

#include "integrators/scattering.h"
#include "integrators/wave/facets-inl.h"
#include "integrators/wave/lobe_surfaces.h"
#include "integrators/wave/requests.h"
#include "integrators/wave/surfaces-inl.h"

HWY_BEFORE_NAMESPACE();
namespace twinray::HWY_NAMESPACE {

/// BsdfValue.
struct BsdfLanes {
  Lanes3 value;
  Lanes pdf;
};

/// BsdfSample.
struct BsdfSampleLanes {
  Lanes3 wi;
  Lanes3 value;
  Lanes pdf;
  LaneMask is_delta, is_diffuse;
};

/// From number k on; 0 behind the last of them.
HWY_ATTR HWY_INLINE IndexLanes indices(const Words& column, std::size_t k, std::size_t size) {
  const auto words = hn::IfThenElseZero(hn::FirstN(WordTag(), size - k), load(column, k));
  return hn::BitCast(IndexTag(), words);
}
HWY_ATTR HWY_INLINE Lanes gather(const Floats& column, IndexLanes index) {
  return hn::GatherIndex(FloatTag(), column.values, index);
}
HWY_ATTR HWY_INLINE Lanes3 gather(const Columns3& columns, IndexLanes index) {
  return {gather(columns.x, index), gather(columns.y, index), gather(columns.z, index)};
}

/// Interaction::is_consistent, for the cosine of a direction to the shading normal.
HWY_ATTR HWY_INLINE LaneMask is_consistent(const Surfaces& surfaces, IndexLanes surface, const Lanes3& wi,
                                           Lanes cosine) {
  const Lanes geometric =
      hn::Mul(gather(surfaces.facing, surface), dot(gather(surfaces.point.normal, surface), wi));
  return hn::Not(hn::Xor(is_positive(geometric), is_positive(cosine)));
}

template <typename LobeLanes, typename Lobes>
HWY_ATTR void scatter_light_at(const Lobes& lobes, const Surfaces& surfaces, const LightSamples& samples,
                               const MisRequest& mis, Columns3& scattered) {
  for (std::size_t k = 0; k < lobes.size; k += lane_count) {
    const IndexLanes surface = indices(lobes.surface, k, lobes.size);
    const Lanes3 wi = gather(samples.direction, surface), radiance = gather(samples.radiance, surface);
    const Lanes3 local{dot(wi, load(lobes.tangent, k)), dot(wi, load(lobes.bitangent, k)),
                       dot(wi, load(lobes.normal, k))};
    const BsdfLanes found = LobeLanes(lobes, k).evaluate(local);
    Lanes3 light = found.value * hn::Abs(local.z) * radiance;
    if (mis.is_shared) {
      const Lanes pdf = hn::Mul(splat(mis.count), gather(samples.pdf, surface));
      const Lanes ratio = hn::Div(found.pdf, pdf);
      light = light * hn::Div(splat(1), hn::Add(splat(1), hn::Mul(ratio, ratio)));
    }
    const LaneMask counts = hn::And(is_not_black(radiance), is_consistent(surfaces, surface, wi, local.z));
    store(zero_unless(counts, light), scattered, k);
  }
}

template <typename LobeLanes, typename Lobes>
HWY_ATTR void scatter_paths_at(const Lobes& lobes, const Surfaces& surfaces, const DirectionDraws& draws,
                               LobePaths& paths) {
  const auto choose = [](LaneMask mask, auto yes, auto no) HWY_ATTR {
    return hn::IfThenElse(hn::RebindMask(WordTag(), mask), hn::Set(WordTag(), std::uint32_t(yes)),
                          hn::Set(WordTag(), std::uint32_t(no)));
  };
  for (std::size_t k = 0; k < lobes.size; k += lane_count) {
    const IndexLanes surface = indices(lobes.surface, k, lobes.size);
    const BsdfSampleLanes sample = LobeLanes(lobes, k).sample(
        gather(draws.lobe, surface), gather(draws.ux, surface), gather(draws.uy, surface));
    const Lanes3 wi = load(lobes.tangent, k) * sample.wi.x + load(lobes.bitangent, k) * sample.wi.y +
                      load(lobes.normal, k) * sample.wi.z;
    const Lanes3 throughput =
        load(lobes.throughput, k) * sample.value * hn::Div(hn::Abs(sample.wi.z), sample.pdf);
    const LaneMask goes_on = hn::And(hn::Ne(sample.pdf, hn::Zero(FloatTag())),
                                     is_consistent(surfaces, surface, wi, dot(load(lobes.normal, k), wi)));
    store(zero_unless(goes_on, throughput), paths.throughput, k);
    store(wi, paths.direction, k);
    store(leave_surface(gather(surfaces.point.position, surface), gather(surfaces.point.normal, surface),
                        gather(surfaces.point.offset, surface), wi),
          paths.origin, k);
    store(sample.pdf, paths.pdf, k);
    store(choose(sample.is_delta, Seeking::alone, Seeking::all), paths.seeking, k);
    store(choose(sample.is_diffuse, ScatterKind::diffuse, ScatterKind::glossy), paths.kind, k);
  }
}

}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
