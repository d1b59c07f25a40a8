// SPDX-License-Identifier: Apache-2.0
// Private: GGX facets (core/microfacet.h), what boundaries reflect (core/fresnel.h) and its tables
// (core/ggx_albedo.h) in lanes, compiled once for each instruction set.
#if defined(TWINRAY_WAVE_FACETS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TWINRAY_WAVE_FACETS_INL_H
#undef TWINRAY_WAVE_FACETS_INL_H
#else
#define TWINRAY_WAVE_FACETS_INL_H
#endif

#include "core/ggx_albedo_tables.h"
#include "core/ggx_direction_tables.h"
#include "integrators/wave/lobe_surfaces.h"
#include "integrators/wave/warp-inl.h"

HWY_BEFORE_NAMESPACE();
namespace twinray::HWY_NAMESPACE {

using IndexTag = hn::RebindToSigned<FloatTag>;
using IndexLanes = hn::Vec<IndexTag>;

/// From number k on; 0 behind the last of them.
HWY_ATTR HWY_INLINE IndexLanes indices(const Words& column, std::size_t k, std::size_t size) {
  const auto words = hn::IfThenElseZero(hn::FirstN(WordTag(), size - k), load(column, k));
  return hn::BitCast(IndexTag(), words);
}

/// std::min(1, a): 1 where a is NaN.
HWY_ATTR HWY_INLINE Lanes not_above_1(Lanes a) { return select(hn::Lt(a, splat(1)), a, splat(1)); }

HWY_ATTR HWY_INLINE Lanes3 normalize(const Lanes3& a) { return a / hn::Sqrt(dot(a, a)); }

/// Between the equally spaced entries of a table over [0, 1]: TablePlace in core/table_place.h.
struct TablePlaceLanes {
  IndexLanes first;
  Lanes part;

  HWY_ATTR HWY_INLINE TablePlaceLanes(Lanes x, int count) {
    const Lanes scaled = hn::Mul(hn::IfThenElseZero(is_positive(x), not_above_1(x)), splat(float(count - 1)));
    first = hn::Min(hn::ConvertTo(IndexTag(), scaled), hn::Set(IndexTag(), count - 2));
    part = hn::Sub(scaled, hn::ConvertTo(FloatTag(), first));
  }
};

HWY_ATTR HWY_INLINE Lanes between(Lanes a, Lanes b, Lanes part) {
  return hn::Add(a, hn::Mul(hn::Sub(b, a), part));
}
/// At a place of the row that begins at each lane's index.
HWY_ATTR HWY_INLINE Lanes at(const float* table, IndexLanes row, const TablePlaceLanes& x) {
  const FloatTag tag;
  const IndexLanes index = hn::Add(row, x.first);
  return between(hn::GatherIndex(tag, table, index), hn::GatherIndex(tag, table + 1, index), x.part);
}

/// Between the rows at y of the table that begins at each lane's index.
HWY_ATTR HWY_INLINE Lanes at(const float* table, IndexLanes first, const TablePlaceLanes& y,
                             const TablePlaceLanes& x, int columns) {
  const IndexLanes width = hn::Set(IndexTag(), columns);
  const IndexLanes row = hn::Add(first, hn::Mul(y.first, width));
  return between(at(table, row, x), at(table, hn::Add(row, width), x), y.part);
}

HWY_ATTR HWY_INLINE TablePlaceLanes place_of_angle(Lanes cosine, Lanes alpha, int count) {
  const Lanes sum = hn::Add(cosine, alpha), least = splat(1e-6f);
  return {
      hn::Sqrt(hn::Div(hn::Mul(cosine, hn::Add(splat(1), alpha)), select(hn::Lt(sum, least), least, sum))),
      count};
}

HWY_ATTR HWY_INLINE Lanes ggx_loss(Lanes cosine, Lanes alpha) {
  constexpr int count = tables::loss_count;
  return at(tables::loss[0], hn::Zero(IndexTag()), TablePlaceLanes(alpha, count),
            place_of_angle(cosine, alpha, count), count);
}

HWY_ATTR HWY_INLINE Lanes fresnel_dielectric(Lanes cos_i, Lanes eta) {
  const Lanes one = splat(1);
  const Lanes squared = hn::Add(hn::Sub(hn::Mul(eta, eta), one), hn::Mul(cos_i, cos_i));
  const Lanes cos_t = hn::Div(hn::Sqrt(positive(squared)), eta);
  const Lanes along = hn::Mul(eta, cos_i), across = hn::Mul(eta, cos_t);
  const Lanes parallel = hn::Div(hn::Sub(along, cos_t), hn::Add(along, cos_t));
  const Lanes perpendicular = hn::Div(hn::Sub(cos_i, across), hn::Add(cos_i, across));
  const Lanes reflected =
      hn::Mul(splat(0.5f), hn::Add(hn::Mul(parallel, parallel), hn::Mul(perpendicular, perpendicular)));
  const Lanes total = select(hn::Eq(cos_t, hn::Zero(FloatTag())), one, reflected);
  return hn::IfThenZeroElse(hn::Eq(eta, one), total);
}

HWY_ATTR HWY_INLINE Lanes fresnel_conductor(Lanes cos_i, Lanes eta, Lanes k) {
  const Lanes one = splat(1), half = splat(0.5f);
  const Lanes cos2 = hn::Mul(cos_i, cos_i), sin2 = hn::Sub(one, cos2);
  const Lanes difference = hn::Sub(hn::Sub(hn::Mul(eta, eta), hn::Mul(k, k)), sin2);
  const Lanes product = hn::Mul(hn::Mul(hn::Mul(hn::Mul(splat(4), eta), eta), k), k);
  const Lanes squares = hn::Sqrt(hn::Add(hn::Mul(difference, difference), product));
  const Lanes a = hn::Sqrt(positive(hn::Mul(half, hn::Add(squares, difference))));
  const Lanes across = hn::Mul(hn::Mul(splat(2), a), cos_i);
  const Lanes perpendicular =
      hn::Div(positive(hn::Sub(hn::Add(squares, cos2), across)), hn::Add(hn::Add(squares, cos2), across));
  const Lanes along = hn::Mul(across, sin2), rest = hn::Add(hn::Mul(cos2, squares), hn::Mul(sin2, sin2));
  const Lanes both = hn::Add(rest, along);
  const Lanes parallel = hn::Div(positive(hn::Sub(rest, along)), both);
  const Lanes reflected = hn::Mul(hn::Mul(half, perpendicular), hn::Add(one, parallel));
  return select(is_positive(cos_i), select(is_positive(both), reflected, perpendicular), one);
}

/// Two directions of which one is the mirror image of the other at a facet: FacetReflection.
struct FacetReflectionLanes {
  Lanes cosine, value, pdf;
};

/// Azimuth.
struct AzimuthLanes {
  Lanes share, skew2;
};

/// Ggx.
struct GgxLanes {
  Lanes x, y;

