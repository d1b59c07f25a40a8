// SPDX-License-Identifier: Apache-2.0
// Private: what surfaces scatter whose lobes are known in lanes, compiled once for each instruction set. A
// class of lanes stands for a lobe: it is made of a list's surfaces, evaluates, samples, and says which light
// the sampled rays seek.
#if defined(TWINRAY_WAVE_LOBES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TWINRAY_WAVE_LOBES_INL_H
#undef TWINRAY_WAVE_LOBES_INL_H
#else
#define TWINRAY_WAVE_LOBES_INL_H
#endif

#include "integrators/scattering.h"
#include "integrators/wave/facets-inl.h"
#include "integrators/wave/light-inl.h"
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

HWY_ATTR HWY_INLINE Lanes gather(const Floats& column, IndexLanes index) {
  return hn::GatherIndex(FloatTag(), column.values, index);
}
HWY_ATTR HWY_INLINE Lanes3 gather(const Columns3& columns, IndexLanes index) {
  return {gather(columns.x, index), gather(columns.y, index), gather(columns.z, index)};
}

/// For a cosine above 0; else 0.
HWY_ATTR HWY_INLINE Lanes cosine_hemisphere_pdf(Lanes cosine) { return hn::Div(positive(cosine), splat(pi)); }

/// max_component.
HWY_ATTR HWY_INLINE Lanes largest(const Lanes3& c) { return hn::Max(c.x, hn::Max(c.y, c.z)); }

/// The cosine of a direction to the geometric normal on the viewer's side.
HWY_ATTR HWY_INLINE Lanes geometric_cosine(const Surfaces& surfaces, IndexLanes surface, const Lanes3& wi) {
  return hn::Mul(gather(surfaces.facing, surface), dot(gather(surfaces.point.normal, surface), wi));
}

/// Interaction::is_consistent, for the cosines of a direction to both normals.
HWY_ATTR HWY_INLINE LaneMask is_consistent(Lanes geometric, Lanes shading) {
  return hn::Not(hn::Xor(is_positive(geometric), is_positive(shading)));
}

HWY_ATTR HWY_INLINE Lanes tan_squared(Lanes cosine) {
  const Lanes squared = not_above_1(hn::Mul(cosine, cosine)), least = splat(1e-12f);
  return hn::Div(hn::Sub(splat(1), squared), select(hn::Lt(squared, least), least, squared));
}

/// A cosine times Interaction::kept of that direction.
HWY_ATTR HWY_INLINE Lanes kept_cosine(const LobeSurfaces& lobes, std::size_t k, Lanes geometric,
                                      Lanes cosine) {
  if (!lobes.has_maps) return hn::Abs(cosine);
  const Lanes one = splat(1), slope = hn::Mul(load(lobes.terminator, k), tan_squared(geometric));
  return hn::Mul(hn::Div(splat(2), hn::Add(one, hn::Sqrt(hn::Add(one, slope)))), hn::Abs(cosine));
}

/// light_sample_weight, for the density by which a lobe scatters.
template <typename LobeLanes>
HWY_ATTR HWY_INLINE Lanes weight_at(const MisRequest& mis, const Lanes3& position, Lanes light_pdf,
                                    Lanes scattered_pdf) {
  const Lanes one = splat(1), ratio = hn::Div(scattered_pdf, hn::Mul(splat(mis.count), light_pdf));
  const Lanes weight = hn::Div(one, hn::Add(one, hn::Mul(ratio, ratio)));
  if (LobeLanes::seeking == Seeking::all) return weight;
  return select(contains(mis.zone, position), weight, one);
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
    const Lanes geometric = geometric_cosine(surfaces, surface, wi);
    Lanes3 light = found.value * kept_cosine(lobes, k, geometric, local.z) * radiance;
    if (mis.is_shared)
      light = light * weight_at<LobeLanes>(mis, gather(surfaces.point.position, surface),
                                           gather(samples.pdf, surface), found.pdf);
    const LaneMask counts = hn::And(is_not_black(radiance), is_consistent(geometric, local.z));
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
    const Lanes geometric = geometric_cosine(surfaces, surface, wi);
    const Lanes3 throughput = load(lobes.throughput, k) * sample.value *
                              hn::Div(kept_cosine(lobes, k, geometric, sample.wi.z), sample.pdf);
    const LaneMask goes_on = hn::And(hn::Ne(sample.pdf, hn::Zero(FloatTag())),
                                     is_consistent(geometric, dot(load(lobes.normal, k), wi)));
    store(zero_unless(goes_on, throughput), paths.throughput, k);
    store(wi, paths.direction, k);
    store(leave_surface(gather(surfaces.point.position, surface), gather(surfaces.point.normal, surface),
                        gather(surfaces.point.offset, surface), wi),
          paths.origin, k);
    store(sample.pdf, paths.pdf, k);
    store(choose(sample.is_delta, Seeking::alone, LobeLanes::seeking), paths.seeking, k);
    store(choose(sample.is_diffuse, ScatterKind::diffuse, ScatterKind::glossy), paths.kind, k);
  }
}

}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
