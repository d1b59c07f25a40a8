// SPDX-License-Identifier: Apache-2.0
#include "accel/accelerator.h"

#include <algorithm>
#include <cassert>
#include <utility>
#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include "core/parallel.h"

namespace twinray {
namespace {

/// Whether the calling thread has denormal numbers switched off: FTZ (0x8000) or DAZ (0x0040) of MXCSR.
bool flushes_denormals() {
#if defined(__x86_64__)
  return (_mm_getcsr() & 0x8040u) != 0;
#else
  return false;
#endif
}

/// Calls `answer` with denormal numbers. To look is cheap, to switch is not: so they are switched on only
/// where they are off.
template <typename Answer>
auto with_denormals(const Answer& answer) noexcept {
  if (!flushes_denormals()) [[likely]]
    return answer();
  const KeepDenormals keep;
  return answer();
}

}  // namespace

Accelerator::Accelerator(std::shared_ptr<const Geometry> geometry, AccelStats stats)
    : geometry_(std::move(geometry)), stats_(std::move(stats)) {
  stats_.primitives = geometry_->primitive_count();
}

Hit Accelerator::closest_hit(const Query& query) const noexcept {
  return with_denormals([&] { return closest(query); });
}

bool Accelerator::any_hit(const Query& query) const noexcept {
  return with_denormals([&] { return any(query); });
}

void Accelerator::closest_hits(std::span<const Ray> rays, std::span<Hit> answers) const noexcept {
  assert(rays.size() == answers.size());
  const std::size_t count = std::min(rays.size(), answers.size());
  with_denormals([&] { closest_batch(rays.first(count), answers.data()); });
}

void Accelerator::any_hits(std::span<const Ray> rays, std::span<std::uint8_t> answers) const noexcept {
  assert(rays.size() == answers.size());
  const std::size_t count = std::min(rays.size(), answers.size());
  with_denormals([&] { any_batch(rays.first(count), answers.data()); });
}

void Accelerator::closest_batch(std::span<const Ray> rays, Hit* answers) const noexcept {
  for (const Ray& ray : rays) *answers++ = closest({ray});
}

void Accelerator::any_batch(std::span<const Ray> rays, std::uint8_t* answers) const noexcept {
  for (const Ray& ray : rays) *answers++ = any({ray});
}

}  // namespace twinray
