// SPDX-License-Identifier: Apache-2.0
// The same rays traced by several engines, and a report of how their answers differ.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "check/oracle.h"
#include "check/ray_class.h"

namespace twinray {

/// An engine that takes part.
struct CheckedEngine {
  std::string name;
  const Accelerator* accelerator = nullptr;  ///< Must outlive the crosscheck.
  bool is_canonical = true;  ///< Promises equal bits; otherwise differences are judged by the oracle.
  std::uint64_t every = 1;   ///< It traces the rays whose number is a multiple of this.
};

/// The rays of one class through one engine, compared with the reference.
struct Tally {
  std::uint64_t rays = 0;
  std::array<std::uint64_t, difference_count> counts{};  ///< By Difference.
  std::uint64_t hit_or_miss = 0;                         ///< One hits and the other misses.
  /// Of those, where all rays close around hit something: a hole in a closed surface, not an outline.
  std::uint64_t leaks = 0;

  std::uint64_t count(Difference difference) const { return counts[std::size_t(difference)]; }
  /// Neither identical nor rounding.
  std::uint64_t odd() const { return rays - count(Difference::identical) - count(Difference::rounding); }
  Tally& operator+=(const Tally& other);
  friend bool operator==(const Tally&, const Tally&) = default;
};

/// A ray whose answers are neither identical nor rounding.
struct Finding {
  RayClass ray_class = RayClass::camera;
  std::uint64_t number = 0;  ///< Of the ray within its class.
  std::uint32_t engine = 0;  ///< Index of the engine that was compared with engine 0.
  Ray ray;
  Difference difference = Difference::unexplained;
  bool is_leak = false;
  Answer reference, found;
  bool is_judged = false;
  std::optional<JudgedHit> exact;  ///< Where it is judged: the first primitive that the exact ray hits.
};

/// The result of a crosscheck. Reports of parts add up to the same report in any order.
class CrosscheckReport {
 public:
  /// Of each engine and ray class at most `kept` findings are kept: the unexplained ones first, then leaks,
  /// then others; the least numbers of each kind.
  explicit CrosscheckReport(std::size_t engines, std::size_t kept = 10);

  const Tally& tally(std::size_t engine, RayClass ray_class) const {
    return cells_[engine * ray_class_count + std::size_t(ray_class)].tally;
  }
  const std::vector<Finding>& findings(std::size_t engine, RayClass ray_class) const {
    return cells_[engine * ray_class_count + std::size_t(ray_class)].findings;
  }
  std::size_t engine_count() const { return cells_.size() / ray_class_count; }
  std::uint64_t unexplained() const;

  void add(const Finding& finding, bool is_hit_or_miss);
  /// Judges the unexplained findings of one placement: `geometry` is the placed one. Every primitive is
  /// tested for each.
  void judge(const Geometry& geometry, Placement placement);
  void add_explained(std::size_t engine, RayClass ray_class, Difference difference);
  CrosscheckReport& operator+=(const CrosscheckReport& other);

 private:
  struct Cell {
    Tally tally;
    std::vector<Finding> findings;  ///< In the order above.
  };
  Cell& cell(std::size_t engine, RayClass ray_class) {
    return cells_[engine * ray_class_count + std::size_t(ray_class)];
  }
  void keep(Cell& cell, const Finding& finding) const;

  std::size_t kept_;
  std::vector<Cell> cells_;
};

/// Compares engines over one geometry. Safe from any thread.
class Crosscheck {
 public:
  /// The first engine is the reference and must be canonical; throws Error otherwise, or for fewer than two.
  Crosscheck(std::shared_ptr<const Geometry> geometry, std::vector<CheckedEngine> engines);

  /// Traces one ray, number `number` of its class, and adds its result.
  void check(const Ray& ray, RayClass ray_class, std::uint64_t number, CrosscheckReport& report) const;
  /// How an engine's answer differs from the reference's. For a canonical engine, and for one whose two
  /// queries contradict each other, any difference is unexplained.
  Difference compare(std::size_t engine, const Ray& ray, const Answer& reference, const Answer& found) const;

  const std::vector<CheckedEngine>& engines() const { return engines_; }

 private:
  bool is_surrounded(const Ray& ray, const Hit& hit) const;

  std::shared_ptr<const Geometry> geometry_;
  std::vector<CheckedEngine> engines_;
  std::unique_ptr<const Oracle> oracle_;  ///< Where an engine is not canonical.
};

}  // namespace twinray