  HWY_ATTR HWY_INLINE LaneMask has_two_alphas() const { return hn::Ne(x, y); }
  HWY_ATTR HWY_INLINE AzimuthLanes azimuth(const Lanes3& w) const {
    const Lanes xx = hn::Mul(x, w.x), yy = hn::Mul(y, w.y), xy = hn::Mul(x, w.y), yx = hn::Mul(y, w.x);
    const Lanes along2 = hn::Add(hn::Mul(xx, xx), hn::Mul(yy, yy));
    const Lanes across2 = hn::Add(hn::Mul(xy, xy), hn::Mul(yx, yx)), both2 = hn::Add(along2, across2);
    const Lanes along = hn::Sqrt(along2), mixed = hn::Sub(hn::Mul(yx, yy), hn::Mul(xx, xy));
    const Lanes skew = hn::Div(hn::Mul(splat(2), mixed), both2);
    const LaneMask has_azimuth = is_positive(both2);
    const Lanes share_of_x = hn::Div(x, hn::Add(x, y));
    return {select(has_azimuth, hn::Div(along, hn::Add(along, hn::Sqrt(across2))), share_of_x),
            hn::IfThenElseZero(has_azimuth, hn::Mul(skew, skew))};
  }
  HWY_ATTR HWY_INLINE Lanes density(const Lanes3& m) const {
    const Lanes mx = hn::Div(m.x, x), my = hn::Div(m.y, y);
    const Lanes ellipsoid = hn::Add(hn::Add(hn::Mul(mx, mx), hn::Mul(my, my)), hn::Mul(m.z, m.z));
    const Lanes area = hn::Mul(hn::Mul(splat(pi), x), y);
    return hn::Div(splat(1), hn::Mul(hn::Mul(area, ellipsoid), ellipsoid));
  }
  HWY_ATTR HWY_INLINE Lanes lambda(const Lanes3& w) const {
    const Lanes one = splat(1), wx = hn::Mul(x, w.x), wy = hn::Mul(y, w.y);
    const Lanes slope2 = hn::Div(hn::Add(hn::Mul(wx, wx), hn::Mul(wy, wy)), hn::Mul(w.z, w.z));
    return hn::Div(hn::Mul(splat(0.5f), slope2), hn::Add(one, hn::Sqrt(hn::Add(one, slope2))));
  }
  HWY_ATTR HWY_INLINE FacetReflectionLanes reflection(const Lanes3& wo, const Lanes3& wi) const {
    const Lanes one = splat(1), four_z = hn::Mul(splat(4), wo.z);
    const Lanes3 m = normalize(wo + wi);
    const Lanes facets = density(m), seen_o = hn::Add(one, lambda(wo));
    const Lanes unhidden = hn::Div(one, hn::Add(seen_o, lambda(wi)));
    return {not_above_1(dot(wo, m)), hn::Div(hn::Mul(facets, unhidden), hn::Mul(four_z, wi.z)),
            hn::Div(hn::Mul(hn::Div(one, seen_o), facets), four_z)};
  }
  /// sample_visible, and where w is reflected to there.
  HWY_ATTR HWY_INLINE Lanes3 sample_reflected(const Lanes3& w, Lanes u, Lanes v) const {
    const Lanes one = splat(1);
    const Lanes3 stretched = normalize(Lanes3{hn::Mul(x, w.x), hn::Mul(y, w.y), w.z});
    const Lanes z = hn::Sub(hn::Mul(hn::Sub(one, v), hn::Add(one, stretched.z)), stretched.z);
    const Lanes r = hn::Sqrt(positive(hn::Mul(hn::Sub(one, z), hn::Add(one, z))));
    const SinCosLanes angle = sincos_turns(u);
    const Lanes3 m{hn::Mul(x, hn::Add(hn::Mul(r, angle.cos), stretched.x)),
                   hn::Mul(y, hn::Add(hn::Mul(r, angle.sin), stretched.y)),
                   positive(hn::Add(z, stretched.z))};
    const Lanes length2 = dot(m, m);
    const Lanes3 normal = select(is_positive(length2), m / hn::Sqrt(length2), splat(0, 0, 1));
    return normal * hn::Mul(splat(2), dot(w, normal)) - w;
  }
};

HWY_ATTR HWY_INLINE GgxLanes ggx(const FacetColumns& alphas, std::size_t k) {
  return {load(alphas.x, k), load(alphas.y, k)};
}

/// core/ggx_directions.h.
HWY_ATTR HWY_INLINE Lanes ggx_loss_change(const GgxLanes& facets, Lanes alpha, const Lanes3& w) {
  constexpr int shares = tables::share_count, angles = tables::change_angle_count;
  const AzimuthLanes azimuth = facets.azimuth(w);
  const TablePlaceLanes z(alpha, tables::change_alpha_count), y(azimuth.share, shares),
      x = place_of_angle(w.z, alpha, angles);
  const IndexLanes size = hn::Set(IndexTag(), (shares + 1) * angles), first = hn::Mul(z.first, size);
  const float *table = tables::loss_change[0][0], *skew = tables::loss_change[0][shares];
  const IndexLanes second = hn::Add(first, size);
  const Lanes along = between(at(table, first, y, x, angles), at(table, second, y, x, angles), z.part);
  const Lanes added = between(at(skew, first, x), at(skew, second, x), z.part);
  return hn::Add(along, hn::Mul(added, azimuth.skew2));
}

/// MultipleScattering, and the lobe's factor of it.
struct MultipleLanes {
  GgxLanes facets;
  Lanes alpha, average_loss;
  Lanes3 factor;

