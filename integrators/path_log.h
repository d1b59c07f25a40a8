// SPDX-License-Identifier: Apache-2.0
// A path written down, vertex by vertex.
#pragma once
#include <optional>
#include <vector>

#include "integrators/direct_light.h"
#include "integrators/path_observer.h"
#include "integrators/scattering.h"

namespace twinray {

/// How a path was scattered at a vertex.
struct LoggedScattering {
  BsdfSample sample;               ///< In the frame of the vertex's Interaction.
  std::optional<Scattering> next;  ///< None where the path ends.
};

struct LoggedLightSample {
  TakenLightSample taken;
  float weight = 1;    ///< By multiple importance sampling.
  float bsdf_pdf = 0;  ///< With which scattering would have chosen its direction, per solid angle.
};

/// What happened between a ray of the path and the next one. What did not happen is not set.
struct PathVertex {
  PathArrival arrival;
  std::optional<PathTerm> glow;  ///< What media on the way have emitted.
  std::vector<FoundLight> found;
  std::optional<PathTerm> emission;  ///< The term of what was found.
  std::optional<Interaction> surface;
  Materials materials = Materials::exact;
  std::vector<LoggedLightSample> light_samples;
  std::vector<TakenDirection> directions;
  std::optional<PathTerm> direct_light;
  std::optional<LoggedScattering> scattering;
  std::optional<RouletteGame> roulette;
};

/// Why a path has no further vertex.
enum class PathEnd {
  left,      ///< Its ray has left the scene.
  depth,     ///< It was scattered as often as it may be; the last ray only looked for light.
  absorbed,  ///< The surface scatters nothing where it would have gone on.
  roulette,
  below,  ///< It has gone below a surface, and does not come out.
  unlit,  ///< It may be scattered no more, and the ray that would have gone on finds no light by itself.
};

/// Writes down what it is told of one path.
class PathLog final : public PathObserver {
 public:
  void arrived(const PathArrival& arrival) override { vertices_.push_back({.arrival = arrival}); }
  void stands_at(const Interaction& at, Materials materials) override;
  void passed_glow(const PathTerm& term) override { last().glow = term; }
  /// Light that is black is no light.
  void found_light(const FoundLight& found) override;
  void sampled_light(const LightTransport& transport, const Interaction& at,
                     const TakenLightSample& taken) override;
  void looked_around(const TakenDirection& taken) override { last().directions.push_back(taken); }
  void added(const PathTerm& term) override;
  void scattered(float lobe, Vec2 u, const Scattering* next) override;
  void played_roulette(const RouletteGame& game) override { last().roulette = game; }

  const std::vector<PathVertex>& vertices() const { return vertices_; }
  /// Of a whole path.
  PathEnd end() const;
  /// All terms, added up in the order of the path: the sample's radiance, bit for bit.
  Rgb sum() const;

 private:
  PathVertex& last() { return vertices_.back(); }

  std::vector<PathVertex> vertices_;
};

}  // namespace twinray
