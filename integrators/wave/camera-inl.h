// SPDX-License-Identifier: Apache-2.0
// Private: camera rays in lanes, compiled once for each instruction set: places in pixels
// (core/filter_sampler.h) and the directions of a pinhole's rays (core/camera.h).
#if defined(TWINRAY_WAVE_CAMERA_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TWINRAY_WAVE_CAMERA_INL_H
#undef TWINRAY_WAVE_CAMERA_INL_H
#else
#define TWINRAY_WAVE_CAMERA_INL_H
#endif

#include "core/filter_sampler.h"
#include "integrators/wave/lanes-inl.h"
#include "integrators/wave/requests.h"

HWY_BEFORE_NAMESPACE();
namespace twinray::HWY_NAMESPACE {

/// FilterSampler::Lobe::at; something in the lobe where t is not in [0, 1].
HWY_ATTR HWY_INLINE Lanes lobe_at(const FilterSampler::Lobe& lobe, Lanes t) {
  const hn::RebindToSigned<FloatTag> integers;
  const Lanes one = splat(1), steps = splat(float(FilterSampler::steps));
  const Lanes place = hn::Mul(hn::Sub(one, hn::Sqrt(hn::Sub(one, t))), steps);
  const auto last = hn::Set(integers, int(FilterSampler::steps) - 1);
  const auto i = hn::Max(hn::Zero(integers), hn::Min(hn::ConvertTo(integers, place), last));
  const Lanes begin = hn::GatherIndex(FloatTag(), lobe.quantiles.data(), i);
  const Lanes end = hn::GatherIndex(FloatTag(), lobe.quantiles.data() + 1, i);
  return hn::Add(begin, hn::Mul(hn::Sub(end, begin), hn::Sub(place, hn::ConvertTo(FloatTag(), i))));
}

/// FilterSampler::Axis::sample.
HWY_ATTR HWY_INLINE Lanes sample_axis(const FilterSampler::Axis& axis, Lanes u, Lanes& weight) {
  const Lanes half = splat(0.5f);
  if (axis.is_box) return hn::Add(splat(0.5f - axis.radius), hn::Mul(splat(2 * axis.radius), u));
  const Lanes v = hn::Abs(hn::Sub(hn::Mul(splat(2), u), splat(1)));
  const Lanes share = splat(axis.inner.share), total = splat(axis.total);
  Lanes distance = lobe_at(axis.inner, hn::Div(v, share));
  if (axis.outer.share == 0) {
    weight = hn::Mul(weight, total);
  } else {
    const LaneMask is_inner = hn::Lt(v, share);
    const Lanes outer = lobe_at(axis.outer, hn::Div(hn::Sub(v, share), splat(axis.outer.share)));
    distance = select(is_inner, distance, outer);
    weight = hn::Mul(weight, select(is_inner, total, hn::Neg(total)));
  }
  return select(hn::Lt(u, half), hn::Sub(half, distance), hn::Add(half, distance));
}

HWY_ATTR void place_in_pixels(const FilterSampler& filter, std::size_t size, Floats& x, Floats& y,
                              Floats& weights) {
  for (std::size_t i = 0; i < size; i += lane_count) {
    Lanes weight = splat(1);
    store(sample_axis(filter.x(), load(x, i), weight), x, i);
    store(sample_axis(filter.y(), load(y, i), weight), y, i);
    store(weight, weights, i);
  }
}

HWY_ATTR void aim_pinhole(const PinholeRequest& request, const Floats& x, const Floats& y, std::size_t size,
                          Columns3& directions) {
  const Camera& camera = request.camera;
  const auto axis = [](const Vec3& v) HWY_ATTR { return splat(v.x, v.y, v.z); };
  const Lanes3 right = axis(camera.right), up = axis(camera.up), forward = axis(camera.forward);
  const Lanes one = splat(1), two = splat(2);
  for (std::size_t i = 0; i < size; i += lane_count) {
    const Lanes frame_x = hn::Div(load(x, i), splat(float(request.width)));
    const Lanes frame_y = hn::Div(load(y, i), splat(float(request.height)));
    const Lanes across = hn::Add(hn::Mul(hn::Sub(hn::Mul(two, frame_x), one), splat(camera.tan_half_width)),
                                 splat(camera.frame_center.x));
    const Lanes above = hn::Add(hn::Mul(hn::Sub(one, hn::Mul(two, frame_y)), splat(camera.tan_half_height)),
                                splat(camera.frame_center.y));
    store(forward + right * across + up * above, directions, i);
  }
}

}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
