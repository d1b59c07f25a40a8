// SPDX-License-Identifier: Apache-2.0
// Private: where paths go on, in lanes, compiled once for each instruction set.
#if defined(TWINRAY_WAVE_SCATTER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TWINRAY_WAVE_SCATTER_INL_H
#undef TWINRAY_WAVE_SCATTER_INL_H
#else
#define TWINRAY_WAVE_SCATTER_INL_H
#endif

#include "integrators/wave/light-inl.h"

HWY_BEFORE_NAMESPACE();
namespace twinray::HWY_NAMESPACE {

HWY_ATTR void scatter_paths(const Surfaces& surfaces, Wave& wave) {
  Paths& paths = wave.paths;
  const Lanes zero = hn::Zero(FloatTag());
  for (std::size_t i = 0; i < paths.size; i += lane_count) {
    const Lanes3 local = square_to_cosine_hemisphere(load(wave.ux, i), load(wave.uy, i));
    const Lanes pdf = hn::Div(hn::Max(zero, local.z), splat(pi));
    const Lanes3 wi = to_world(load(surfaces.shading, i), local);
    const Lanes3 throughput = load(paths.throughput, i) * bsdf(surfaces, i) * hn::Div(hn::Abs(local.z), pdf);
    const LaneMask is_scattered =
        hn::And(hn::And(is_not_black(load(surfaces.reflectance, i)), is_positive(local.z)),
                hn::And(hn::Ne(load(surfaces.wo_z, i), zero), hn::Ne(pdf, zero)));
    store(zero_unless(hn::And(is_scattered, is_consistent(surfaces, i, wi)), throughput), paths.throughput,
          i);
    store(wi, paths.direction, i);
    store(pdf, wave.pdf, i);
    store(leave_surface(surfaces.point, i, wi), wave.origin, i);
  }
}

HWY_ATTR std::size_t keep_paths(Wave& wave) {
  const Paths& paths = wave.paths;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < paths.size; i += lane_count)
    kept =
        append(hn::And(is_not_black(load(paths.throughput, i)), within(i, paths.size)), i, wave.kept, kept);
  return kept;
}

/// Numbers are read before any is written behind them, since `kept` grows.
template <class Tag, class T>
HWY_ATTR HWY_INLINE void move_up(Tag tag, const Words& kept, std::size_t size, Column<T>& column) {
  const hn::RebindToSigned<WordTag> integers;
  for (std::size_t k = 0; k < size; k += lane_count) {
    const auto from =
        hn::BitCast(integers, hn::IfThenElseZero(hn::FirstN(WordTag(), size - k), load(kept, k)));
    hn::Store(hn::GatherIndex(tag, column.values, from), tag, column.values + k);
  }
}
HWY_ATTR void move_up_words(const Words& kept, std::size_t size, Words& column) {
  move_up(WordTag(), kept, size, column);
}
HWY_ATTR void move_up_floats(const Words& kept, std::size_t size, Floats& column) {
  move_up(FloatTag(), kept, size, column);
}

}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
