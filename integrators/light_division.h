// SPDX-License-Identifier: Apache-2.0
// The parts of one sample's light, while its path is traced.
#pragma once
#include <vector>

#include "core/record.h"
#include "integrators/light_groups.h"
#include "integrators/light_paths.h"
#include "integrators/path_observer.h"

namespace twinray {

/// A term of a path's radiance.
struct LightTerm {
  Rgb throughput;    ///< Of the path, up to a vertex.
  Rgb light;         ///< What goes back from there.
  float factor = 1;  ///< What clamping leaves of it.

  Rgb radiance() const { return throughput * light * factor; }
  /// As the path's observer is told.
  PathTerm seen() const { return {throughput * light, radiance()}; }
};

/// Keeps what the record is asked for.
class LightDivision {
 public:
  /// `record` has room for one sample. All must outlive this.
  LightDivision(const Scene& scene, const RecordSpans& record)
      : record_(record),
        group_sums_(record.has(Division::groups) ? scene.light_groups.size() : 0),
        groups_(scene, group_sums_) {}

  /// What lights bring to the current vertex.
  const LightGroups& groups() const { return groups_; }
  /// What is asked for of direct light at a vertex of this depth.
  LightShares shares(const Interaction& at, int depth) {
    const bool is_divided = has_paths() && depth == 0 && !at.is_lambert();
    scattered_ = {};
    return {is_divided ? &scattered_ : nullptr, groups_};
  }
  /// Adds what a ray has brought after `depth` scattering events, of which this was the first.
  void add_found(bool is_miss, const FirstScattering& first, const LightTerm& term, int depth) {
    add_groups(term);
    if (!has_paths()) return;
    if (depth == 0)
      add_seen_light(is_miss, term.radiance(), paths());
    else
      add_scattered_light(first, term.radiance(), depth, paths());
  }
  /// Adds direct light of the shares.
  void add_direct(const Interaction& at, const FirstScattering& first, const LightTerm& term, int depth) {
    add_groups(term);
    if (!has_paths()) return;
    if (depth > 0 || at.is_lambert())
      add_scattered_light(first, term.radiance(), depth + 1, paths());
    else
      add_direct_light(term.throughput, scattered_, term.radiance(), paths());
  }

 private:
  bool has_paths() const { return record_.has(Division::paths); }
  PathParts paths() const { return PathParts(record_[Division::paths][0]); }
  void add_groups(const LightTerm& term) {
    if (groups_.are_kept()) groups_.move_to(record_[Division::groups][0], term.throughput, term.factor);
  }

  const RecordSpans& record_;
  std::vector<Rgb> group_sums_;
  const LightGroups groups_;
  ScatteredLight scattered_;
};

}  // namespace twinray
