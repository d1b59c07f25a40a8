// SPDX-License-Identifier: Apache-2.0
// Random numbers as a pure function of (seed, pixel, sample index, path vertex, purpose).
//
// A draw depends on nothing else: not on the draws before it, the tile, the thread or the number of samples.
// So images can be split, resumed and merged, and a new purpose leaves all others' numbers as they are.
#pragma once
#include <array>
#include <cassert>
#include <cstdint>
#include <string>

#include "core/vec.h"

namespace twinray {

/// What a draw is for. The values are part of the image format of a seed: never renumber, only append.
/// Grouped in sets of four dimensions (value / 4): the members of a set are stratified against each other.
enum class Purpose : std::uint32_t {
  // Set 0, two pairs.
  light_point = 0,  ///< 2D: where on a light.
  direction = 2,    ///< 2D: which way a path goes on.
  // Set 1, single draws.
  light_pick = 4,  ///< 1D: which light.
  lobe = 5,        ///< 1D: which lobe of a material.
  roulette = 6,    ///< 1D: whether a path goes on.
  alpha = 7,       ///< 1D: cut-outs.
  // Set 2: camera.
  pixel = 8,  ///< 2D: where in the pixel.
  lens = 10,  ///< 2D: where on the lens.
  // Set 3.
  time = 12,    ///< 1D: when.
  medium = 13,  ///< 1D: how far in a volume.
};

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

/// The draws of one vertex of one sample's path: vertex 0 is the camera, 1 the first surface, ...
///
/// `independent` hashes. `sobol` takes shuffled, Owen-scrambled points (Burley, "Practical Hash-based Owen
/// Scrambling", JCGT 9(4), 2020), so that the samples of a pixel are stratified against each other: in each
/// aligned block of 2^k indices, every pair of dimensions 0 and 1 or 2 and 3 of a set has one sample in each
/// elementary interval (as Sobol's first two dimensions have); of 4^k, the four together have one in each
/// with sides of powers of 1/4. Different sets are independent. A set of four dimensions is computed when its
/// first member is drawn and kept, so repeated draws of a vertex are cheap; the same purpose always gives the
/// same number.
class VertexSampler {
 public:
  VertexSampler(SamplerKind kind, const SampleKey& key, std::uint32_t vertex)
      : VertexSampler(kind, PathKey(key), vertex) {}
  VertexSampler(SamplerKind kind, const PathKey& key, std::uint32_t vertex);

  /// In [0, 1).
  float draw_1d(Purpose purpose) { return set(purpose)[member(purpose)]; }
  /// In [0, 1)^2; the purpose is an even member of its set.
  Vec2 draw_2d(Purpose purpose) { return pair(set(purpose), purpose); }

  /// The draw for sub-sample `part` of `parts` (1 to 2^16): sample index x parts + part of a sequence of its
  /// own for each `stream` (such as the index of a light). With parts = 1 and stream = 0 it is draw_2d.
  Vec2 draw_2d(Purpose purpose, std::uint32_t part, std::uint32_t parts, std::uint32_t stream) {
    assert(part < parts && parts <= 1u << 16);
    return parts == 1 && stream == 0 ? draw_2d(purpose) : draw_part(purpose, part, parts, stream);
  }

 private:
  using Set = std::array<float, 4>;

  static std::uint32_t set_number(Purpose purpose) { return std::uint32_t(purpose) / 4; }
  static std::size_t member(Purpose purpose) { return std::size_t(purpose) % 4; }
  static Vec2 pair(const Set& values, Purpose purpose) {
    assert(member(purpose) % 2 == 0);
    return {values[member(purpose)], values[member(purpose) + 1]};
  }
  const Set& set(Purpose purpose) {
    const std::uint32_t number = set_number(purpose);
    if ((known_sets_ >> number & 1) == 0) compute_set(number);
    return sets_[number];
  }
  void compute_set(std::uint32_t number);
  Vec2 draw_part(Purpose purpose, std::uint32_t part, std::uint32_t parts, std::uint32_t stream) const;

  SamplerKind kind_;
  std::uint32_t index_;
  std::uint64_t key_;             ///< Hash of seed, pixel and vertex.
  std::uint32_t known_sets_ = 0;  ///< Bit n: sets_[n] has been computed.
  std::array<Set, 4> sets_;
};

/// "sobol", "independent"; parse throws Error that lists them.
std::string sampler_name(SamplerKind kind);
SamplerKind parse_sampler(const std::string& name);

}  // namespace twinray
