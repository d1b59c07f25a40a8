// SPDX-License-Identifier: Apache-2.0
#include "core/regularize.h"

#include <algorithm>
#include <cmath>

namespace twinray {
namespace {

float regularized(float alpha) { return alpha < 0.3f ? std::clamp(2 * alpha, 0.1f, 0.3f) : alpha; }
Roughness regularized(const Roughness& r) { return {regularized(r.x), regularized(r.y)}; }

/// A conductor with no index and any absorption reflects everything.
constexpr Rgb no_index{0, 0, 0}, any_absorption{1, 1, 1};

struct Regularized {
  SurfaceModel operator()(const Mirror& m) const {
    return Conductor{no_index, any_absorption, regularized(Roughness{}), m.reflectance};
  }
  SurfaceModel operator()(const Glass& m) const {
    return Dielectric{m.ior, regularized(Roughness{}), m.reflectance, m.transmittance};
  }
  SurfaceModel operator()(Microfacet m) const {
    m.alpha = regularized(m.alpha);
    return m;
  }
  SurfaceModel operator()(CoatedConductor m) const {
    m.coat_roughness = regularized(m.coat_roughness);
    return rough(m);
  }
  SurfaceModel operator()(Principled m) const {
    for (float* const roughness : {&m.specular_roughness, &m.coat_roughness})
      *roughness = std::sqrt(regularized(*roughness * *roughness));
    return m;
  }
  SurfaceModel operator()(const Dielectric& m) const { return m.is_thin ? m : rough(m); }
  SurfaceModel operator()(const Conductor& m) const { return rough(m); }
  SurfaceModel operator()(const CoatedDiffuse& m) const { return rough(m); }
  template <typename Model>
  SurfaceModel operator()(const Model& m) const {
    return m;
  }

  template <typename Model>
  static Model rough(Model m) {
    m.roughness = regularized(m.roughness);
    return m;
  }
};

}  // namespace

SurfaceModel regularized(const SurfaceModel& model) { return std::visit(Regularized{}, model); }

}  // namespace twinray
