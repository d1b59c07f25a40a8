// SPDX-License-Identifier: Apache-2.0
// Private: sixteen rays that run close together, as structures of arrays, compiled once for each instruction
// set.
//
// Each ray has the bits that load_ray() gives it. What all have in common is worked out once: the signs of
// their directions, their dominant axis, and between which numbers lie what the box test needs of them.
#if defined(TWINRAY_ACCEL_RAY_PACKET_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TWINRAY_ACCEL_RAY_PACKET_INL_H
#undef TWINRAY_ACCEL_RAY_PACKET_INL_H
#else
#define TWINRAY_ACCEL_RAY_PACKET_INL_H
#endif

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "accel/canonical/checked_ray.h"
#include "accel/canonical/lane_bits-inl.h"

HWY_BEFORE_NAMESPACE();
namespace twinray::HWY_NAMESPACE {

/// Numbers of a packet's rays, in vectors.
struct PacketLanes {
  static constexpr std::size_t packet_size = 16;
  using Floats = hn::CappedTag<float, packet_size>;
  using Ints = hn::RebindToSigned<Floats>;
  using FloatLanes = hn::Vec<Floats>;
  static constexpr std::size_t lane_count = hn::MaxLanes(Floats());
  static constexpr std::uint32_t all_lanes = (1u << lane_count) - 1;

  /// One of each ray.
  struct alignas(64) Numbers {
    float values[packet_size];

    /// Those of the vector that begins with ray `first`.
    HWY_ATTR HWY_INLINE FloatLanes at(std::size_t first) const { return hn::Load(Floats(), values + first); }
    HWY_ATTR HWY_INLINE void set(std::size_t first, FloatLanes lanes) {
      hn::Store(lanes, Floats(), values + first);
    }
  };
  /// Between which numbers some lie.
  class Range {
   public:
    HWY_ATTR HWY_INLINE void add(std::size_t first, FloatLanes lanes) {
      least_ = first == 0 ? lanes : hn::Min(least_, lanes);
      largest_ = first == 0 ? lanes : hn::Max(largest_, lanes);
    }
    HWY_ATTR HWY_INLINE void add(const Numbers& numbers) {
      for (std::size_t i = 0; i < packet_size; i += lane_count) add(i, numbers.at(i));
    }
    HWY_ATTR HWY_INLINE float least() const { return hn::GetLane(hn::MinOfLanes(Floats(), least_)); }
    HWY_ATTR HWY_INLINE float largest() const { return hn::GetLane(hn::MaxOfLanes(Floats(), largest_)); }

   private:
    FloatLanes least_, largest_;
  };
  /// Bit i: the mask is true in lane i.
  static HWY_ATTR HWY_INLINE std::uint32_t lanes_of(hn::Mask<Floats> mask) {
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(Floats(), mask, bits);
    return bits[0] | std::uint32_t(bits[1]) << 8;
  }
};

/// What the box test needs of all rays, along one axis: of their origins those that give the earliest entry
/// and the latest exit, and between which numbers their reciprocals lie.
struct PacketAxis {
  bool is_negative;
  float near_origin, far_origin;
  float near_inverse[2], far_inverse[2];
};

/// Sixteen rays whose directions have the same signs and the same dominant axis.
struct RayPacket : PacketLanes {
  const Ray* given;
  Numbers t_min, t_max;
  float least_t_min;
  int axes[3];  ///< This and the next two as in a CheckedRay.
  Numbers shear[3], turned_origin[3];
  PacketAxis slab[3];

  /// Whether the first ray and the last one run so close together that it is worth trying to load them: their
  /// origins by `close`. It is quick, for most rays do not.
  static bool may_be(const Ray* rays, float close) {
    constexpr float angle = 1.0f / 16;
    const Ray &first = rays[0], &last = rays[packet_size - 1];
    return max_abs(last.direction - first.direction) <= angle * max_abs(first.direction) &&
           max_abs(last.origin - first.origin) <= close;
  }

  /// False where they are no such rays, or one is invalid or has a direction that must be scaled.
  HWY_ATTR HWY_INLINE bool load(const Ray* rays) {
    given = rays;
    Numbers origin[3], direction[3];
    for (std::size_t i = 0; i < packet_size; i += lane_count)
      if (!load(rays + i, i, origin, direction)) return false;
    if (!load_axes(direction)) return false;
    Range starts;
    starts.add(t_min);
    least_t_min = starts.least();
    load_slab(origin, direction);
    load_shear(origin, direction);
    return true;
  }

