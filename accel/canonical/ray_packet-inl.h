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

/// Sixteen rays.
struct RayLanes : PacketLanes {
  Numbers origin[3], direction[3];
  Numbers t_min, t_max;
  const Ray* given = nullptr;  ///< The same rays one by one, where there are such.

  /// False where one is invalid, or has a direction that must be scaled.
  HWY_ATTR HWY_INLINE bool load(const Ray* rays) {
    for (std::size_t i = 0; i < packet_size; i += lane_count) {
      gather(rays, i);
      if (!are_valid(i)) return false;
    }
    given = rays;
    return true;
  }
  /// Takes a vector's rays as they are given.
  HWY_ATTR HWY_INLINE void gather(const Ray* rays, std::size_t first) {
    static_assert(sizeof(Ray) == 32 && offsetof(Ray, origin) == 0 && offsetof(Ray, direction) == 12 &&
                  offsetof(Ray, t_min) == 24 && offsetof(Ray, t_max) == 28);
    const auto place = hn::ShiftLeft<3>(hn::Iota(Ints(), 0));
    const auto number = [&](int which) HWY_ATTR {
      return hn::GatherIndex(Floats(), &rays[first].origin.x + which, place);
    };
    for (int axis = 0; axis < 3; ++axis) {
      origin[axis].set(first, number(axis));
      direction[axis].set(first, number(3 + axis));
    }
    t_min.set(first, number(6));
    t_max.set(first, number(7));
  }
  /// Whether a vector's rays are valid, and need not be scaled; brings t_max down to what is finite.
  HWY_ATTR HWY_INLINE bool are_valid(std::size_t first) {
    const FloatLanes most = hn::Set(Floats(), max_t), begin = t_min.at(first), end = t_max.at(first);
    const auto is_interval =
        hn::And(hn::Ge(begin, hn::Zero(Floats())), hn::And(hn::Le(begin, end), hn::Le(begin, most)));
    t_max.set(first, hn::Min(end, most));
    return lanes_of(hn::And(is_interval, are_in_range(first))) == all_lanes;
  }
  /// Whether the origins and directions of a vector need not be scaled.
  HWY_ATTR HWY_INLINE hn::Mask<Floats> are_in_range(std::size_t first) const {
    FloatLanes size = hn::Zero(Floats());
    auto are_in = hn::Eq(size, size);
    for (int axis = 0; axis < 3; ++axis) {
      const FloatLanes o = hn::Abs(origin[axis].at(first)), d = hn::Abs(direction[axis].at(first));
      are_in = hn::And(are_in, hn::And(hn::Le(o, hn::Set(Floats(), max_origin)),
                                       hn::Le(d, hn::Set(Floats(), max_direction))));
      size = hn::Max(size, d);
    }
    return hn::And(are_in, hn::Ge(size, hn::Set(Floats(), min_direction)));
  }
  static HWY_ATTR HWY_INLINE FloatLanes largest_of_three(const Numbers (&of)[3], std::size_t first) {
    return hn::Max(hn::Max(hn::Abs(of[0].at(first)), hn::Abs(of[1].at(first))), hn::Abs(of[2].at(first)));
  }
  /// One of them: as it was given, for a copy would be read before it is written, or else put into `room`.
  const Ray& ray(std::size_t i, Ray& room) const {
    if (given) return given[i];
    room = {.origin = {origin[0].values[i], origin[1].values[i], origin[2].values[i]},
            .direction = {direction[0].values[i], direction[1].values[i], direction[2].values[i]},
            .t_min = t_min.values[i],
            .t_max = t_max.values[i]};
    return room;
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
  const RayLanes* given;
  std::uint32_t instance = no_instance;  ///< In whose space they are given.
  Numbers t_min, t_max;                  ///< Where t_min is larger, a ray hits nothing.
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

  /// Of rays that outlive this: valid ones, or such that hit nothing. False where they are no packet.
  HWY_ATTR HWY_INLINE bool load(const RayLanes& lanes) {
    given = &lanes;
    if (!load_axes(lanes.direction)) return false;
    t_min = lanes.t_min;
    t_max = lanes.t_max;
    Range starts;
    starts.add(t_min);
    least_t_min = starts.least();
    load_slab(lanes);
    load_shear(lanes.origin, lanes.direction);
    return true;
  }

  /// The reciprocals of a vector's components along an axis, as load_ray() works them out.
  HWY_ATTR HWY_INLINE FloatLanes inverse(const RayLanes& rays, int axis, std::size_t first) const {
    const FloatLanes d = rays.direction[axis].at(first);
    const FloatLanes least =
        hn::Mul(hn::Abs(rays.direction[axes[2]].at(first)), hn::Set(Floats(), least_component));
    const FloatLanes size = hn::Max(hn::Abs(d), least);
    return hn::Div(hn::Set(Floats(), 1.0f), hn::CopySignToAbs(size, d));
  }

 private:
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
  HWY_ATTR HWY_INLINE void load_slab(const RayLanes& rays) {
    Range sizes;
    for (std::size_t i = 0; i < packet_size; i += lane_count)
      sizes.add(i, RayLanes::largest_of_three(rays.origin, i));
    const float reach = sizes.largest() * slab_margin;
    for (int axis = 0; axis < 3; ++axis) {
      Range origins, inverses;
      for (std::size_t i = 0; i < packet_size; i += lane_count) inverses.add(i, inverse(rays, axis, i));
      origins.add(rays.origin[axis]);
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
