// SPDX-License-Identifier: Apache-2.0
#include "accel/embree/direct.h"

#include <algorithm>
#include <limits>
#include <type_traits>
#include <vector>

#include "accel/embree/native.h"
#include "accel/embree/ray.h"
#include "core/error.h"

namespace twinray::embree {
namespace {

constexpr std::size_t packet_size = 16;

Coherence coherence_of(DirectCall how) { return how.rays == Rays::coherent ? coherent : incoherent; }

// Hits are read with Embree's own numbers of shape and instance; named() makes ours of them.

/// Up to 16 rays as a packet; the lanes behind them hold none.
void fill(RTCRay16& packet, std::span<const Ray> rays) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const Ray none{.origin = {}, .direction = {0, 0, 1}, .t_max = -infinity};
  for (std::size_t lane = 0; lane < packet_size; ++lane) {
    const Ray ray = lane < rays.size() ? rays[lane] : none;
    packet.org_x[lane] = ray.origin.x;
    packet.org_y[lane] = ray.origin.y;
    packet.org_z[lane] = ray.origin.z;
    packet.tnear[lane] = ray.t_min + 0.0f;
    packet.dir_x[lane] = ray.direction.x;
    packet.dir_y[lane] = ray.direction.y;
    packet.dir_z[lane] = ray.direction.z;
    packet.time[lane] = 0;
    packet.tfar[lane] = ray.t_max + 0.0f;
    packet.mask[lane] = 0xffffffff;
    packet.id[lane] = 0;
    packet.flags[lane] = 0;
  }
}

void fill(RTCRayHit16& packet, std::span<const Ray> rays) {
  fill(packet.ray, rays);
  std::fill_n(packet.hit.geomID, packet_size, RTC_INVALID_GEOMETRY_ID);
}

void fill(RTCRay& to, const Ray& ray) { set_ray(to, ray.origin, ray.direction, ray.t_min, ray.t_max); }
void fill(RTCRayHit& to, const Ray& ray) {
  fill(to.ray, ray);
  set_no_hit(to.hit);
}

/// -1 for the lanes of a packet with `count` rays.
struct Active {
  alignas(64) int lanes[packet_size];

  explicit Active(std::size_t count) {
    for (std::size_t lane = 0; lane < packet_size; ++lane) lanes[lane] = lane < count ? -1 : 0;
  }
};

bool is_hit(const RTCRayHit& found) { return found.hit.geomID != RTC_INVALID_GEOMETRY_ID; }
bool is_hit(const RTCRay& ray) { return ray.tfar < 0; }
bool is_hit(const RTCRayHit16& found, std::size_t lane) {
  return found.hit.geomID[lane] != RTC_INVALID_GEOMETRY_ID;
}
bool is_hit(const RTCRay16& rays, std::size_t lane) { return rays.tfar[lane] < 0; }

void read(const RTCRayHit& found, Hit& hit) {
  hit = {};
  if (is_hit(found))
    hit = {found.ray.tfar, found.hit.u, found.hit.v, found.hit.primID, found.hit.geomID, found.hit.instID[0]};
}
void read(const RTCRayHit16& found, std::size_t lane, Hit& hit) {
  hit = {};
  if (is_hit(found, lane))
    hit = {found.ray.tfar[lane],   found.hit.u[lane],      found.hit.v[lane],
           found.hit.primID[lane], found.hit.geomID[lane], found.hit.instID[0][lane]};
}
void read(const RTCRay& ray, std::uint8_t& hit) { hit = is_hit(ray); }
void read(const RTCRay16& rays, std::size_t lane, std::uint8_t& hit) { hit = is_hit(rays, lane); }

// What follows is the same for closest hits and for any hit, which differ in their types: an answer is a Hit
// or a byte, a query is one with room for a hit or one without.

template <typename Answer>
struct Queries;
template <>
struct Queries<Hit> {
  using One = RTCRayHit;
  using Packet = RTCRayHit16;
  static bool through_interface(const Accelerator& native, const Ray& ray, Hit& answer) {
    return bool(answer = native.closest_hit(ray));
  }
};
template <>
struct Queries<std::uint8_t> {
  using One = RTCRay;
  using Packet = RTCRay16;
  static bool through_interface(const Accelerator& native, const Ray& ray, std::uint8_t& answer) {
    return (answer = native.any_hit(ray)) != 0;
  }
};

template <typename Answer>
std::size_t ask_singly(RTCScene scene, std::span<const Ray> rays, std::span<Answer> answers) {
  std::size_t hits = 0;
  Context context;
  initialize(context);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    typename Queries<Answer>::One query;
    fill(query, rays[i]);
    trace(scene, context, query);
    hits += is_hit(query);
    if (!answers.empty()) read(query, answers[i]);
  }
  return hits;
}

