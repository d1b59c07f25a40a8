// SPDX-License-Identifier: Apache-2.0
// Random numbers as a pure function of (seed, pixel, sample index, path vertex, purpose).
//
// A draw depends on nothing else: not on the draws before it, the tile, the thread or the number of samples.
// So images can be split, resumed and merged, and a new purpose leaves all others' numbers as they are.
#pragma once
#include <cstdint>
#include <string>

#include "core/vec.h"

namespace twinray {

/// What a draw is for; place_of() says where it is found.
enum class Purpose : std::uint32_t {
  pixel,        ///< 2D: where in the pixel; at the camera.
  lens,         ///< 2D: where on the lens; at the camera.
  light_point,  ///< 2D: where on a light.
  direction,    ///< 2D: which way a path goes on.
  light_pick,   ///< 1D: which light.
  lobe,         ///< 1D: which lobe of a material.
  roulette,     ///< 1D: whether a path goes on.
  alpha,        ///< 1D: cut-outs.
  time,         ///< 1D: when; at the camera.
  medium,       ///< 1D: how far in a volume.
  glow,         ///< 1D: where a volume is seen to emit.
  texture,      ///< 2D: which pixels of textures stand for those around.
};

/// Where a draw is found: draws come in sets of four dimensions, whose members are stratified against each
/// other. Part of the image format of a seed.
struct DrawPlace {
  std::uint32_t vertex = 0;  ///< The set belongs to this vertex of the path,
  std::uint32_t set = 0;     ///< is this one of it, 0 to 4,
  std::uint32_t member = 0;  ///< and has the draw as its dimension 0 to 3; an even one where it is a pair.
};

/// Pairs of draws that the same paths depend on most share a set: where a path goes at two vertices that
/// follow each other, and where a vertex and the next look for light (the camera's own point is the pixel's).
constexpr DrawPlace place_of(Purpose purpose, std::uint32_t vertex) {
  switch (purpose) {
    case Purpose::pixel:
      return {0, 0, 0};
    case Purpose::light_point:
      return {vertex / 2, 0, 2 * (vertex % 2)};
    case Purpose::direction:
      return {(vertex - 1) / 2, 1, 2 * ((vertex - 1) % 2)};
    case Purpose::light_pick:
      return {vertex, 2, 0};
    case Purpose::lobe:
      return {vertex, 2, 1};
    case Purpose::roulette:
      return {vertex, 2, 2};
    case Purpose::alpha:
      return {vertex, 2, 3};
    case Purpose::lens:
      return {0, 3, 0};
    case Purpose::time:
      return {0, 3, 2};
    case Purpose::medium:
      return {vertex, 4, 0};
    case Purpose::glow:
      return {vertex, 4, 1};
    case Purpose::texture:
      return {vertex, 4, 2};
  }
  return {};
}

enum class SamplerKind { sobol, independent };

/// One sample of one pixel; x and y count in the full frame, whatever part of it is rendered.
struct SampleKey {
  std::uint64_t seed = 0;
  std::uint32_t x = 0, y = 0;
  std::uint32_t index = 0;
};

/// What the draws at all vertices of a sample's path have in common: hashed once.
struct PathKey {
  PathKey() = default;
  explicit PathKey(const SampleKey& key);

  std::uint64_t pixel = 0;  ///< Hash of seed and pixel.
  std::uint32_t index = 0;
};

/// Which samples of a place: sub-sample `part` of `parts` (1 to 2^16) is sample index x parts + part of a
/// sequence of its own for each `stream` (such as the index of a light).
struct SubSample {
  std::uint32_t part = 0, parts = 1, stream = 0;
};

/// Two dimensions of a set, `member` and the next, in [0, 1)^2; the member is even.
///
/// `independent` hashes. `sobol` takes shuffled, Owen-scrambled points (Burley, "Practical Hash-based Owen
/// Scrambling", JCGT 9(4), 2020), so that the samples of a pixel are stratified against each other: in each
/// aligned block of 2^k indices, every pair of dimensions 0 and 1 or 2 and 3 of a set has one sample in each
/// elementary interval (as Sobol's first two dimensions have); of 4^k, the four together have one in each
/// with sides of powers of 1/4. Different sets are independent.
Vec2 draw_pair(SamplerKind kind, const PathKey& path, const DrawPlace& place, const SubSample& sub = {});

/// The draws of one vertex of one sample's path: vertex 0 is the camera, 1 the first surface, ...
class VertexSampler {
 public:
  VertexSampler(SamplerKind kind, const PathKey& path, std::uint32_t vertex)
      : kind_(kind), path_(path), vertex_(vertex) {}

  /// In [0, 1).
  float draw_1d(Purpose purpose) const {
    DrawPlace place = place_of(purpose, vertex_);
    const bool second = place.member % 2 == 1;
    place.member -= second;
    const Vec2 pair = draw_pair(kind_, path_, place);
    return second ? pair.y : pair.x;
  }
  /// In [0, 1)^2.
  Vec2 draw_2d(Purpose purpose, const SubSample& sub = {}) const {
    return draw_pair(kind_, path_, place_of(purpose, vertex_), sub);
  }

 private:
  SamplerKind kind_;
  PathKey path_;
  std::uint32_t vertex_;
};

/// "sobol", "independent"; parse throws Error that lists them.
std::string sampler_name(SamplerKind kind);
SamplerKind parse_sampler(const std::string& name);

}  // namespace twinray
