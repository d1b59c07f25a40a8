// SPDX-License-Identifier: Apache-2.0
// Private: the test of a block's primitives against the rays of a packet, compiled once for each instruction
// set.
//
// One triangle at a time, in lanes of rays, by the two steps of accel/canonical/triangle.h: what float leaves
// no doubt of is rejected, the rest is decided in double. Here that pays: of rays that run close together
// mostly all are beside a triangle.
#if defined(TWINRAY_ACCEL_PACKET_TEST_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TWINRAY_ACCEL_PACKET_TEST_INL_H
#undef TWINRAY_ACCEL_PACKET_TEST_INL_H
#else
#define TWINRAY_ACCEL_PACKET_TEST_INL_H
#endif

#include <bit>
#include <cstddef>
#include <cstdint>

#include "accel/canonical/block_test-inl.h"
#include "accel/canonical/edge_lanes-inl.h"
#include "accel/canonical/load_ray-inl.h"
#include "accel/canonical/ray_packet-inl.h"
#include "accel/canonical/triangle.h"

HWY_BEFORE_NAMESPACE();
namespace twinray::HWY_NAMESPACE {

/// The nearest hits so far of a packet's rays.
class PacketHits : PacketLanes {
 public:
  HWY_ATTR HWY_INLINE explicit PacketHits(const RayPacket& rays) : t_(rays.t_max), instance_(rays.instance) {
    find_latest();
  }

  /// Up to which t each ray may still hit something.
  const Numbers& t_max() const { return t_; }
  /// The largest of them.
  float latest() const { return latest_; }
  /// Bit i: ray i has one.
  std::uint32_t found() const { return found_; }

  HWY_ATTR HWY_INLINE void test(const Geometry& geometry, const RayPacket& rays,
                                const PrimitiveBlock& block) {
    if (block.spheres | block.others) {
      test_one_by_one(geometry, rays, block);
    } else {
      for (std::uint32_t left = block.triangles; left != 0; left &= left - 1)
        test_triangle(rays, block, std::countr_zero(left));
    }
    find_latest();
  }

  Hit hit(std::size_t ray) const {
    if ((found_ >> ray & 1) == 0) return {};
    const float u = float(terms_[0][ray] / terms_[2][ray]), v = float(terms_[1][ray] / terms_[2][ray]);
    return {t_.values[ray], u, v, ids_[ray].primitive, ids_[ray].mesh, instance_};
  }

 private:
  // A half of the rays of a vector.
  using Halves = hn::Half<Floats>;
  using Doubles = hn::Rebind<double, Halves>;
  using HalfLanes = hn::Vec<Halves>;
  using DoubleLanes = hn::Vec<Doubles>;
  static constexpr std::size_t half_count = lane_count / 2;

  /// The sheared corners of a triangle for a vector's rays, before z is scaled.
  struct Corners {
    FloatLanes x[3], y[3], z[3];

    HWY_ATTR HWY_INLINE Corners(const RayPacket& rays, const PrimitiveBlock& block, int lane,
                                std::size_t first) {
      for (int corner = 0; corner < 3; ++corner) {
        FloatLanes from_ray[3];
        for (int k = 0; k < 3; ++k)
          from_ray[k] = hn::Sub(hn::Set(Floats(), block.corners[corner][rays.axes[k]][lane]),
                                rays.turned_origin[k].at(first));
        z[corner] = from_ray[2];
        x[corner] = hn::Sub(from_ray[0], hn::Mul(rays.shear[0].at(first), z[corner]));
        y[corner] = hn::Sub(from_ray[1], hn::Mul(rays.shear[1].at(first), z[corner]));
      }
    }
    /// The canonical edge_error().
    HWY_ATTR HWY_INLINE FloatLanes edge_error() const {
      return hn::MulAdd(hn::Set(Floats(), edge_margin), hn::Mul(largest(x), largest(y)),
                        hn::Set(Floats(), edge_underflow));
    }

   private:
    static HWY_ATTR HWY_INLINE FloatLanes largest(const FloatLanes (&of)[3]) {
      return hn::Max(hn::Abs(of[0]), hn::Max(hn::Abs(of[1]), hn::Abs(of[2])));
    }
  };

  HWY_ATTR HWY_INLINE void find_latest() {
    Range range;
    range.add(t_);
    latest_ = range.largest();
  }

