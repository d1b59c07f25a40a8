// SPDX-License-Identifier: Apache-2.0
// What each lobe of core/lobes/ promises, checked by sums over all directions: samples have the stated
// density and values, and what is scattered is what the integral says.
#pragma once
#include <cmath>
#include <vector>

#include "core/bsdf_sample.h"
#include "core/microfacet.h"
#include "tests/support/catch.h"
#include "tests/support/chi_square.h"
#include "tests/support/random.h"

namespace twinray::test {

/// A unit direction with this cosine to z, at an azimuth along neither axis.
inline Vec3 direction_at(float cosine) {
  const float sine = std::sqrt(1 - cosine * cosine);
  return {0.8f * sine, -0.6f * sine, cosine};
}

/// The same direction, seen from the other side of the surface.
inline Vec3 flipped(const Vec3& w) { return {w.x, w.y, -w.z}; }

/// A grid of the sphere: rows of equal angles from pole to pole, columns of equal azimuths.
class SphereGrid {
 public:
  static constexpr int rows = 24, columns = 24;
  /// Calls f(direction, solid angle, cell) at the middles of `parts` x `parts` pieces of each cell.
  template <class Function>
  static void visit(int parts, const Function& f) {
    const double height = M_PI / (rows * parts), width = 2 * M_PI / (columns * parts);
    for (int i = 0; i < rows * parts; ++i) {
      const double theta = (i + 0.5) * height, area = 2 * std::sin(theta) * std::sin(0.5 * height) * width;
      for (int j = 0; j < columns * parts; ++j) {
        const double phi = (j + 0.5) * width;
        const Vec3 w{float(std::sin(theta) * std::cos(phi)), float(std::sin(theta) * std::sin(phi)),
                     float(std::cos(theta))};
        f(w, area, std::size_t(i / parts * columns + j / parts));
      }
    }
  }
  static std::size_t cell(const Vec3& w) {
    const double phi = std::atan2(w.y, w.x), turn = (phi < 0 ? phi + 2 * M_PI : phi) / (2 * M_PI);
    const int row = std::min(int(std::acos(std::clamp(double(w.z), -1.0, 1.0)) / M_PI * rows), rows - 1);
    return std::size_t(row * columns + std::min(int(turn * columns), columns - 1));
  }
};

/// The part of the light from all around that a lobe scatters to wo, its delta directions left out: the
/// integral of f(wo, wi) |wi.z|, by `parts`^2 points a cell.
template <class Lobe>
Rgb scattered(const Lobe& lobe, const Vec3& wo, int parts = 16) {
  double r = 0, g = 0, b = 0;
  SphereGrid::visit(parts, [&](const Vec3& wi, double area, std::size_t) {
    const Rgb value = lobe.evaluate(wo, wi).value;
    const double weight = area * std::fabs(wi.z);
    r += value.r * weight, g += value.g * weight, b += value.b * weight;
  });
  return {float(r), float(g), float(b)};
}

/// The same by sampling, with delta directions.
template <class Lobe>
Rgb sampled_albedo(const Lobe& lobe, const Vec3& wo, int samples = 100000) {
  Random random(31);
  double r = 0, g = 0, b = 0;
  for (int i = 0; i < samples; ++i) {
    const float choice = random.unit();
    const float u = random.unit();
    const float v = random.unit();
    const BsdfSample s = lobe.sample(wo, choice, {u, v});
    if (s.pdf == 0) continue;
    // Refracted radiance is that of a narrower beam: energy counts without the factor 1 / eta^2.
    const double weight = std::fabs(s.wi.z) / s.pdf * (s.wi.z < 0 ? double(s.eta) * s.eta : 1);
    r += s.value.r * weight, g += s.value.g * weight, b += s.value.b * weight;
  }
  return Rgb{float(r / samples), float(g / samples), float(b / samples)};
}

/// Whether a sample has a unit direction and, but for delta directions, the density and value that it has by
/// evaluate(). Asked so often that each question as an assertion of its own would take most of the time.
template <typename Lobe>
bool is_what_is_evaluated(const Lobe& lobe, const Vec3& wo, const BsdfSample& sample) {
  if (!(std::fabs(length(sample.wi) - 1) < 1e-5f)) return false;
  if (sample.is_delta) return true;
  const auto [value, pdf] = lobe.evaluate(wo, sample.wi);
  return std::fabs(sample.pdf - pdf) <= 1e-5f * pdf && sample.value == value && is_finite(sample.value);
}

/// Samples a lobe and checks, as one of `tests` tests: that value and density of each sample are those of
/// evaluate() and pdf(), that the directions follow pdf(), delta directions their probabilities, and that the
/// density integrates to the part of samples that are not lost.
template <class Lobe>
void check_sampling(const Lobe& lobe, const Vec3& wo, int tests, int parts = 16) {
  constexpr int samples = 60000;
  constexpr std::size_t cells = SphereGrid::rows * SphereGrid::columns;
  // Last: delta directions on the viewer's side, on the other, and what is lost.
  std::vector<std::size_t> observed(cells + 3);
  std::vector<double> expected(cells + 3);
  SphereGrid::visit(parts, [&](const Vec3& wi, double area, std::size_t cell) {
    expected[cell] += samples * area * double(lobe.evaluate(wo, wi).pdf);
  });
  Random random(29);
  for (int i = 0; i < samples; ++i) {
    const float choice = random.unit();
    const float u = random.unit();
    const float v = random.unit();
    const BsdfSample s = lobe.sample(wo, choice, {u, v});
    const bool lost = s.pdf == 0;
    const std::size_t delta = cells + (s.wi.z > 0 ? 0 : 1);
    if (!lost && !is_what_is_evaluated(lobe, wo, s)) {
      CAPTURE(i, s.wi.x, s.wi.y, s.wi.z, s.pdf);
      FAIL("a sample is not what evaluate() says of its direction");
    }
    if (!lost && s.is_delta) expected[delta] = samples * double(s.pdf);
    ++observed[lost ? cells + 2 : s.is_delta ? delta : SphereGrid::cell(s.wi)];
  }
  double total = 0;
  for (const double count : expected) total += count;
  CHECK(total <= samples * 1.003);  // The sum over the grid is that exact.
  expected.back() = std::max(0.0, samples - total);
  if (expected.back() < 5) expected.back() = 5 + double(observed.back());
  check_counts(observed, expected, tests, 0.08);
}

}  // namespace twinray::test
