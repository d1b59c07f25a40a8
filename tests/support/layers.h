// SPDX-License-Identifier: Apache-2.0
// Layers as pbrt-v4 has them (LayeredBxDF without a medium): light goes to and fro between a coat and a base
// until it leaves. Slow, and free of closed forms: the oracle of coated materials.
#pragma once
#include "core/lobes/coat.h"
#include "core/lobes/dielectric_facets.h"
#include "core/lobes/specular.h"
#include "tests/support/lobe_checks.h"
#include "tests/support/statistics.h"

namespace twinray::test {

/// From straight above to grazing.
inline constexpr float coat_cosines[] = {1.0f, 0.6f, 0.2f};

/// Of alpha 0: a smooth one.
inline Coat coat_of(float alpha, float ior = 1.5f) { return alpha > 0 ? Coat(ior, Ggx(alpha)) : Coat(ior); }

/// What a walk brings: a direction above the coat and its weight, both zero where it was absorbed or cut.
struct LayerWalk {
  Vec3 wi;
  Rgb weight;
};

/// One walk from wo through a coat of index `ior` (alpha 0: smooth; else a boundary of this kind) over a
/// base. `depth`: how many times light may meet a layer below the first boundary; pbrt cuts at 10.
template <class Boundary, class Base>
LayerWalk walk_layers(float ior, float alpha, const Base& base, const Vec3& wo, int depth, Random& random) {
  const auto sample = [&](const auto& lobe, const Vec3& w) {
    const float choice = random.unit();
    const float u = random.unit();
    const float v = random.unit();
    BsdfSample s = lobe.sample(w, choice, {u, v});
    s.value = s.pdf > 0 ? s.value * (std::fabs(s.wi.z) / s.pdf * (s.wi.z < 0 ? s.eta * s.eta : 1)) : Rgb{};
    return s;
  };
  const auto boundary = [&](const Vec3& w, float eta) {
    return alpha > 0 ? sample(Boundary(Ggx(alpha), eta, white, white), w)
                     : sample(SmoothDielectricLobe(eta, white, white), w);
  };
  const BsdfSample first = boundary(wo, ior);
  if (first.wi.z > 0 || first.pdf == 0) return {first.wi, first.value};
  Rgb weight = first.value;
  Vec3 down = first.wi;
  for (int met = 0; met + 1 < depth; met += 2) {
    const BsdfSample up = sample(base, -down);
    weight = weight * up.value;
    if (is_black(weight)) return {};
    // Seen from below: the frame is turned over.
    const BsdfSample out = boundary(flipped(-up.wi), 1 / ior);
    weight = weight * out.value;
    if (is_black(weight)) return {};
    if (out.wi.z < 0) return {flipped(out.wi), weight};
    down = flipped(out.wi);
  }
  return {};
}

/// What `walks` such walks bring into each of `count` rings of equal projected area (cos^2), of all light:
/// mean and standard error in green. Delta directions are in it. pbrt's boundaries are facets that lose
/// light.
template <class Boundary = DielectricFacets, class Base>
std::vector<SampleMean> layer_rings(float ior, float alpha, const Base& base, const Vec3& wo, int depth) {
  constexpr int walks = 100000, count = 8;
  std::vector<SampleMean> rings(count);
  Random random(37);
  for (int i = 0; i < walks; ++i) {
    const LayerWalk walk = walk_layers<Boundary>(ior, alpha, base, wo, depth, random);
    const int ring = std::min(int(walk.wi.z * walk.wi.z * count), count - 1);
    for (int j = 0; j < count; ++j) rings[std::size_t(j)].add(j == ring ? walk.weight.g : 0);
  }
  return rings;
}

/// The same of a lobe, by sampling: its own estimate, with its error.
template <class Lobe>
std::vector<SampleMean> lobe_rings(const Lobe& lobe, const Vec3& wo) {
  constexpr int samples = 100000, count = 8;
  std::vector<SampleMean> rings(count);
  Random random(41);
  for (int i = 0; i < samples; ++i) {
    const float choice = random.unit();
    const float u = random.unit();
    const float v = random.unit();
    const BsdfSample s = lobe.sample(wo, choice, {u, v});
    const int ring = std::min(int(s.wi.z * s.wi.z * count), count - 1);
    for (int j = 0; j < count; ++j)
      rings[std::size_t(j)].add(j == ring && s.pdf > 0 ? s.value.g * s.wi.z / s.pdf : 0);
  }
  return rings;
}

inline double sum_of_means(const std::vector<SampleMean>& rings) {
  double sum = 0;
  for (const SampleMean& ring : rings) sum += ring.mean();
  return sum;
}

}  // namespace twinray::test
