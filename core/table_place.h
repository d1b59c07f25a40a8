// SPDX-License-Identifier: Apache-2.0
// Between the equally spaced entries of tables, as those of core/ggx_albedo.cpp and core/ggx_directions.cpp.
#pragma once
#include <algorithm>
#include <cmath>

namespace twinray {

/// Between two entries of a table with `count` equally spaced ones over [0, 1].
struct TablePlace {
  int first;
  float part;

  TablePlace(float x, int count) {
    const float scaled = (x > 0 ? std::min(x, 1.0f) : 0) * float(count - 1);
    first = std::min(int(scaled), count - 2);
    part = scaled - float(first);
  }
};

inline float between(float a, float b, float part) { return a + (b - a) * part; }

inline float at(const float* row, TablePlace x) { return between(row[x.first], row[x.first + 1], x.part); }

template <int count>
float at(const float (*table)[count], TablePlace y, TablePlace x) {
  return between(at(table[y.first], x), at(table[y.first + 1], x), y.part);
}

template <int rows, int count>
float at(const float (*table)[rows][count], TablePlace z, TablePlace y, TablePlace x) {
  return between(at(table[z.first], y, x), at(table[z.first + 1], y, x), z.part);
}

/// The fourth root of the reflectance along the normal, relative to that of an ior of 3.
inline float root_of_ior(float ior) { return std::sqrt(std::max(0.0f, 2 * (ior - 1) / (ior + 1))); }

/// Which tables are those of a boundary to an index of refraction, relative to that in front, and between
/// which of their layers it lies.
struct BoundaryPlace {
  bool is_out;  ///< Of the denser medium.
  TablePlace layer;

  BoundaryPlace(float eta, int count) : is_out(eta < 1), layer(root_of_ior(is_out ? 1 / eta : eta), count) {}
};

/// Where losses stand for a direction: they depend on how its cosine compares with alpha, mostly.
inline TablePlace place_of_angle(float cosine, float alpha, int count) {
  return {std::sqrt(cosine * (1 + alpha) / std::max(cosine + alpha, 1e-6f)), count};
}

}  // namespace twinray
