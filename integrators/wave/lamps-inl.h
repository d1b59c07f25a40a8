// SPDX-License-Identifier: Apache-2.0
// Private: samples of lamps of one patch, each surface of a lamp of its own, in lanes, compiled once for each
// instruction set.
#if defined(TWINRAY_WAVE_LAMPS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TWINRAY_WAVE_LAMPS_INL_H
#undef TWINRAY_WAVE_LAMPS_INL_H
#else
#define TWINRAY_WAVE_LAMPS_INL_H
#endif

#include <span>

#include "integrators/wave/fetch-inl.h"
#include "integrators/wave/light-inl.h"
#include "integrators/wave/patches-inl.h"

HWY_BEFORE_NAMESPACE();
namespace twinray::HWY_NAMESPACE {

/// On which sides lamps emit.
struct SideLanes {
  LaneMask both, front;
};
HWY_ATTR HWY_INLINE SideLanes side_lanes(WordLanes side) {
  const auto is = [&](EmissionSide kind) HWY_ATTR {
    return hn::RebindMask(FloatTag(), hn::Eq(side, hn::Set(WordTag(), std::uint32_t(kind))));
  };
  return {is(EmissionSide::both), is(EmissionSide::front)};
}
HWY_ATTR HWY_INLINE Lanes emitted(const SideLanes& side, Lanes front) {
  const Lanes one_side = select(side.front, positive(front), positive(hn::Neg(front)));
  return select(side.both, hn::Abs(front), one_side);
}
HWY_ATTR HWY_INLINE LaneMask emits(const SideLanes& side, Lanes cos_front) {
  const Lanes zero = hn::Zero(FloatTag());
  // By selected numbers, for masks have no such operation everywhere.
  const Lanes seen = select(side.both, hn::Abs(cos_front), select(side.front, cos_front, hn::Neg(cos_front)));
  return hn::Gt(seen, zero);
}

/// The density of the corners over a lamp: PatchWeights of one patch.
HWY_ATTR HWY_INLINE CornerLanes weigh_corners(const Lamp& lamp, const Fetch& fetch, const SideLanes& side,
                                              Lanes share, const ReceiverLanes& receivers) {
  const Lanes3 emitter = fetch.vector(lamp.normal);
  CornerLanes weights;
  for (std::size_t k = 0; k < 4; ++k)
    weights.at[k] = corner_weight(receivers, fetch.vector(lamp.corners[k]), emitter, side);
  normalise(weights, probability(share, weights));
  return weights;
}

/// One of four numbers of each lane.
HWY_ATTR HWY_INLINE Lanes one_of(const Lanes (&numbers)[4], WordLanes index) {
  Lanes found = numbers[0];
  for (std::uint32_t k = 1; k < 4; ++k)
    found = select(hn::RebindMask(FloatTag(), hn::Eq(index, hn::Set(WordTag(), k))), numbers[k], found);
  return found;
}

/// The point of a lamp's square on its triangles.
HWY_ATTR HWY_INLINE TriangleLanes point_of_lamp(const Lamp& lamp, const Fetch& fetch, const SquareLanes& at) {
  const Lanes x = at.x, y = at.y, one = splat(1), zero = hn::Zero(FloatTag());
  const LaneMask is_first = hn::Le(y, x);
  const auto of_half = [&](const auto& get, const auto& first, const auto& second)
                           HWY_ATTR { return select(is_first, get(first), get(second)); };
  const auto vector = [&](const Vec3& v) HWY_ATTR { return fetch.vector(v); };
  const auto number = [&](const float& v) HWY_ATTR { return fetch.number(v); };
  const Lanes shares[] = {select(is_first, hn::Sub(one, x), hn::Sub(one, y)),
                          select(is_first, hn::Sub(x, y), zero), select(is_first, y, x),
                          select(is_first, zero, hn::Sub(y, x))};
  const auto corner = [&](const std::uint32_t(&corners)[2]) HWY_ATTR {
    const auto first = hn::RebindMask(WordTag(), is_first);
    return hn::IfThenElse(first, fetch.word(corners[0]), fetch.word(corners[1]));
  };
  const auto is_single = hn::Eq(fetch.word(lamp.is_parallelogram), hn::Zero(WordTag()));
  const LaneMask is_triangle = hn::RebindMask(FloatTag(), is_single);
  const Lanes half = hn::Mul(splat(0.5f), hn::Min(x, y));
  const auto& [first, second] = lamp.triangles;
  return {of_half(vector, first.a, second.a),
          of_half(vector, first.b, second.b),
          of_half(vector, first.c, second.c),
          of_half(vector, first.normal, second.normal),
          of_half(number, first.offset, second.offset),
          select(is_triangle, hn::Sub(x, half), one_of(shares, corner(lamp.second_corner))),
          select(is_triangle, hn::Sub(y, half), one_of(shares, corner(lamp.third_corner)))};
}

/// What each lane's own lamp emits.
struct LampEmission {
  Lanes3 radiance;
  SideLanes side;
  DoubleHalves area;
};

HWY_ATTR void sample_lamps(std::span<const Lamp> lamps, const LightPicks& picks, const Surfaces& surfaces,
                           LightSamples& samples, std::size_t size) {
  const Lamp& lamp = lamps.front();
  for (std::size_t i = 0; i < size; i += lane_count) {
    const Fetch fetch(load(picks.light, i), sizeof(Lamp));
    const SideLanes side = side_lanes(fetch.word(lamp.side));
    const Lanes share = fetch.number(lamp.share);
    const CornerLanes weights = weigh_corners(lamp, fetch, side, share, load_receivers(surfaces, i));
    const Lanes own = probability(share, weights);
    const Lanes within = hn::Div(hn::Mul(load(samples.ux, i), own), own);
    const SquareLanes square = choose_in_square({within_unit(within), weights}, load(samples.uy, i));
    store_triangle(point_of_lamp(lamp, fetch, square), square.density, samples, i);

    const LongHalves area = join(fetch.word(lamp.area_low), fetch.word(lamp.area_high));
    const Lanes3 radiance{fetch.number(lamp.radiance.r), fetch.number(lamp.radiance.g),
                          fetch.number(lamp.radiance.b)};
    const DoubleTag doubles;
    sample_emitter(
        surfaces,
        LampEmission{radiance, side, {hn::BitCast(doubles, area.lower), hn::BitCast(doubles, area.upper)}},
        samples, i);
    const Lanes pdf = hn::Mul(load(samples.pdf, i), load(picks.probability, i));
    const LaneMask is_chosen = is_positive(pdf);
    store(select(is_chosen, pdf, splat(1)), samples.pdf, i);
    store(zero_unless(is_chosen, load(samples.radiance, i)), samples.radiance, i);
  }
}

}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
