// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cmath>
#include <limits>

#include "core/density_grid.h"
#include "core/ray.h"
#include "core/scene.h"

namespace twinray {

/// A parameter of a ray at least so far behind its beginning as `distance`, but hardly more; infinite
/// likewise.
inline float t_beyond(const Ray& ray, float distance) {
  constexpr float slack = 1 + 0x1p-20f;  // More than what rounding takes, but for the sum's.
  constexpr float infinity = std::numeric_limits<float>::infinity();
  return std::nextafter(ray.t_min + distance * slack / length(ray.direction), infinity);
}

/// How much of a medium lies along a stretch of a ray, from where it begins to its parameter t: its length,
/// where the medium is even, else that times its density. The scene and the ray must outlive it.
class MediumColumn {
 public:
  MediumColumn(const Scene& scene, const Interior& medium, const Ray& ray, float t)
      : grid_(medium.density == no_density ? nullptr : scene.densities[medium.density].get()),
        ray_(ray),
        t_(t),
        length_((t - ray.t_min) * length(ray.direction)) {}

  /// May be infinite. Where it is more than `most`, something that is, too.
  float amount(float most = infinite_) const {
    return grid_ ? float(grid_->amount(ray_, ray_.t_min, t_, double(most))) : length_;
  }
  struct Reach {
    float distance;  ///< Behind the beginning, >= 0; infinite where there is less,
    float amount;    ///< which is this.
  };
  /// How far so much gets; amount >= 0, and may be infinite.
  Reach reach(float amount) const {
    if (!grid_) return amount < length_ ? Reach{amount, amount} : Reach{infinite_, length_};
    const DensityGrid::Reach end = grid_->reach(ray_, ray_.t_min, t_, double(amount));
    return {(end.t - ray_.t_min) * length(ray_.direction), float(end.amount)};
  }

 private:
  static constexpr float infinite_ = std::numeric_limits<float>::infinity();

  const DensityGrid* grid_;
  const Ray& ray_;
  float t_, length_;
};

}  // namespace twinray
