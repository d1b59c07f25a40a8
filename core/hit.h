// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cmath>
#include <cstdint>
#include <limits>

namespace twinray {

/// The id of "no instance": the shape stands in the scene directly.
inline constexpr std::uint32_t no_instance = 0xffffffff;

/// Where a ray meets a shape: all that an accelerator knows. core/surface.h expands it.
struct Hit {
  float t = std::numeric_limits<float>::infinity();  ///< The ray's parameter; infinity is a miss.
  float u = 0, v = 0;  ///< Triangle: weights of the 2nd and 3rd vertex. Sphere: octahedral normal, in [0, 1].
  std::uint32_t primitive = 0;  ///< Index of the triangle or sphere within its shape.
  std::uint32_t mesh = 0;       ///< Index of the shape (mesh or sphere set) within the geometry.
  std::uint32_t instance = no_instance;

  bool is_miss() const { return std::isinf(t); }
  explicit operator bool() const { return !is_miss(); }
  friend bool operator==(const Hit&, const Hit&) = default;
};

/// The canonical order of hits: by t, then by ids. The answer of a closest-hit query is the least accepted
/// hit.
inline bool precedes(const Hit& a, const Hit& b) {
  if (a.t != b.t) return a.t < b.t;
  if (a.instance != b.instance) return a.instance < b.instance;
  if (a.mesh != b.mesh) return a.mesh < b.mesh;
  return a.primitive < b.primitive;
}

}  // namespace twinray