  HWY_ATTR HWY_INLINE void test_triangle(const RayPacket& rays, const PrimitiveBlock& block, int lane) {
    for (std::size_t first = 0; first < packet_size; first += lane_count) {
      const Corners corners(rays, block, lane, first);
      const EdgeLanes<Floats> edges(corners.x, corners.y);
      if (lanes_of(edges.are_beside(corners.edge_error())) == all_lanes) continue;
      const FloatLanes scale = rays.shear[2].at(first);
      const auto lower = [](FloatLanes v) HWY_ATTR { return hn::LowerHalf(Halves(), v); };
      const auto upper = [](FloatLanes v) HWY_ATTR { return hn::UpperHalf(Halves(), v); };
      keep(rays, block.ids[lane], first, corners, scale, lower);
      keep(rays, block.ids[lane], first + half_count, corners, scale, upper);
    }
  }

  /// Decides about half of a vector's rays, and keeps the hits that are nearer.
  template <typename HalfOf>
  HWY_ATTR HWY_INLINE void keep(const RayPacket& rays, PrimitiveId id, std::size_t first,
                                const Corners& corners, FloatLanes scale, const HalfOf& half) {
    const auto wide = [&](FloatLanes v) HWY_ATTR { return hn::PromoteTo(Doubles(), half(v)); };
    const auto depth = [&](int corner) HWY_ATTR { return wide(hn::Mul(scale, corners.z[corner])); };
    const EdgeLanes<Doubles> edges({wide(corners.x[0]), wide(corners.x[1]), wide(corners.x[2])},
                                   {wide(corners.y[0]), wide(corners.y[1]), wide(corners.y[2])});
    const DoubleLanes determinant = edges.determinant();
    const auto is_met = hn::AndNot(edges.are_beside(), hn::Ne(determinant, hn::Zero(Doubles())));
    const DoubleLanes sum = edges.weighted(depth(0), depth(1), depth(2));
    const HalfLanes t = hn::DemoteTo(Halves(), hn::Div(sum, determinant));
    const HalfLanes nearest = hn::Load(Halves(), t_.values + first);
    const auto is_within =
        hn::And(hn::Ge(t, hn::Load(Halves(), rays.t_min.values + first)), hn::Le(t, nearest));
    std::uint32_t hits = bits_of(Doubles(), is_met) & bits_of(Halves(), is_within);
    if (hits == 0) return;
    hits = without_later(hits, bits_of(Halves(), hn::Eq(t, nearest)), id, first);
    const std::uint8_t bits[8] = {std::uint8_t(hits)};
    hn::BlendedStore(t, hn::LoadMaskBits(Halves(), bits), Halves(), t_.values + first);
    const auto is_hit = hn::LoadMaskBits(Doubles(), bits);
    hn::BlendedStore(edges.b, is_hit, Doubles(), terms_[0] + first);
    hn::BlendedStore(edges.c, is_hit, Doubles(), terms_[1] + first);
    hn::BlendedStore(determinant, is_hit, Doubles(), terms_[2] + first);
    found_ |= hits << first;
    for (; hits != 0; hits &= hits - 1) ids_[first + std::size_t(std::countr_zero(hits))] = id;
  }

  /// Without those that are as far away as a hit of a lesser name.
  HWY_ATTR HWY_INLINE std::uint32_t without_later(std::uint32_t hits, std::uint32_t equal, PrimitiveId id,
                                                  std::size_t first) const {
    for (std::uint32_t left = hits & equal & found_ >> first; left != 0; left &= left - 1)
      if (ids_[first + std::size_t(std::countr_zero(left))] < id) hits &= ~(left & -left);
    return hits;
  }

  /// A block with primitives that are no triangles: as single rays test it.
  HWY_ATTR HWY_NOINLINE void test_one_by_one(const Geometry& geometry, const RayPacket& rays,
                                             const PrimitiveBlock& block) {
    for (std::size_t i = 0; i < packet_size; ++i) {
      Ray room;
      CheckedRay ray;
      if (!RayLoader::load(rays.given->ray(i, room), ray)) continue;
      ray.instance = instance_;
      Nearest best;
      best.other = hit(i);
      best.t = best.other.t;
      BlockRay(ray).closest(geometry, ray, block, best);
      const Hit found = best.hit(ray);
      if (!found) continue;
      t_.values[i] = found.t;
      terms_[0][i] = found.u, terms_[1][i] = found.v, terms_[2][i] = 1;
      ids_[i] = {found.mesh, found.primitive};
      found_ |= 1u << i;
    }
  }

  Numbers t_;  ///< The ray's t_max where there is none yet.
  float latest_;
  std::uint32_t instance_;   ///< In whose space they are.
  std::uint32_t found_ = 0;  ///< Of each ray that has one there is:
  PrimitiveId ids_[packet_size];
  alignas(64) double terms_[3][packet_size];  ///< What u and v are made of, as in Nearest.
};

}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
