// SPDX-License-Identifier: Apache-2.0
// The numbers are in core/ggx_albedo_tables.h; here they are interpolated.
#include "core/ggx_albedo.h"

#include "core/ggx_albedo_tables.h"

namespace twinray {
namespace {

/// Between two rows of a table with `count` equally spaced ones over [0, 1].
struct Place {
  int first;
  float part;

  Place(float x, int count) {
    const float scaled = (x > 0 ? std::min(x, 1.0f) : 0) * float(count - 1);
    first = std::min(int(scaled), count - 2);
    part = scaled - float(first);
  }
};

float mix(float a, float b, float part) { return a + (b - a) * part; }

float at(const float* row, Place x) { return mix(row[x.first], row[x.first + 1], x.part); }

template <int count>
float at(const float (*table)[count], Place y, Place x) {
  return mix(at(table[y.first], x), at(table[y.first + 1], x), y.part);
}

/// By the fourth root of the reflectance along the normal, relative to that of an ior of 3.
Place place_of_ior(float ior) {
  return {std::sqrt(std::max(0.0f, 2 * (ior - 1) / (ior + 1))), tables::ior_count};
}

}  // namespace

float ggx_loss(float cosine, float alpha) {
  // The loss depends on how cosine compares with alpha, mostly.
  const float angle = std::sqrt(cosine * (1 + alpha) / std::max(cosine + alpha, 1e-6f));
  return at(tables::loss, Place(alpha, tables::loss_count), Place(angle, tables::loss_count));
}

float average_ggx_loss(float alpha) { return at(tables::average_loss, Place(alpha, tables::loss_count)); }

float ggx_dielectric_reflectance(float cosine, float alpha, float ior) {
  const Place layer = place_of_ior(ior), y(std::sqrt(alpha), tables::alpha_count),
              x(std::sqrt(cosine), tables::cosine_count);
  return mix(at(tables::dielectric[layer.first], y, x), at(tables::dielectric[layer.first + 1], y, x),
             layer.part);
}

float average_ggx_dielectric_reflectance(float alpha, float ior) {
  return at(tables::average_dielectric, place_of_ior(ior), Place(std::sqrt(alpha), tables::alpha_count));
}

MultipleScattering::MultipleScattering(const Ggx& facets)
    : alpha_(facets.mean_alpha()), average_loss_(average_ggx_loss(alpha_)) {}

float MultipleScattering::evaluate(float cos_o, float cos_i) const {
  return average_loss_ > 0 ? loss(cos_o) * loss(cos_i) / (pi * average_loss_) : 0;
}

Rgb MultipleScattering::absorption(const Rgb& average) const {
  const auto channel = [&](float f) { return f * f * (1 - average_loss_) / (1 - f * average_loss_); };
  return {channel(average.r), channel(average.g), channel(average.b)};
}

}  // namespace twinray
