// SPDX-License-Identifier: Apache-2.0
#include "accel/accelerator.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "core/denormals.h"

namespace twinray {

Accelerator::Accelerator(std::shared_ptr<const Geometry> geometry, AccelStats stats)
    : geometry_(std::move(geometry)), stats_(std::move(stats)) {
  stats_.primitives = geometry_->primitive_count();
}

Hit Accelerator::closest_with_denormals(Query query) const noexcept {
  const KeepDenormals keep;
  return closest(query);
}

bool Accelerator::any_with_denormals(Query query) const noexcept {
  const KeepDenormals keep;
  return any(query);
}

void Accelerator::closest_hits(std::span<const Ray> rays, std::span<Hit> answers) const noexcept {
  assert(rays.size() == answers.size());
  const KeepDenormals keep;
  closest_batch(rays.first(std::min(rays.size(), answers.size())), answers.data());
}

void Accelerator::any_hits(std::span<const Ray> rays, std::span<std::uint8_t> answers) const noexcept {
  assert(rays.size() == answers.size());
  const KeepDenormals keep;
  any_batch(rays.first(std::min(rays.size(), answers.size())), answers.data());
}

void Accelerator::closest_batch(std::span<const Ray> rays, Hit* answers) const noexcept {
  for (const Ray& ray : rays) *answers++ = closest({ray});
}

void Accelerator::any_batch(std::span<const Ray> rays, std::uint8_t* answers) const noexcept {
  for (const Ray& ray : rays) *answers++ = any({ray});
}

}  // namespace twinray
