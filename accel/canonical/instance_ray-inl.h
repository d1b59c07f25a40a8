// SPDX-License-Identifier: Apache-2.0
// Private: accel/canonical/instance_ray.h in lanes, compiled once for each instruction set: the same steps
// with the same bits. What is made of a ray stays in registers: written in parts and read as a whole it would
// stall.
#if defined(TWINRAY_ACCEL_INSTANCE_RAY_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TWINRAY_ACCEL_INSTANCE_RAY_INL_H
#undef TWINRAY_ACCEL_INSTANCE_RAY_INL_H
#else
#define TWINRAY_ACCEL_INSTANCE_RAY_INL_H
#endif

#include <cstddef>
#include <cstdint>

#include "accel/canonical/instance_ray.h"
#include "accel/canonical/load_ray-inl.h"

HWY_BEFORE_NAMESPACE();
namespace twinray::HWY_NAMESPACE {

class InstanceRayLoader : RayLoader {
 public:
  /// load_ray_into() of a geometry with instances.
  static HWY_ATTR HWY_INLINE bool load_world(const PlacedInstances& placed, const Ray& given,
                                             CheckedRay& checked) {
    const ScaledRay ray = scaled(given);
    if (!RayLoader::load(ray.ray, checked)) return false;
    finish_scaled(placed, ray.power, checked);
    return true;
  }

  /// enter_instance().
  static HWY_ATTR HWY_INLINE bool enter(const PlacedInstances& placed, std::uint32_t instance,
                                        const CheckedRay& world, float t_max, CheckedRay& own) {
    if (!load_own(placed[instance], world, t_max, own)) return false;
    own.instance = instance;
    return true;
  }

 private:
#if HWY_TARGET <= HWY_AVX2
  using Doubles = hn::FixedTag<double, 4>;
  using FourDoubles = hn::Vec<Doubles>;

  static HWY_ATTR HWY_INLINE bool load_own(const PlacedInstance& instance, const CheckedRay& world,
                                           float t_max, CheckedRay& own) {
    static_assert(offsetof(PlacedInstance, prototype) == offsetof(PlacedInstance, box) + sizeof(Aabb));
    const float* const box = &instance.box.lower.x;  // Three numbers, three more, and the prototype.
    const Four lower = hn::LoadU(Tag(), box), upper = hn::LoadU(Tag(), box + 3);
    const auto is_negative = hn::Ne(four(world.is_negative), hn::Zero(IntTag()));
    const auto is_upper = hn::RebindMask(Tag(), is_negative);
    const Four near_planes = hn::IfThenElse(is_upper, upper, lower);
    const Four far_planes = hn::IfThenElse(is_upper, lower, upper);
    const Four nears = hn::Mul(hn::Sub(near_planes, four(world.near_origin)), four(world.near_inverse));
    const Four fars = hn::Mul(hn::Sub(far_planes, four(world.far_origin)), four(world.far_inverse));
    const float near = hn::GetLane(largest_of_three(nears)), far = hn::GetLane(least_of_three(fars));
    const float own_t_min = near > world.t_min ? near : world.t_min;
    const float own_t_max = far < t_max ? far : t_max;
    if (!(own_t_min <= own_t_max)) return false;
    const Columns columns(instance.to_object);
    const Four origin = hn::DemoteTo(Tag(), hn::Add(columns.times(world.origin), columns.column[3]));
    const Four direction = hn::DemoteTo(Tag(), columns.times(world.direction));
    return RayLoader::load(origin, direction, own_t_min, own_t_max, own);
  }

  /// A matrix by its columns, each in the first three lanes; the last ones are zero.
  struct Columns {
    FourDoubles column[4];

    HWY_ATTR HWY_INLINE explicit Columns(const Transform& transform) {
      const Doubles tag;
      const FourDoubles x = hn::LoadU(tag, transform.m[0]), y = hn::LoadU(tag, transform.m[1]),
                        z = hn::LoadU(tag, transform.m[2]), zero = hn::Zero(tag);
      const FourDoubles even_xy = hn::InterleaveLower(tag, x, y), odd_xy = hn::InterleaveUpper(tag, x, y);
      const FourDoubles even_z = hn::InterleaveLower(tag, z, zero), odd_z = hn::InterleaveUpper(tag, z, zero);
      column[0] = hn::ConcatLowerLower(tag, even_z, even_xy);
      column[1] = hn::ConcatLowerLower(tag, odd_z, odd_xy);
      column[2] = hn::ConcatUpperUpper(tag, even_z, even_xy);
      column[3] = hn::ConcatUpperUpper(tag, odd_z, odd_xy);
    }
    HWY_ATTR HWY_INLINE FourDoubles times(const Vec3& v) const {
      const Doubles tag;
      const FourDoubles x = hn::Mul(column[0], hn::Set(tag, double(v.x)));
      const FourDoubles y = hn::Mul(column[1], hn::Set(tag, double(v.y)));
      return hn::Add(hn::Add(x, y), hn::Mul(column[2], hn::Set(tag, double(v.z))));
    }
  };

  static HWY_ATTR HWY_INLINE Four least_of_three(Four size) {
    return hn::Min(hn::Min(hn::Broadcast<0>(size), hn::Broadcast<1>(size)), hn::Broadcast<2>(size));
  }
  static HWY_ATTR HWY_INLINE Four four(const Float4& lanes) {
    return hn::Load(Tag(), reinterpret_cast<const float*>(&lanes));
  }
  static HWY_ATTR HWY_INLINE hn::Vec<IntTag> four(const Int4& lanes) {
    return hn::Load(IntTag(), reinterpret_cast<const std::int32_t*>(&lanes));
  }
#else
  static HWY_ATTR HWY_INLINE bool load_own(const PlacedInstance& instance, const CheckedRay& world,
                                           float t_max, CheckedRay& own) {
    Ray clipped;
    return clip_to_instance(instance, world, t_max, clipped) && RayLoader::load(clipped, own);
  }
#endif
};

}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
