// SPDX-License-Identifier: Apache-2.0
// A fixed table of rays and shapes with the bits of their canonical hits: the same on every processor, with
// any instruction set and any compiler flags. An installed consumer can include this file: it needs the
// public headers and the file canonical_table.inc beside it.
#pragma once
#include <bit>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "accel/accelerator.h"

namespace twinray::test {

/// kind 't': the corners of a triangle; 's': centre and radius of a sphere; 'b': lower and upper corner of a
/// box, whose t and u are the near and the far of its slab test (private, so checked inside of the project
/// only). ray: origin, direction, t_min, t_max. A miss has t = infinity.
struct CanonicalRow {
  char kind;
  float shape[9];
  float ray[8];
  float t, u, v;
};

inline constexpr CanonicalRow canonical_rows[] = {
#include "canonical_table.inc"
};

inline Ray ray_of(const CanonicalRow& row) {
  const float* r = row.ray;
  return {.origin = {r[0], r[1], r[2]}, .direction = {r[3], r[4], r[5]}, .t_min = r[6], .t_max = r[7]};
}

inline Geometry geometry_of(const CanonicalRow& row) {
  const float* s = row.shape;
  if (row.kind == 's') return Geometry({SphereSet{"", {{{s[0], s[1], s[2]}, s[3]}}}});
  Mesh mesh;
  mesh.positions = {{s[0], s[1], s[2]}, {s[3], s[4], s[5]}, {s[6], s[7], s[8]}};
  mesh.triangles = {{0, 1, 2}};
  return Geometry({mesh});
}

/// Whether an answer has the row's bits; the sign of a zero counts.
inline bool has_bits(const CanonicalRow& row, float t, float u, float v) {
  const auto same = [](float a, float b) {
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
  };
  return same(row.t, t) && same(row.u, u) && same(row.v, v);
}

inline std::string mismatch(std::size_t index, const CanonicalRow& row, const Hit& hit) {
  return "row " + std::to_string(index) + " (" + row.kind + "): t " + std::to_string(hit.t) + " instead of " +
         std::to_string(row.t) + ", or other bits of t, u, v";
}

/// The rows whose closest hit, from trace(geometry, ray), has other bits; boxes are left out.
template <typename Trace>
std::vector<std::string> canonical_mismatches(Trace trace) {
  std::vector<std::string> wrong;
  for (std::size_t i = 0; i < std::size(canonical_rows); ++i) {
    const CanonicalRow& row = canonical_rows[i];
    if (row.kind == 'b') continue;
    const Hit hit = trace(geometry_of(row), ray_of(row));
    if (!has_bits(row, hit.t, hit.u, hit.v)) wrong.push_back(mismatch(i, row, hit));
  }
  return wrong;
}

/// The same through the public interface, by a backend that promises canonical answers.
inline std::vector<std::string> canonical_mismatches(Backend backend = Backend::brute_force) {
  return canonical_mismatches([backend](Geometry geometry, const Ray& ray) {
    return build_accelerator(backend, std::make_shared<const Geometry>(std::move(geometry)))
        ->closest_hit(ray);
  });
}

}  // namespace twinray::test
