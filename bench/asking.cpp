// SPDX-License-Identifier: Apache-2.0
#include "bench/asking.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cstdint>

#ifdef TWINRAY_WITH_EMBREE
#include "accel/embree/direct.h"
#endif

namespace twinray::bench {
namespace {

constexpr std::size_t rays_a_batch = 1024;

/// Calls f(first, count) for the rays of each batch.
template <typename F>
void for_batches(std::size_t rays, F&& f) {
  for (std::size_t first = 0; first < rays; first += rays_a_batch)
    f(first, std::min(rays_a_batch, rays - first));
}

#ifdef TWINRAY_WITH_EMBREE
embree::Call call_of(Asked asked) {
  switch (asked) {
    case Asked::in_packets:
      return embree::Call::packets;
    case Asked::in_streams:
      return embree::Call::stream;
    case Asked::in_packet_streams:
      return embree::Call::packet_stream;
    default:
      return embree::Call::single;
  }
}

embree::DirectCall call_of(const Engine& engine) {
  return {call_of(engine.asked), engine.is_coherent ? embree::Rays::coherent : embree::Rays::incoherent};
}

std::size_t ask_directly(const Engine& engine, const Accelerator& accelerator, std::span<const Ray> rays,
                         std::span<Hit> answers) {
  return embree::closest_hits_directly(accelerator, rays, call_of(engine), answers);
}
std::size_t ask_directly(const Engine& engine, const Accelerator& accelerator, std::span<const Ray> rays,
                         std::span<std::uint8_t> answers) {
  return embree::any_hits_directly(accelerator, rays, call_of(engine), answers);
}
#else
template <typename Answer>
std::size_t ask_directly(const Engine&, const Accelerator&, std::span<const Ray>, std::span<Answer>) {
  return 0;
}
#endif

// The type of an answer says what is asked: a Hit for the closest one, a byte for any.

void ask_one(const Accelerator& accelerator, const Ray& ray, Hit& answer) {
  answer = accelerator.closest_hit(ray);
}
void ask_one(const Accelerator& accelerator, const Ray& ray, std::uint8_t& answer) {
  answer = accelerator.any_hit(ray);
}
void ask_batch(const Accelerator& accelerator, std::span<const Ray> rays, std::span<Hit> answers) {
  accelerator.closest_hits(rays, answers);
}
void ask_batch(const Accelerator& accelerator, std::span<const Ray> rays, std::span<std::uint8_t> answers) {
  accelerator.any_hits(rays, answers);
}

template <typename Answer>
void ask(const Engine& engine, const Accelerator& accelerator, std::span<const Ray> rays,
         std::span<Answer> answers) {
  switch (engine.asked) {
    case Asked::singly:
      for (std::size_t i = 0; i < rays.size(); ++i) ask_one(accelerator, rays[i], answers[i]);
      return;
    case Asked::in_batches:
      return for_batches(rays.size(), [&](std::size_t first, std::size_t count) {
        ask_batch(accelerator, rays.subspan(first, count), answers.subspan(first, count));
      });
    default:
      ask_directly(engine, accelerator, rays, answers);
  }
}

void shoot_singly(const Accelerator& accelerator, RayKind kind, std::span<const Ray> rays) {
  if (kind == RayKind::shadow)
    for (const Ray& ray : rays) benchmark::DoNotOptimize(accelerator.any_hit(ray));
  else
    for (const Ray& ray : rays) benchmark::DoNotOptimize(accelerator.closest_hit(ray));
}

void shoot_in_batches(const Accelerator& accelerator, RayKind kind, std::span<const Ray> rays) {
  std::array<Hit, rays_a_batch> hits;
  std::array<std::uint8_t, rays_a_batch> blocked;
  for_batches(rays.size(), [&](std::size_t first, std::size_t count) {
    if (kind == RayKind::shadow)
      accelerator.any_hits(rays.subspan(first, count), std::span(blocked).first(count));
    else
      accelerator.closest_hits(rays.subspan(first, count), std::span(hits).first(count));
    benchmark::ClobberMemory();
  });
}

void shoot_directly(const Engine& engine, const Accelerator& accelerator, RayKind kind,
                    std::span<const Ray> rays) {
  benchmark::DoNotOptimize(kind == RayKind::shadow
                               ? ask_directly(engine, accelerator, rays, std::span<std::uint8_t>())
                               : ask_directly(engine, accelerator, rays, std::span<Hit>()));
}

}  // namespace

std::vector<Hit> answers_of(const Engine& engine, const Accelerator& accelerator, RayKind kind,
                            std::span<const Ray> rays) {
  std::vector<Hit> hits(rays.size());
  if (kind != RayKind::shadow) {
    ask(engine, accelerator, rays, std::span(hits));
    return hits;
  }
  std::vector<std::uint8_t> blocked(rays.size());
  ask(engine, accelerator, rays, std::span(blocked));
  for (std::size_t i = 0; i < rays.size(); ++i)
    if (blocked[i]) hits[i].t = 0;
  return hits;
}

void shoot(const Engine& engine, const Accelerator& accelerator, RayKind kind, std::span<const Ray> rays) {
  switch (engine.asked) {
    case Asked::singly:
      return shoot_singly(accelerator, kind, rays);
    case Asked::in_batches:
      return shoot_in_batches(accelerator, kind, rays);
    default:
      return shoot_directly(engine, accelerator, kind, rays);
  }
}

}  // namespace twinray::bench
