// SPDX-License-Identifier: Apache-2.0
#include "integrators/tracer.h"

#include <cstddef>

namespace twinray {

void Tracer::closest(std::span<const Ray> rays, std::span<Hit> hits) {
  if (!counting_) return accelerator_.closest_hits(rays, hits);
  for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = closest(rays[i]);
}

std::span<const Rgb> Tracer::visibilities(std::span<const Ray> shadow_rays) {
  note(shadow_rays, RayKind::shadow, counts_.shadow);
  blocked_.resize(shadow_rays.size());
  if (!counting_)
    accelerator_.any_hits(shadow_rays, blocked_);
  else
    for (std::size_t i = 0; i < shadow_rays.size(); ++i) blocked_[i] = is_blocked(shadow_rays[i]);
  visible_.resize(shadow_rays.size());
  for (std::size_t i = 0; i < shadow_rays.size(); ++i) visible_[i] = blocked_[i] ? Rgb{} : Rgb{1, 1, 1};
  return visible_;
}

}  // namespace twinray