  HWY_ATTR HWY_INLINE MultipleLanes(const GgxLanes& of, const MultipleColumns& at, std::size_t k)
      : facets(of),
        alpha(load(at.alpha, k)),
        average_loss(load(at.average_loss, k)),
        factor(load(at.factor, k)) {}

  HWY_ATTR HWY_INLINE Lanes loss(const Lanes3& w) const {
    const Lanes one_alpha = ggx_loss(w.z, alpha);
    const LaneMask has_two = facets.has_two_alphas();
    if (hn::AllFalse(FloatTag(), has_two)) return one_alpha;
    const Lanes changed = hn::Add(one_alpha, ggx_loss_change(facets, alpha, w));
    return select(has_two, not_above_1(positive(changed)), one_alpha);
  }
  /// evaluate(), by the losses along both directions.
  HWY_ATTR HWY_INLINE Lanes evaluate(Lanes loss_o, Lanes loss_i) const {
    return hn::IfThenElseZero(is_positive(average_loss),
                              hn::Div(hn::Mul(loss_o, loss_i), hn::Mul(splat(pi), average_loss)));
  }
};

/// Coat.
struct CoatLanes {
  const float* rows;
  IndexLanes row;
  GgxLanes facets;
  LaneMask is_smooth;
  Lanes ior;

  HWY_ATTR HWY_INLINE CoatLanes(const CoatColumns& at, std::size_t k, std::size_t size)
      : rows(at.rows.front().data()),
        row(indices(at.row, k, size)),
        facets(ggx(at.facets, k)),
        is_smooth(hn::Eq(facets.x, hn::Zero(FloatTag()))),
        ior(load(at.ior, k)) {}

  HWY_ATTR HWY_INLINE Lanes reflectance(Lanes cosine) const {
    const Lanes rough = at(rows, row, TablePlaceLanes(hn::Sqrt(cosine), tables::cosine_count));
    if (hn::AllFalse(FloatTag(), is_smooth)) return rough;
    return select(is_smooth, fresnel_dielectric(cosine, ior), rough);
  }
};

}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
