// SPDX-License-Identifier: Apache-2.0
// Private: accel/canonical/instance_ray.h for sixteen rays that run close together, compiled once for each
// instruction set: how they come into a scene with instances, and from there into one of them. Each ray gets
// the bits that it gets alone.
#if defined(TWINRAY_ACCEL_INSTANCE_PACKET_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TWINRAY_ACCEL_INSTANCE_PACKET_INL_H
#undef TWINRAY_ACCEL_INSTANCE_PACKET_INL_H
#else
#define TWINRAY_ACCEL_INSTANCE_PACKET_INL_H
#endif

#include <bit>
#include <cstddef>
#include <cstdint>

#include "accel/canonical/instance_ray.h"
#include "accel/canonical/ray_packet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace twinray::HWY_NAMESPACE {

/// A packet in the space of a scene with instances.
class WorldPacket : PacketLanes {
 public:
  /// What becomes of the rays at an instance.
  enum class Entry {
    missed,   ///< None comes to its box.
    entered,  ///< Those that do are a packet there.
    parted,   ///< They are none.
  };

  /// load_ray_into(); false where they are no packet, or one comes from beyond the scene's reach.
  HWY_ATTR HWY_INLINE bool load(const PlacedInstances& placed, const Ray* given) {
    const FloatLanes reach = hn::Set(Floats(), placed.reach());
    for (std::size_t i = 0; i < packet_size; i += lane_count) {
      rays_.gather(given, i);
      const bool is_near = lanes_of(hn::Le(largest_origin(i), reach)) == all_lanes;
      if (!is_near || !scale(i) || !rays_.are_valid(i)) return false;
      // What the caller takes for t is finite.
      const FloatLanes share = hn::Min(power_.at(i), hn::Set(Floats(), 1.0f));
      const FloatLanes most = hn::Mul(hn::Set(Floats(), max_t), share);
      rays_.t_max.set(i, hn::Min(rays_.t_max.at(i), most));
    }
    return packet_.load(rays_);
  }
  const RayPacket& packet() const { return packet_; }

  /// enter_instance(), each ray up to its own t_max; `packet` is one of the rays `own`.
  HWY_ATTR HWY_INLINE Entry enter(const PlacedInstances& placed, std::uint32_t number, const Numbers& t_max,
                                  RayLanes& own, RayPacket& packet) const {
    const PlacedInstance& instance = placed[number];
    std::uint32_t met = 0;
    for (std::size_t i = 0; i < packet_size; i += lane_count) met |= clip(instance.box, t_max, i, own) << i;
    if (met == 0) return Entry::missed;
    move_into(instance.to_object, own);
    replace_others(met, own);
    for (std::size_t i = 0; i < packet_size; i += lane_count)
      if (lanes_of(own.are_in_range(i)) != all_lanes) return Entry::parted;
    packet.instance = number;
    return packet.load(own) ? Entry::entered : Entry::parted;
  }

  /// A hit in the caller's units.
  Hit scaled_back(Hit hit, std::size_t ray) const {
    if (const float power = power_.values[ray]; power != 1) hit.t = float(hit.t * double(1 / power));
    return hit;
  }

 private:
  HWY_ATTR HWY_INLINE FloatLanes largest_origin(std::size_t first) const {
    return RayLanes::largest_of_three(rays_.origin, first);
  }

  /// The canonical scaled(); false for a direction that it leaves as it is.
  HWY_ATTR HWY_INLINE bool scale(std::size_t first) {
    const Ints tag;
    const auto bits = hn::BitCast(tag, RayLanes::largest_of_three(rays_.direction, first));
    const auto exponent = hn::And(bits, hn::Set(tag, 0x7f800000));
    const FloatLanes power = hn::BitCast(Floats(), exponent);
    const auto is_near_one = hn::And(hn::Ge(power, hn::Set(Floats(), 0x1p-60f)),  //
                                     hn::Le(power, hn::Set(Floats(), 0x1p60f)));
    if (lanes_of(is_near_one) != all_lanes) return false;
    const FloatLanes inverse = hn::BitCast(Floats(), hn::Sub(hn::Set(tag, 254 << 23), exponent));
    for (Numbers& component : rays_.direction) component.set(first, hn::Mul(component.at(first), inverse));
    rays_.t_min.set(first, hn::Mul(rays_.t_min.at(first), power));
    const FloatLanes end = rays_.t_max.at(first);
    const auto is_finite = hn::Lt(end, hn::Set(Floats(), max_t));
    rays_.t_max.set(first, hn::IfThenElse(is_finite, hn::Mul(end, power), end));
    power_.set(first, power);
    return true;
  }

