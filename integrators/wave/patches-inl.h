// SPDX-License-Identifier: Apache-2.0
// Private: points of lights of few patches (core/light_patch.h) in lanes, compiled once for each instruction
// set.
#if defined(TWINRAY_WAVE_PATCHES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TWINRAY_WAVE_PATCHES_INL_H
#undef TWINRAY_WAVE_PATCHES_INL_H
#else
#define TWINRAY_WAVE_PATCHES_INL_H
#endif

#include "integrators/wave/receivers-inl.h"
#include "integrators/wave/requests.h"

HWY_BEFORE_NAMESPACE();
namespace twinray::HWY_NAMESPACE {

/// The weights of a patch's corners.
struct CornerLanes {
  Lanes at[4];

  // Written out, for GCC makes its own without the instruction set, and NEON's vectors have constructors.
  HWY_ATTR HWY_INLINE CornerLanes() {}
};

/// What a side emits, by its cosine to the front.
HWY_ATTR HWY_INLINE Lanes emitted(EmissionSide side, Lanes front) {
  if (side == EmissionSide::both) return hn::Abs(front);
  return positive(side == EmissionSide::front ? front : hn::Neg(front));
}

/// Side: an EmissionSide, or one of each lane.
template <typename Side>
HWY_ATTR HWY_INLINE Lanes corner_weight(const ReceiverLanes& receivers, const Lanes3& corner,
                                        const Lanes3& emitter, const Side& side) {
  const Lanes3 between = corner - receivers.position;
  const Lanes squared = dot(between, between);
  const Lanes front = hn::Neg(dot(emitter, between));
  return hn::Mul(hn::Div(positive(facing(receivers, between)), squared),
                 hn::Div(emitted(side, front), squared));
}

/// That a patch of this share is chosen.
HWY_ATTR HWY_INLINE Lanes probability(Lanes share, const CornerLanes& corners) {
  const auto& [a, b, c, d] = corners.at;
  return hn::Mul(share, hn::Mul(splat(0.25f), hn::Add(hn::Add(a, b), hn::Add(c, d))));
}
HWY_ATTR HWY_INLINE Lanes probability(const LightPatch& patch, const CornerLanes& corners) {
  return probability(splat(patch.share), corners);
}

/// Makes weights relative to their mean over the light, which no point gets much too little of.
HWY_ATTR HWY_INLINE void normalise(CornerLanes& weights, Lanes mean) {
  const LaneMask is_known = is_positive_and_finite(mean);
  const Lanes floor = splat(PatchLight::floor), scale = splat(1 / (1 + PatchLight::floor));
  for (Lanes& weight : weights.at)
    weight = select(is_known, hn::Mul(hn::Add(hn::Div(weight, mean), floor), scale), splat(1));
}

/// The constructor of PatchWeights.
HWY_ATTR HWY_INLINE void weigh_corners(const PatchLight& light, const ReceiverLanes& receivers,
                                       CornerLanes* weights) {
  Lanes mean = hn::Zero(FloatTag());
  for (std::size_t i = 0; i < light.patches.size(); ++i) {
    const LightPatch& patch = light.patches[i];
    const Lanes3 emitter = splat(patch.normal);
    for (std::size_t k = 0; k < 4; ++k)
      weights[i].at[k] = corner_weight(receivers, splat(patch.corners[k]), emitter, light.side);
    mean = hn::Add(mean, probability(patch, weights[i]));
  }
  for (std::size_t i = 0; i < light.patches.size(); ++i) normalise(weights[i], mean);
}

/// Where in a patch a draw falls, and its corners' weights.
struct PatchDraw {
  Lanes within;
  CornerLanes corners;
};
/// Which patch a draw falls on, and where in it.
struct PatchChoice {
  Lanes index;
  PatchDraw draw;
};
HWY_ATTR HWY_INLINE Lanes within_unit(Lanes a) { return hn::Min(a, splat(0x1.fffffep-1f)); }
HWY_ATTR HWY_INLINE PatchChoice choose_patch(const PatchLight& light, const CornerLanes* weights, Lanes u) {
  Lanes total = hn::Zero(FloatTag());
  for (std::size_t i = 0; i < light.patches.size(); ++i)
    total = hn::Add(total, probability(light.patches[i], weights[i]));
  const Lanes target = hn::Mul(u, total);
  Lanes index = hn::Zero(FloatTag()), before = index, sum = index;
  Lanes own = probability(light.patches[0], weights[0]);
  CornerLanes corners = weights[0];
  for (std::size_t i = 1; i < light.patches.size(); ++i) {
    sum = hn::Add(sum, probability(light.patches[i - 1], weights[i - 1]));
    const LaneMask is_later = hn::Le(sum, target);
    index = select(is_later, splat(float(i)), index);
    before = select(is_later, sum, before);
    own = select(is_later, probability(light.patches[i], weights[i]), own);
    for (std::size_t k = 0; k < 4; ++k) corners.at[k] = select(is_later, weights[i].at[k], corners.at[k]);
  }
  return {index, {within_unit(hn::Div(hn::Sub(target, before), own)), corners}};
}

HWY_ATTR HWY_INLINE Lanes linear_sample(Lanes u, Lanes a, Lanes b) {
  const Lanes one = splat(1);
  const Lanes squares = hn::Add(hn::Mul(hn::Mul(a, a), hn::Sub(one, u)), hn::Mul(hn::Mul(b, b), u));
  return hn::Min(hn::Div(hn::Mul(u, hn::Add(a, b)), hn::Add(a, hn::Sqrt(squares))), one);
}
/// a (1 - t) + b t.
HWY_ATTR HWY_INLINE Lanes mix_of(Lanes a, Lanes b, Lanes t) {
  return hn::Add(hn::Mul(a, hn::Sub(splat(1), t)), hn::Mul(b, t));
}

/// A point of the patch's square.
struct SquareLanes {
  Lanes x, y, density;
};
HWY_ATTR HWY_INLINE SquareLanes choose_in_square(const PatchDraw& draw, Lanes v) {
  const auto& [a, b, c, d] = draw.corners.at;
  const Lanes y = linear_sample(v, hn::Add(a, b), hn::Add(d, c));
  const Lanes left = mix_of(a, d, y), right = mix_of(b, c, y);
  const Lanes x = linear_sample(draw.within, left, right);
  return {x, y, mix_of(left, right, x)};
}

/// Points of triangles, as far as their patches are known.
struct TriangleLanes {
  Lanes3 a, b, c, normal;
  Lanes offset, u, v;
};
HWY_ATTR HWY_INLINE TriangleLanes triangle_lanes(const PatchTriangle& triangle, Lanes u, Lanes v) {
  return {splat(triangle.a),
          splat(triangle.b),
          splat(triangle.c),
          splat(triangle.normal),
          splat(triangle.offset),
          u,
          v};
}
HWY_ATTR HWY_INLINE TriangleLanes select(LaneMask mask, const TriangleLanes& yes, const TriangleLanes& no) {
  return {select(mask, yes.a, no.a),
          select(mask, yes.b, no.b),
          select(mask, yes.c, no.c),
          select(mask, yes.normal, no.normal),
          select(mask, yes.offset, no.offset),
          select(mask, yes.u, no.u),
          select(mask, yes.v, no.v)};
}

/// The point of a patch's square on the patch.
HWY_ATTR HWY_INLINE TriangleLanes point_of_patch(const LightPatch& patch, const PatchTriangle* triangles,
                                                 const SquareLanes& at) {
  const Lanes x = at.x, y = at.y, one = splat(1), zero = hn::Zero(FloatTag());
  if (!patch.is_parallelogram) {
    const Lanes half = hn::Mul(splat(0.5f), hn::Min(x, y));
    return triangle_lanes(triangles[0], hn::Sub(x, half), hn::Sub(y, half));
  }
  const Lanes below[] = {hn::Sub(one, x), hn::Sub(x, y), y, zero};
  const Lanes above[] = {hn::Sub(one, y), zero, x, hn::Sub(y, x)};
  const auto& [first, second] = patch.corner_of;
  return select(hn::Le(y, x), triangle_lanes(triangles[0], below[first[1]], below[first[2]]),
                triangle_lanes(triangles[1], above[second[1]], above[second[2]]));
}

HWY_ATTR HWY_INLINE void store_triangle(const TriangleLanes& point, Lanes density, LightSamples& samples,
                                        std::size_t i) {
  store(point.a, samples.triangle.a, i);
  store(point.b, samples.triangle.b, i);
  store(point.c, samples.triangle.c, i);
  store(point.u, samples.triangle.u, i);
  store(point.v, samples.triangle.v, i);
  store(point.normal, samples.point.normal, i);
  store(point.offset, samples.point.offset, i);
  store(density, samples.density, i);
}

HWY_ATTR void weigh_patches(const PatchLight& light, const Surfaces& surfaces, std::size_t size,
                            PatchCorners& corners) {
  CornerLanes weights[PatchLight::most];
  for (std::size_t i = 0; i < size; i += lane_count) {
    weigh_corners(light, load_receivers(surfaces, i), weights);
    for (std::size_t patch = 0; patch < light.patches.size(); ++patch)
      for (std::size_t k = 0; k < 4; ++k) store(weights[patch].at[k], corners.weights[patch][k], i);
  }
}

HWY_ATTR void choose_of_patches(const PatchTable& table, const PatchCorners& corners, LightSamples& samples,
                                std::size_t size) {
  const PatchLight& light = *table.light;
  CornerLanes weights[PatchLight::most];
  for (std::size_t i = 0; i < size; i += lane_count) {
    for (std::size_t patch = 0; patch < light.patches.size(); ++patch)
      for (std::size_t k = 0; k < 4; ++k) weights[patch].at[k] = load(corners.weights[patch][k], i);
    const PatchChoice choice = choose_patch(light, weights, load(samples.ux, i));
    const SquareLanes square = choose_in_square(choice.draw, load(samples.uy, i));
    TriangleLanes point = point_of_patch(light.patches[0], table.triangles[0], square);
    for (std::size_t k = 1; k < light.patches.size(); ++k)
      point = select(hn::Eq(choice.index, splat(float(k))),
                     point_of_patch(light.patches[k], table.triangles[k], square), point);
    store_triangle(point, square.density, samples, i);
  }
}

}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
