// SPDX-License-Identifier: Apache-2.0
#include "integrators/scattering.h"

#include "core/frame.h"

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

/// The way into a body is matte around the geometric normal: that is how light comes into it, whatever other
/// normals say.
Vec3 into_body(const Interaction& at, const Vec3& local) {
  return Frame(facing(at.point().geometric_normal, at.wo())).to_world(local);
}

}  // namespace

std::optional<Scattering> scatter(const Interaction& at, const Rgb& throughput, float lobe, Vec2 u) {
  const BsdfSample sample = at.sample(lobe, u);
  if (sample.pdf == 0) return std::nullopt;
  const Vec3 wi = at.to_world(sample.wi);
  const bool is_below = at.goes_below(lobe);
  if (!is_below && !at.is_consistent(wi)) return std::nullopt;
  const float kept = is_below ? 1 : at.kept(wi);
  const Rgb next = throughput * sample.value * (kept * at.cosine(sample) / sample.pdf);
  if (is_black(next)) return std::nullopt;
  const Departure departure{at.receiver(), sample.pdf, seeking_of(at, sample)};
  if (is_below)
    return Scattering{.direction = into_body(at, sample.wi),
                      .throughput = next,
                      .departure = departure,
                      .interiors = at.interiors(at.wo()),
                      .is_below = true};
  return Scattering{wi, next, departure, at.interiors(wi), sample.eta, kind_of(at, sample)};
}

}  // namespace twinray
