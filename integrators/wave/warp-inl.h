// SPDX-License-Identifier: Apache-2.0
// Private: the maps of core/warp.h and core/frame.h in lanes, compiled once for each instruction set.
#if defined(TWINRAY_WAVE_WARP_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TWINRAY_WAVE_WARP_INL_H
#undef TWINRAY_WAVE_WARP_INL_H
#else
#define TWINRAY_WAVE_WARP_INL_H
#endif

#include "core/warp.h"
#include "integrators/wave/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace twinray::HWY_NAMESPACE {

struct SinCosLanes {
  Lanes sin, cos;
};

/// a + b c, in two roundings.
HWY_ATTR HWY_INLINE Lanes add_product(Lanes a, Lanes b, Lanes c) { return hn::Add(a, hn::Mul(b, c)); }

HWY_ATTR HWY_INLINE SinCosLanes sincos_turns(Lanes turns) {
  const hn::RebindToSigned<FloatTag> integers;
  const auto quadrant = hn::ConvertTo(integers, add_product(splat(0.5f), turns, splat(4)));
  const Lanes x = hn::Mul(hn::Sub(turns, hn::Mul(splat(0.25f), hn::ConvertTo(FloatTag(), quadrant))),
                          splat(6.28318530717958647692f));
  const Lanes z = hn::Mul(x, x);
  const Lanes odd =
      add_product(splat(1.0f / 120), z, add_product(splat(-1.0f / 5040), z, splat(1.0f / 362880)));
  const Lanes sine = add_product(x, hn::Mul(x, z), add_product(splat(-1.0f / 6), z, odd));
  const Lanes even =
      add_product(splat(1.0f / 24), z, add_product(splat(-1.0f / 720), z, splat(1.0f / 40320)));
  const Lanes cosine = hn::Sub(splat(1), hn::Sub(hn::Mul(splat(0.5f), z), hn::Mul(hn::Mul(z, z), even)));
  const Lanes zero = hn::Zero(FloatTag());
  const auto has = [&](int bit) HWY_ATTR {
    return hn::RebindMask(FloatTag(), hn::TestBit(quadrant, hn::Set(integers, bit)));
  };
  const LaneMask swaps = has(1), turned = has(2);
  const Lanes sin = select(swaps, cosine, sine);
  const Lanes cos = select(swaps, sine, cosine);
  // 0 - x and not -x: it has no -0.
  return {select(turned, hn::Sub(zero, sin), sin), select(hn::Xor(swaps, turned), hn::Sub(zero, cos), cos)};
}

HWY_ATTR HWY_INLINE Lanes3 square_to_cosine_hemisphere(Lanes u, Lanes v) {
  const Lanes x = hn::Sub(hn::Mul(splat(2), u), splat(1)), y = hn::Sub(hn::Mul(splat(2), v), splat(1));
  const Lanes size_x = hn::Abs(x), size_y = hn::Abs(y);
  const LaneMask is_wide = hn::Gt(size_x, size_y);
  // The point of the disc: at the distance r, within an eighth of a turn of an axis.
  const Lanes r = select(is_wide, x, y);
  const Lanes slope = hn::Div(select(is_wide, y, x), r);
  const SinCosLanes angle = sincos_turns(hn::Mul(splat(0.125f), hn::Abs(slope)));
  const Lanes along = hn::Mul(r, angle.cos), across = hn::Mul(r, hn::CopySign(angle.sin, slope));
  const LaneMask is_center = hn::Eq(r, hn::Zero(FloatTag()));
  const Lanes disc_x = hn::IfThenZeroElse(is_center, select(is_wide, along, across));
  const Lanes disc_y = hn::IfThenZeroElse(is_center, select(is_wide, across, along));
  const Lanes distance = hn::Max(size_x, size_y);
  return {disc_x, disc_y, hn::Sqrt(hn::Mul(hn::Sub(splat(1), distance), hn::Add(splat(1), distance)))};
}

/// Uniform in the hemisphere, and in the cone of an angle where `one_minus_z` is scaled to 1 - cos of that.
HWY_ATTR HWY_INLINE Lanes3 direction_around_z(Lanes one_minus_z, Lanes turns) {
  const Lanes r = hn::Sqrt(hn::Mul(one_minus_z, hn::Sub(splat(2), one_minus_z)));
  const SinCosLanes angle = sincos_turns(turns);
  return {hn::Mul(r, angle.cos), hn::Mul(r, angle.sin), hn::Sub(splat(1), one_minus_z)};
}

/// Frame(normal).to_world(local).
HWY_ATTR HWY_INLINE Lanes3 to_world(const Lanes3& normal, const Lanes3& local) {
  const Lanes3& n = normal;
  const Lanes one = splat(1), sign = hn::CopySign(one, n.z);
  const Lanes a = hn::Div(splat(-1), hn::Add(sign, n.z));
  const Lanes b = hn::Mul(hn::Mul(n.x, n.y), a);
  const Lanes3 tangent{hn::Add(one, hn::Mul(hn::Mul(hn::Mul(sign, n.x), n.x), a)), hn::Mul(sign, b),
                       hn::Mul(hn::Neg(sign), n.x)};
  const Lanes3 bitangent{b, hn::Add(sign, hn::Mul(hn::Mul(n.y, n.y), a)), hn::Neg(n.y)};
  return tangent * local.x + bitangent * local.y + n * local.z;
}

}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