/// Counts and reads the hits of a packet with the rays from `first` on.
template <typename Answer>
std::size_t finish(const typename Queries<Answer>::Packet& packet, std::size_t first, std::size_t count,
                   std::span<Answer> answers) {
  std::size_t hits = 0;
  for (std::size_t lane = 0; lane < count; ++lane) hits += is_hit(packet, lane);
  if (!answers.empty())
    for (std::size_t lane = 0; lane < count; ++lane) read(packet, lane, answers[first + lane]);
  return hits;
}

template <typename Answer>
std::size_t ask_in_packets(RTCScene scene, std::span<const Ray> rays, Coherence coherence,
                           std::span<Answer> answers) {
  std::size_t hits = 0;
  for (std::size_t first = 0; first < rays.size(); first += packet_size) {
    const std::size_t count = std::min(packet_size, rays.size() - first);
    typename Queries<Answer>::Packet packet;
    fill(packet, rays.subspan(first, count));
    trace(scene, coherence, Active(count).lanes, packet);
    hits += finish(packet, first, count, answers);
  }
  return hits;
}

template <typename Answer>
std::size_t ask_in_streams(RTCScene scene, std::span<const Ray> rays, Coherence coherence,
                           std::span<Answer> answers) {
  std::size_t hits = 0;
  std::vector<typename Queries<Answer>::One> queries(std::min(rays_a_stream, rays.size()));
  for (std::size_t first = 0; first < rays.size(); first += rays_a_stream) {
    const std::size_t count = std::min(rays_a_stream, rays.size() - first);
    for (std::size_t i = 0; i < count; ++i) fill(queries[i], rays[first + i]);
    trace(scene, coherence, std::span(queries).first(count));
    for (std::size_t i = 0; i < count; ++i) hits += is_hit(queries[i]);
    if (!answers.empty())
      for (std::size_t i = 0; i < count; ++i) read(queries[i], answers[first + i]);
  }
  return hits;
}

template <typename Answer>
std::size_t ask_in_packet_streams(RTCScene scene, std::span<const Ray> rays, Coherence coherence,
                                  std::span<Answer> answers) {
  std::size_t hits = 0;
  std::vector<typename Queries<Answer>::Packet> packets(rays_a_stream / packet_size);
  for (std::size_t first = 0; first < rays.size(); first += rays_a_stream) {
    const std::span<const Ray> some = rays.subspan(first, std::min(rays_a_stream, rays.size() - first));
    const std::size_t used = (some.size() + packet_size - 1) / packet_size;
    const auto rays_of = [&](std::size_t i) {
      return some.subspan(i * packet_size, std::min(packet_size, some.size() - i * packet_size));
    };
    for (std::size_t i = 0; i < used; ++i) fill(packets[i], rays_of(i));
    trace(scene, coherence, std::span(packets).first(used));
    for (std::size_t i = 0; i < used; ++i)
      hits += finish(packets[i], first + i * packet_size, rays_of(i).size(), answers);
  }
  return hits;
}

template <typename Answer>
std::size_t ask_directly(const Accelerator& native, std::span<const Ray> rays, DirectCall how,
                         std::span<Answer> answers) {
  const auto [scene, has_callbacks] = native_scene(native);
  if (!has(how.call)) throw Error("this version of Embree has no streams of rays");
  if (has_callbacks) {
    if (how.call != Call::single) throw Error("spheres and cut-outs of embree-native take one ray at a time");
    std::size_t hits = 0;
    Answer unused;
    for (std::size_t i = 0; i < rays.size(); ++i)
      hits += Queries<Answer>::through_interface(native, rays[i], answers.empty() ? unused : answers[i]);
    return hits;
  }
  switch (how.call) {
    case Call::packets:
      return ask_in_packets(scene, rays, coherence_of(how), answers);
    case Call::stream:
      if constexpr (has_streams) return ask_in_streams(scene, rays, coherence_of(how), answers);
      break;
    case Call::packet_stream:
      if constexpr (has_streams) return ask_in_packet_streams(scene, rays, coherence_of(how), answers);
      break;
    case Call::single:
      break;
  }
  return ask_singly(scene, rays, answers);
}

template <typename Answer>
std::size_t ask(const Accelerator& native, std::span<const Ray> rays, DirectCall how,
                std::span<Answer> answers) {
  const std::size_t hits = ask_directly(native, rays, how, answers);
  if constexpr (std::is_same_v<Answer, Hit>)
    if (!native_scene(native).has_callbacks)
      for (Hit& hit : answers) hit = named(hit, native.geometry());
  return hits;
}

}  // namespace

bool has(Call call) { return has_streams || call == Call::single || call == Call::packets; }

std::size_t closest_hits_directly(const Accelerator& native, std::span<const Ray> rays, DirectCall how,
                                  std::span<Hit> answers) {
  return ask(native, rays, how, answers);
}

std::size_t any_hits_directly(const Accelerator& native, std::span<const Ray> rays, DirectCall how,
                              std::span<std::uint8_t> answers) {
  return ask(native, rays, how, answers);
}

}  // namespace twinray::embree