 private:
  /// The rays of a vector; false where one is none for a packet.
  HWY_ATTR HWY_INLINE bool load(const Ray* rays, std::size_t first, Numbers (&origin)[3],
                                Numbers (&direction)[3]) {
    static_assert(sizeof(Ray) == 32 && offsetof(Ray, origin) == 0 && offsetof(Ray, direction) == 12 &&
                  offsetof(Ray, t_min) == 24 && offsetof(Ray, t_max) == 28);
    const auto place = hn::ShiftLeft<3>(hn::Iota(Ints(), 0));
    const FloatLanes most = hn::Set(Floats(), max_t), begin = gather(rays, 6, place);
    const FloatLanes end = gather(rays, 7, place);
    auto is_good =
        hn::And(hn::Ge(begin, hn::Zero(Floats())), hn::And(hn::Le(begin, end), hn::Le(begin, most)));
    FloatLanes size = hn::Zero(Floats());
    for (int axis = 0; axis < 3; ++axis) {
      const FloatLanes o = gather(rays, axis, place), d = gather(rays, 3 + axis, place);
      is_good = hn::And(is_good, hn::And(hn::Le(hn::Abs(o), hn::Set(Floats(), max_origin)),
                                         hn::Le(hn::Abs(d), hn::Set(Floats(), max_direction))));
      size = hn::Max(size, hn::Abs(d));
      origin[axis].set(first, o);
      direction[axis].set(first, d);
    }
    t_min.set(first, begin);
    t_max.set(first, hn::Min(end, most));
    is_good = hn::And(is_good, hn::Ge(size, hn::Set(Floats(), min_direction)));
    return lanes_of(is_good) == all_lanes;
  }
  static HWY_ATTR HWY_INLINE FloatLanes gather(const Ray* rays, int number, hn::Vec<Ints> place) {
    return hn::GatherIndex(Floats(), &rays->origin.x + number, place);
  }

  /// The signs and the dominant axis of the first direction; false where others have none of them.
  HWY_ATTR HWY_INLINE bool load_axes(const Numbers (&direction)[3]) {
    const float x = std::fabs(direction[0].values[0]), y = std::fabs(direction[1].values[0]),
                z = std::fabs(direction[2].values[0]);
    const int dominant = x > y && x > z ? 0 : y > z ? 1 : 2;
    for (int i = 0; i < 3; ++i) axes[i] = (dominant + 1 + i) % 3;
    for (int axis = 0; axis < 3; ++axis) {
      slab[axis].is_negative = std::signbit(direction[axis].values[0]);
      const std::uint32_t signs = slab[axis].is_negative ? all_lanes : 0;
      for (std::size_t i = 0; i < packet_size; i += lane_count) {
        const FloatLanes component = direction[axis].at(i), size = hn::Abs(component);
        const FloatLanes largest = hn::Abs(direction[dominant].at(i));
        // Of equal ones the later axis is dominant.
        const auto is_less = axis <= dominant ? hn::Le(size, largest) : hn::Lt(size, largest);
        const auto sign = hn::BroadcastSignBit(hn::BitCast(Ints(), component));
        if (lanes_of(is_less) != all_lanes || lanes_of(hn::MaskFromVec(hn::BitCast(Floats(), sign))) != signs)
          return false;
      }
    }
    return true;
  }

  /// All steps of load_ray() are monotone, so the bounds of what goes in give those of what comes out.
  HWY_ATTR HWY_INLINE void load_slab(const Numbers (&origin)[3], const Numbers (&direction)[3]) {
    Range sizes;
    for (std::size_t i = 0; i < packet_size; i += lane_count)
      sizes.add(
          i, hn::Max(hn::Max(hn::Abs(origin[0].at(i)), hn::Abs(origin[1].at(i))), hn::Abs(origin[2].at(i))));
    const float reach = sizes.largest() * slab_margin;
    for (int axis = 0; axis < 3; ++axis) {
      Range origins, inverses;
      for (std::size_t i = 0; i < packet_size; i += lane_count) {
        const FloatLanes d = direction[axis].at(i);
        const FloatLanes least =
            hn::Mul(hn::Abs(direction[axes[2]].at(i)), hn::Set(Floats(), least_component));
        const FloatLanes size = hn::Max(hn::Abs(d), least);
        inverses.add(i, hn::Div(hn::Set(Floats(), 1.0f), hn::CopySignToAbs(size, d)));
      }
      origins.add(origin[axis]);
      PacketAxis& of = slab[axis];
      const float backward = origins.least() - reach, forward = origins.largest() + reach;
      of.near_origin = of.is_negative ? backward : forward;
      of.far_origin = of.is_negative ? forward : backward;
      const float inverse[2] = {inverses.least(), inverses.largest()};
      for (int end = 0; end < 2; ++end) {
        of.near_inverse[end] = inverse[end] * (1 - slab_margin);
        of.far_inverse[end] = inverse[end] * (1 + slab_margin);
      }
    }
  }

  HWY_ATTR HWY_INLINE void load_shear(const Numbers (&origin)[3], const Numbers (&direction)[3]) {
    for (std::size_t i = 0; i < packet_size; i += lane_count) {
      const FloatLanes along = direction[axes[2]].at(i);
      for (int k = 0; k < 3; ++k) {
        const FloatLanes across = k < 2 ? direction[axes[k]].at(i) : hn::Set(Floats(), 1.0f);
        shear[k].set(i, hn::Div(across, along));
        turned_origin[k].set(i, origin[axes[k]].at(i));
      }
    }
  }
};

}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