  /// Clips the intervals of a vector's rays to a box; returns for which something is left.
  HWY_ATTR HWY_INLINE std::uint32_t clip(const Aabb& box, const Numbers& t_max, std::size_t first,
                                         RayLanes& own) const {
    const FloatLanes reach = hn::Mul(largest_origin(first), hn::Set(Floats(), slab_margin));
    FloatLanes near = hn::Set(Floats(), -Aabb::infinity), far = hn::Set(Floats(), Aabb::infinity);
    for (int axis = 0; axis < 3; ++axis) {
      const bool is_negative = packet_.slab[axis].is_negative;
      const FloatLanes lower = hn::Set(Floats(), box.lower[axis]), upper = hn::Set(Floats(), box.upper[axis]);
      const FloatLanes origin = rays_.origin[axis].at(first), inverse = packet_.inverse(rays_, axis, first);
      const FloatLanes ahead = is_negative ? hn::Sub(origin, reach) : hn::Add(origin, reach);
      const FloatLanes behind = is_negative ? hn::Add(origin, reach) : hn::Sub(origin, reach);
      const FloatLanes near_inverse = hn::Mul(inverse, hn::Set(Floats(), 1 - slab_margin));
      const FloatLanes far_inverse = hn::Mul(inverse, hn::Set(Floats(), 1 + slab_margin));
      near = hn::Max(near, hn::Mul(hn::Sub(is_negative ? upper : lower, ahead), near_inverse));
      far = hn::Min(far, hn::Mul(hn::Sub(is_negative ? lower : upper, behind), far_inverse));
    }
    const FloatLanes least = rays_.t_min.at(first), most = t_max.at(first);
    const FloatLanes begin = hn::IfThenElse(hn::Gt(near, least), near, least);
    const FloatLanes end = hn::IfThenElse(hn::Lt(far, most), far, most);
    const auto is_left = hn::Le(begin, end);
    own.t_min.set(first, hn::IfThenElse(is_left, begin, hn::Set(Floats(), Aabb::infinity)));
    own.t_max.set(first, hn::IfThenElse(is_left, end, hn::Set(Floats(), -1.0f)));
    return lanes_of(is_left);
  }

  /// The canonical move_into() of all rays.
  HWY_ATTR HWY_INLINE void move_into(const Transform& to_object, RayLanes& own) const {
    using Doubles = hn::CappedTag<double, packet_size>;
    using Part = hn::Rebind<float, Doubles>;
    const Doubles tag;
    for (std::size_t i = 0; i < packet_size; i += hn::MaxLanes(tag)) {
      const auto wide = [&](const Numbers& from)
                            HWY_ATTR { return hn::PromoteTo(tag, hn::Load(Part(), from.values + i)); };
      const auto ox = wide(rays_.origin[0]), oy = wide(rays_.origin[1]), oz = wide(rays_.origin[2]);
      const auto dx = wide(rays_.direction[0]), dy = wide(rays_.direction[1]), dz = wide(rays_.direction[2]);
      for (int row = 0; row < 3; ++row) {
        const double* const m = to_object.m[row];
        const auto x = hn::Set(tag, m[0]), y = hn::Set(tag, m[1]), z = hn::Set(tag, m[2]);
        const auto turned = hn::Add(hn::Add(hn::Mul(x, ox), hn::Mul(y, oy)), hn::Mul(z, oz));
        const auto direction = hn::Add(hn::Add(hn::Mul(x, dx), hn::Mul(y, dy)), hn::Mul(z, dz));
        hn::Store(hn::DemoteTo(Part(), hn::Add(turned, hn::Set(tag, m[3]))), Part(),
                  own.origin[row].values + i);
        hn::Store(hn::DemoteTo(Part(), direction), Part(), own.direction[row].values + i);
      }
    }
  }

  /// Puts one of the rays that are `met` in the place of each that is not: it changes no bounds, and its
  /// interval is empty.
  static HWY_ATTR HWY_INLINE void replace_others(std::uint32_t met, RayLanes& own) {
    constexpr std::uint32_t all = (1u << packet_size) - 1;
    if (met == all) return;
    const int one = std::countr_zero(met);
    for (std::uint32_t left = all & ~met; left != 0; left &= left - 1) {
      const int other = std::countr_zero(left);
      for (int axis = 0; axis < 3; ++axis) {
        own.origin[axis].values[other] = own.origin[axis].values[one];
        own.direction[axis].values[other] = own.direction[axis].values[one];
      }
    }
  }

  RayLanes rays_;
  RayPacket packet_;
  Numbers power_;  ///< By which directions were divided.
};

}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
