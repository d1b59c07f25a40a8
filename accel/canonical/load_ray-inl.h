// SPDX-License-Identifier: Apache-2.0
// Private: load_ray_scalar of accel/canonical/checked_ray.h, compiled once for each instruction set: the same
// steps with the same bits. Inside of a query it takes half of the instructions, and what it makes stays in
// registers.
#if defined(TWINRAY_ACCEL_LOAD_RAY_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TWINRAY_ACCEL_LOAD_RAY_INL_H
#undef TWINRAY_ACCEL_LOAD_RAY_INL_H
#else
#define TWINRAY_ACCEL_LOAD_RAY_INL_H
#endif

#include <cstddef>
#include <cstdint>

#include "accel/canonical/checked_ray.h"
#include "accel/canonical/lane_bits-inl.h"

HWY_BEFORE_NAMESPACE();
namespace twinray::HWY_NAMESPACE {

/// Loads rays into vectors of four, whose last lane has no meaning.
class RayLoader {
 public:
  /// Fills `checked`; false for an invalid ray, which is a miss.
  static HWY_ATTR HWY_INLINE bool load(const Ray& ray, CheckedRay& checked) {
    // Four numbers from each place are three of the vector, and what follows in both structs. They are read
    // and written as bytes of the whole struct, for no member has four.
    static_assert(offsetof(Ray, direction) == 12 && offsetof(Ray, t_min) == 24 && sizeof(Ray) >= 28);
    static_assert(offsetof(CheckedRay, direction) == 12 && offsetof(CheckedRay, t_min) == 24);
    const Four origin = load_four(&ray, offsetof(Ray, origin));
    const Four direction = load_four(&ray, offsetof(Ray, direction));
    return load(origin, direction, ray.t_min, ray.t_max, checked);
  }

 protected:
  using Tag = hn::FixedTag<float, 4>;
  using IntTag = hn::RebindToSigned<Tag>;
  using Four = hn::Vec<Tag>;

  /// The same of a ray in lanes, the last of which are finite.
  static HWY_ATTR HWY_INLINE bool load(Four origin, Four direction, float t_min, float t_max,
                                       CheckedRay& checked) {
    if (!is_valid(origin, direction, t_min, t_max)) return false;
    store_four(origin, &checked, offsetof(CheckedRay, origin));
    store_four(direction, &checked, offsetof(CheckedRay, direction));
    checked.t_min = t_min;
    checked.t_max = t_max < max_t ? t_max : max_t;
    checked.t_scale = 1;
    checked.instance = no_instance;
    Four largest = largest_of_three(hn::Abs(direction));
    const float length = hn::GetLane(largest);
    if (!(length >= min_direction) || !(length <= max_direction)) {
      if (!scale_direction(checked)) return false;
      direction = load_four(&checked, offsetof(CheckedRay, direction));
      largest = largest_of_three(hn::Abs(direction));
    }
    load_slab(checked, origin, direction, largest);
    load_shear(checked, origin, direction);
    return true;
  }

  static HWY_ATTR HWY_INLINE Four largest_of_three(Four size) {
    return hn::Max(hn::Max(hn::Broadcast<0>(size), hn::Broadcast<1>(size)), hn::Broadcast<2>(size));
  }

 private:
  using Bytes = hn::FixedTag<std::uint8_t, 16>;

  static HWY_ATTR HWY_INLINE Four load_four(const void* from, std::size_t place) {
    return hn::BitCast(Tag(), hn::LoadU(Bytes(), static_cast<const std::uint8_t*>(from) + place));
  }
  static HWY_ATTR HWY_INLINE void store_four(Four lanes, void* to, std::size_t place) {
    hn::StoreU(hn::BitCast(Bytes(), lanes), Bytes(), static_cast<std::uint8_t*>(to) + place);
  }

  /// Whatever a ray has in its last lanes must be finite: of the origin the direction's x, of that t_min.
  static HWY_ATTR HWY_INLINE bool is_valid(Four origin, Four direction, float t_min, float t_max) {
    alignas(16) static constexpr float most[4] = {max_origin, max_origin, max_origin, max_t};
    const auto in_range = hn::And(hn::Le(hn::Abs(origin), hn::Load(Tag(), most)),
                                  hn::Le(hn::Abs(direction), hn::Set(Tag(), max_t)));
    return hn::AllTrue(Tag(), in_range) && t_min >= 0 && t_min <= t_max;
  }

  static HWY_ATTR HWY_INLINE void load_slab(CheckedRay& checked, Four origin, Four direction, Four largest) {
    const Four reach = hn::Mul(largest_of_three(hn::Abs(origin)), hn::Set(Tag(), slab_margin));
    const Four forward = hn::CopySignToAbs(reach, direction);
    const Four least = hn::Mul(largest, hn::Set(Tag(), least_component));
    const Four size = hn::Max(hn::Abs(direction), least);
    const Four inverse = hn::Div(hn::Set(Tag(), 1.0f), hn::CopySignToAbs(size, direction));
    const hn::RebindToUnsigned<Tag> bits;
    store(hn::BitCast(IntTag(), hn::ShiftRight<31>(hn::BitCast(bits, direction))), checked.is_negative);
    store(hn::Add(origin, forward), checked.near_origin);
    store(hn::Sub(origin, forward), checked.far_origin);
    store(hn::Mul(inverse, hn::Set(Tag(), 1.0f - slab_margin)), checked.near_inverse);
    store(hn::Mul(inverse, hn::Set(Tag(), 1.0f + slab_margin)), checked.far_inverse);
  }

  static HWY_ATTR HWY_INLINE void load_shear(CheckedRay& checked, Four origin, Four direction) {
    // By which of x > y, y > z and x > z are true: bits 0 to 2. Of equal ones the later axis is dominant.
    alignas(16) static constexpr std::int32_t axes_of[8][4] = {
        {0, 1, 2, 2}, {0, 1, 2, 2}, {2, 0, 1, 1}, {}, {}, {1, 2, 0, 0}, {2, 0, 1, 1}, {1, 2, 0, 0}};
    alignas(16) static constexpr std::int32_t one[4] = {0, 1, 0, 3}, other[4] = {1, 2, 2, 3};
    const Four size = hn::Abs(direction);
    const auto is_larger = hn::Gt(permuted(size, one), permuted(size, other));
    const auto axes = hn::Load(IntTag(), axes_of[bits_of(Tag(), is_larger) & 7]);
    const auto order = hn::IndicesFromVec(Tag(), axes);
    const Four turned = hn::TableLookupLanes(direction, order);
    const Four numerator = hn::IfThenElse(hn::FirstN(Tag(), 2), turned, hn::Set(Tag(), 1.0f));
    store(axes, checked.axes);
    store(hn::Div(numerator, hn::Broadcast<2>(turned)), checked.shear);
    store(hn::TableLookupLanes(origin, order), checked.turned_origin);
  }

  static HWY_ATTR HWY_INLINE Four permuted(Four lanes, const std::int32_t order[4]) {
    return hn::TableLookupLanes(lanes, hn::IndicesFromVec(Tag(), hn::Load(IntTag(), order)));
  }
  static HWY_ATTR HWY_INLINE void store(Four lanes, Float4& to) {
    hn::Store(lanes, Tag(), reinterpret_cast<float*>(&to));
  }
  static HWY_ATTR HWY_INLINE void store(hn::Vec<IntTag> lanes, Int4& to) {
    hn::Store(lanes, IntTag(), reinterpret_cast<std::int32_t*>(&to));
  }
};

}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
