// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/rgb.h"
#include "core/vec.h"

namespace twinray {

/// What is scattered from one direction to another, but for delta directions.
struct BsdfValue {
  Rgb value;      ///< f(wo, wi), without the cosine.
  float pdf = 0;  ///< The density, per solid angle, with which the BSDF's sample() chooses wi.
};

/// What of the matte base of a surface, below all of its layers, may go below the surface
/// (core/subsurface.h): as it is reflected where it does not.
struct BelowSurface {
  /// The BSDF's sample() takes its direction from it where its number `lobe` is in [first, first +
  /// probability).
  float first = 0, probability = 0;
  Rgb albedo;  ///< Of light that goes along wo, the part that comes back from it: the integral of f |cos|.
  Rgb reflectance;  ///< Of that base, in [0, 1], without layers.
};

/// A direction in which light is scattered, in the frame of core/bsdf.h.
struct BsdfSample {
  Vec3 wi;
  Rgb value;      ///< The BSDF f(wo, wi); of a delta direction the factor of its light, over |cos(wi)|.
  float pdf = 0;  ///< Per solid angle; of a delta direction its probability. 0: nothing is scattered.
  bool is_delta = false;    ///< Whether no other direction near wi is scattered to: a mirror's.
  float eta = 1;            ///< Index of refraction on the side of wi, to that on the side of wo.
  bool is_diffuse = false;  ///< Whether a matte part of the surface chose wi, and no highlight.
};

}  // namespace twinray
