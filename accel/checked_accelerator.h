// SPDX-License-Identifier: Apache-2.0
// Private: what the engines have in common that answer loaded rays.
#pragma once
#include "accel/accelerator.h"
#include "accel/canonical/checked_ray.h"

namespace twinray {

/// Loads each ray and scales the answer back.
class CheckedAccelerator : public Accelerator {
 private:
  // t in these answers is that of the scaled ray.
  virtual Hit trace_closest(const CheckedRay& ray) const noexcept = 0;
  virtual bool trace_any(const CheckedRay& ray) const noexcept = 0;
  virtual Hit count_closest(const CheckedRay& ray, QueryCounts& counts) const noexcept = 0;
  virtual bool count_any(const CheckedRay& ray, QueryCounts& counts) const noexcept = 0;

  // One variable that every path returns: the hit is written where it goes, for copying what was just written
  // in parts stalls.
  Hit find_closest(const Ray& ray) const noexcept final {
    Hit hit;
    CheckedRay checked;
    if (!load_ray(ray, checked)) return hit;
    hit = trace_closest(checked);
    checked.scale_back(hit);
    return hit;
  }
  bool find_any(const Ray& ray) const noexcept final {
    CheckedRay checked;
    return load_ray(ray, checked) && trace_any(checked);
  }
  Hit find_closest(const Ray& ray, QueryCounts& counts) const noexcept final {
    Hit hit;
    CheckedRay checked;
    if (!load_ray(ray, checked)) return hit;
    hit = count_closest(checked, counts);
    checked.scale_back(hit);
    return hit;
  }
  bool find_any(const Ray& ray, QueryCounts& counts) const noexcept final {
    CheckedRay checked;
    return load_ray(ray, checked) && count_any(checked, counts);
  }
};

}  // namespace twinray
