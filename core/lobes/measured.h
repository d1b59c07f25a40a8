// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/measured_brdf.h"

namespace twinray {

/// A measured material, on both sides of a surface. wo.z > 0.
class MeasuredLobe {
 public:
  /// `brdf` must outlive this. From behind the surface its x axis points the other way: what is seen there is
  /// what a point reflection of all directions makes of it, as in pbrt.
  MeasuredLobe(const MeasuredBrdf& brdf, bool is_behind) : brdf_(&brdf), sign_x_(is_behind ? -1.0f : 1.0f) {}

  const Rgb& albedo() const { return brdf_->albedo(); }
  BsdfValue evaluate(const Vec3& wo, const Vec3& wi) const { return brdf_->evaluate(turned(wo), turned(wi)); }
  BsdfSample sample(const Vec3& wo, float /*lobe*/, Vec2 u) const {
    BsdfSample scattered = brdf_->sample(turned(wo), u);
    scattered.wi = turned(scattered.wi);
    return scattered;
  }

 private:
  Vec3 turned(const Vec3& w) const { return {w.x * sign_x_, w.y, w.z}; }

  const MeasuredBrdf* brdf_;
  float sign_x_;
};

}  // namespace twinray
