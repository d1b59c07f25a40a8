// SPDX-License-Identifier: Apache-2.0
#include "integrators/scattering.h"

namespace twinray {
namespace {

Seeking seeking_of(const Interaction& at, const BsdfSample& sample) {
  if (sample.is_delta) return Seeking::alone;
  return at.is_lambert() ? Seeking::zones : Seeking::all;
}

ScatterKind kind_of(const Interaction& at, const BsdfSample& sample) {
  if (at.is_in_medium() || sample.wi.z < 0) return ScatterKind::transmission;
  return sample.is_diffuse ? ScatterKind::diffuse : ScatterKind::glossy;
}

/// Into the body, whatever the normals say.
std::optional<Scattering> enter(const Interaction& at, const Rgb& throughput, Vec2 u) {
  const BsdfSample sample = at.sample_below(u);
  const Rgb next = throughput * sample.value * (at.cosine(sample) / sample.pdf);
  if (is_black(next)) return std::nullopt;
  Vec3 wi = at.to_world(sample.wi);
  const Vec3 outward = facing(at.point().geometric_normal, at.wo());
  if (const float above = dot(outward, wi); above > 0) wi = wi - outward * (2 * above);
  return Scattering{wi,  next, {at.receiver(), sample.pdf}, at.interiors(at.wo()), 1, ScatterKind::diffuse,
                    true};
}

}  // namespace

std::optional<Scattering> scatter(const Interaction& at, const Rgb& throughput, float lobe, Vec2 u) {
  if (at.goes_below(lobe)) return enter(at, throughput, u);
  const BsdfSample sample = at.sample(lobe, u);
  if (sample.pdf == 0) return std::nullopt;
  const Vec3 wi = at.to_world(sample.wi);
  if (!at.is_consistent(wi)) return std::nullopt;
  const Rgb next = throughput * sample.value * (at.kept(wi) * at.cosine(sample) / sample.pdf);
  if (is_black(next)) return std::nullopt;
  const Departure departure{at.receiver(), sample.pdf, seeking_of(at, sample)};
  return Scattering{wi, next, departure, at.interiors(wi), sample.eta, kind_of(at, sample)};
}

}  // namespace twinray
