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
#include "accel/canonical/load_ray-inl.h"
#include "accel/canonical/ray_packet-inl.h"
#include "accel/canonical/triangle.h"

HWY_BEFORE_NAMESPACE();
namespace twinray::HWY_NAMESPACE {

/// The nearest hits so far of a packet's rays.
class PacketHits : PacketLanes {
 public:
  HWY_ATTR HWY_INLINE explicit PacketHits(const RayPacket& rays) : t_(rays.t_max) { find_latest(); }

  /// The largest t that counts for any ray.
  float latest() const { return latest_; }

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
    return {t_.values[ray], u, v, ids_[ray].primitive, ids_[ray].mesh, no_instance};
  }

 private:
  // A half of the rays of a vector.
  using Halves = hn::Half<Floats>;
  using Doubles = hn::Rebind<double, Halves>;
  using HalfLanes = hn::Vec<Halves>;
  using DoubleLanes = hn::Vec<Doubles>;
  static constexpr std::size_t half_count = lane_count / 2;

  /// ShearedVertex of a vector's rays, z not yet in units of t.
  struct Vertex {
    FloatLanes x, y, z;
  };

  HWY_ATTR HWY_INLINE void find_latest() {
    Range range;
    range.add(t_);
    latest_ = range.largest();
  }

  HWY_ATTR HWY_INLINE void test_triangle(const RayPacket& rays, const PrimitiveBlock& block, int lane) {
    for (std::size_t first = 0; first < packet_size; first += lane_count) {
      const Vertex p = vertex(rays, block, 0, lane, first), q = vertex(rays, block, 1, lane, first),
                   r = vertex(rays, block, 2, lane, first);
      if (lanes_of(is_beside(p, q, r)) == all_lanes) continue;
      const FloatLanes scale = rays.shear[2].at(first);
      const PrimitiveId id = block.ids[lane];
      keep(
          rays, id, first, [](FloatLanes v) HWY_ATTR { return hn::LowerHalf(Halves(), v); }, p, q, r, scale);
      keep(
          rays, id, first + half_count, [](FloatLanes v) HWY_ATTR { return hn::UpperHalf(Halves(), v); }, p,
          q, r, scale);
    }
  }

  static HWY_ATTR HWY_INLINE Vertex vertex(const RayPacket& rays, const PrimitiveBlock& block, int corner,
                                           int lane, std::size_t first) {
    FloatLanes from_ray[3];
    for (int k = 0; k < 3; ++k)
      from_ray[k] = hn::Sub(hn::Set(Floats(), block.corners[corner][rays.axes[k]][lane]),
                            rays.turned_origin[k].at(first));
    const FloatLanes z = from_ray[2];
    return {hn::Sub(from_ray[0], hn::Mul(rays.shear[0].at(first), z)),
            hn::Sub(from_ray[1], hn::Mul(rays.shear[1].at(first), z)), z};
  }

  /// The canonical is_beside().
  static HWY_ATTR HWY_INLINE hn::Mask<Floats> is_beside(const Vertex& p, const Vertex& q, const Vertex& r) {
    const FloatLanes a = cross(r, q), b = cross(p, r), c = cross(q, p);
    const FloatLanes x = hn::Max(hn::Abs(p.x), hn::Max(hn::Abs(q.x), hn::Abs(r.x)));
    const FloatLanes y = hn::Max(hn::Abs(p.y), hn::Max(hn::Abs(q.y), hn::Abs(r.y)));
    const FloatLanes error =
        hn::Add(hn::Mul(hn::Set(Floats(), edge_margin), hn::Mul(x, y)), hn::Set(Floats(), edge_underflow));
    return hn::And(hn::Lt(hn::Min(a, hn::Min(b, c)), hn::Neg(error)),
                   hn::Gt(hn::Max(a, hn::Max(b, c)), error));
  }
  static HWY_ATTR HWY_INLINE FloatLanes cross(const Vertex& p, const Vertex& q) {
    return hn::Sub(hn::Mul(p.x, q.y), hn::Mul(q.x, p.y));
  }

  /// EdgeFunctions<double> of half a vector's rays, and what follows from them. A product of two floats is
  /// exact in double, and so a fused multiply-subtract has the bits of separate steps.
  template <typename HalfOf>
  HWY_ATTR HWY_INLINE void keep(const RayPacket& rays, PrimitiveId id, std::size_t first, const HalfOf& half,
                                const Vertex& p, const Vertex& q, const Vertex& r, FloatLanes scale) {
    const auto wide = [&](FloatLanes v) HWY_ATTR { return hn::PromoteTo(Doubles(), half(v)); };
    const DoubleLanes px = wide(p.x), py = wide(p.y), qx = wide(q.x), qy = wide(q.y), rx = wide(r.x),
                      ry = wide(r.y);
    const DoubleLanes a = hn::MulSub(rx, qy, hn::Mul(ry, qx)), b = hn::MulSub(px, ry, hn::Mul(py, rx)),
                      c = hn::MulSub(qx, py, hn::Mul(qy, px));
    const DoubleLanes zero = hn::Zero(Doubles());
    const auto is_beside = hn::And(hn::Lt(hn::Min(a, hn::Min(b, c)), zero),  //
                                   hn::Gt(hn::Max(a, hn::Max(b, c)), zero));
    const DoubleLanes determinant = hn::Add(hn::Add(a, b), c);
    const auto is_met = hn::AndNot(is_beside, hn::Ne(determinant, zero));
    const auto depth = [&](const Vertex& v) HWY_ATTR { return wide(hn::Mul(scale, v.z)); };
    const DoubleLanes sum =
        hn::Add(hn::Add(hn::Mul(a, depth(p)), hn::Mul(b, depth(q))), hn::Mul(c, depth(r)));
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
    hn::BlendedStore(b, is_hit, Doubles(), terms_[0] + first);
    hn::BlendedStore(c, is_hit, Doubles(), terms_[1] + first);
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
      CheckedRay ray;
      RayLoader::load(rays.given[i], ray);
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
  std::uint32_t found_ = 0;  ///< Bit i: ray i has one, and there is of it:
  PrimitiveId ids_[packet_size];
  alignas(64) double terms_[3][packet_size];  ///< What u and v are made of, as in Nearest.
};

}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
