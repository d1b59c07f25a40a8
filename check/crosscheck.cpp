// SPDX-License-Identifier: Apache-2.0
#include "check/crosscheck.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace twinray {
namespace {

/// Rays around a doubtful one that decide whether it hits a closed surface: parallel to it, on a circle
/// whose radius is this many ulps of the distances that count.
constexpr float surrounding_ulps = 4 * float(rounding_ulps);
constexpr int surrounding_rays = 8;

/// Unexplained differences first, then leaks, then by number.
bool comes_before(const Finding& a, const Finding& b) {
  const auto rank = [](const Finding& f) {
    return f.difference == Difference::unexplained ? 0 : f.is_leak ? 1 : 2;
  };
  return rank(a) != rank(b) ? rank(a) < rank(b) : a.number < b.number;
}

/// A vector of length 1 perpendicular to another one, which is not zero, of any length.
Vec3 perpendicular(const Vec3& v) {
  const Vec3 unit = normalize(v / max_abs(v));
  return normalize(cross(unit, std::fabs(unit.x) < 0.5f ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
}

}  // namespace

Tally& Tally::operator+=(const Tally& other) {
  rays += other.rays;
  for (std::size_t i = 0; i < difference_count; ++i) counts[i] += other.counts[i];
  hit_or_miss += other.hit_or_miss;
  leaks += other.leaks;
  return *this;
}

CrosscheckReport::CrosscheckReport(std::size_t engines, std::size_t kept)
    : kept_(kept), cells_(engines * ray_class_count) {}

std::uint64_t CrosscheckReport::unexplained() const {
  std::uint64_t sum = 0;
  for (const Cell& c : cells_) sum += c.tally.count(Difference::unexplained);
  return sum;
}

void CrosscheckReport::add_explained(std::size_t engine, RayClass ray_class, Difference difference) {
  Tally& tally = cell(engine, ray_class).tally;
  ++tally.rays;
  ++tally.counts[std::size_t(difference)];
}

void CrosscheckReport::add(const Finding& finding, bool is_hit_or_miss) {
  add_explained(finding.engine, finding.ray_class, finding.difference);
  Cell& c = cell(finding.engine, finding.ray_class);
  c.tally.hit_or_miss += is_hit_or_miss;
  c.tally.leaks += finding.is_leak;
  keep(c, finding);
}

void CrosscheckReport::judge(const Geometry& geometry, Placement placement) {
  for (Cell& cell : cells_)
    for (Finding& finding : cell.findings) {
      const Ray& ray = finding.ray;
      if (finding.difference != Difference::unexplained || placement_of(finding.ray_class) != placement ||
          !is_finite(ray.origin) || !is_finite(ray.direction) || max_abs(ray.direction) == 0)
        continue;
      const std::vector<JudgedHit> hits = judge_all(geometry, ray);
      finding.is_judged = true;
      if (!hits.empty()) finding.exact = hits.front();
    }
}

void CrosscheckReport::keep(Cell& cell, const Finding& finding) const {
  const auto at = std::upper_bound(cell.findings.begin(), cell.findings.end(), finding, comes_before);
  if (at - cell.findings.begin() >= std::ptrdiff_t(kept_)) return;
  cell.findings.insert(at, finding);
  if (cell.findings.size() > kept_) cell.findings.pop_back();
}

CrosscheckReport& CrosscheckReport::operator+=(const CrosscheckReport& other) {
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    cells_[i].tally += other.cells_[i].tally;
    for (const Finding& finding : other.cells_[i].findings) keep(cells_[i], finding);
  }
  return *this;
}

Crosscheck::Crosscheck(std::shared_ptr<const Geometry> geometry, std::vector<CheckedEngine> engines)
    : geometry_(std::move(geometry)), engines_(std::move(engines)) {
  if (engines_.size() < 2) throw Error("a crosscheck needs two engines or more");
  if (!engines_[0].is_canonical || engines_[0].every != 1)
    throw Error("the first engine of a crosscheck must be canonical, and asked for every ray");
  const bool is_judged =
      std::any_of(engines_.begin(), engines_.end(), [](const CheckedEngine& e) { return !e.is_canonical; });
  if (is_judged) oracle_ = std::make_unique<const Oracle>(geometry_);
}

void Crosscheck::check(const Ray& ray, RayClass ray_class, std::uint64_t number,
                       CrosscheckReport& report) const {
  const Answer reference = ask(*engines_[0].accelerator, ray);
  for (std::uint32_t engine = 0; engine < engines_.size(); ++engine) {
    if (number % engines_[engine].every != 0) continue;
    const Answer found = engine == 0 ? reference : ask(*engines_[engine].accelerator, ray);
    const Difference difference = compare(engine, ray, reference, found);
    if (difference == Difference::identical || difference == Difference::rounding) {
      report.add_explained(engine, ray_class, difference);
      continue;
    }
    const bool is_hit_or_miss = bool(reference.closest) != bool(found.closest);
    const Hit& hit = reference.closest ? reference.closest : found.closest;
    const bool is_leak = is_hit_or_miss && difference != Difference::interval_end &&
                         geometry_->is_opaque(hit.mesh) && is_surrounded(ray, hit);
    report.add({ray_class, number, engine, ray, difference, is_leak, reference, found}, is_hit_or_miss);
  }
}

Difference Crosscheck::compare(std::size_t engine, const Ray& ray, const Answer& reference,
                               const Answer& found) const {
  if (!reference.is_consistent()) return Difference::unexplained;
  if (same_bits(reference, found)) return Difference::identical;
  return engines_[engine].is_canonical ? Difference::unexplained : oracle_->classify(ray, reference, found);
}

bool Crosscheck::is_surrounded(const Ray& ray, const Hit& hit) const {
  const Vec3 to_hit = ray.direction * hit.t;
  const float scale = max_abs(to_hit) + max_abs(engines_[0].accelerator->bounds().extent()) * 0x1p-10f;
  const float radius = surrounding_ulps * 0x1p-24f * scale;
  const Vec3 across = perpendicular(ray.direction);
  const Vec3 other = normalize(cross(across, ray.direction / max_abs(ray.direction)));
  for (int i = 0; i < surrounding_rays; ++i) {
    constexpr float diagonal = 0.70710678f;
    constexpr float x[] = {1, diagonal, 0, -diagonal, -1, -diagonal, 0, diagonal};
    const Vec3 shift = across * (x[i] * radius) + other * (x[(i + 6) % 8] * radius);
    Ray near = ray;
    near.origin = ray.origin + shift;
    if (!engines_[0].accelerator->any_hit(near)) return false;
  }
  return true;
}

}  // namespace twinray
