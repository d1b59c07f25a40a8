// SPDX-License-Identifier: Apache-2.0
// Renders in tests: means with their standard errors, and comparisons of films bit for bit.
#pragma once
#include "integrators/path.h"
#include "integrators/render.h"
#include "tests/support/statistics.h"

namespace twinray::test {

/// How far two routes to one radiance may differ, relatively: by the rounding of many floats.
inline constexpr double render_rounding = 1e-5;

/// All ways of finding direct light.
inline constexpr DirectMethod all_methods[] = {DirectMethod::mis, DirectMethod::lights,
                                               DirectMethod::hemisphere};

struct Estimate {
  double mean = 0;            ///< Of the luminance over all pixels.
  double standard_error = 0;  ///< From the pixels' own variances; an upper bound for stratified samples.
};

/// A picture of 4 x 4 pixels, of independent samples, by one thread.
RenderOptions small_picture(std::uint32_t samples);

/// Renders with one thread by default, on the engine.
RenderResult render_with(const Scene& scene, const Integrator& integrator, const RenderOptions& options,
                         Backend backend = default_backend());

Estimate estimate_of(const Film& film);

/// The mean luminance of the picture, with the independent sampler unless the options say otherwise.
Estimate estimate(const Scene& scene, const PathOptions& path, const RenderOptions& options,
                  Backend backend = default_backend());

/// The level of each comparison of means: of 10,000 of them, more than the suite has, one or more reject what
/// is right for one choice of seeds in a hundred (Sidak's correction, test::family_level). The seeds are
/// fixed.
inline const double mean_level = sidak_level(10000);

/// Checks that a mean is what it should be, up to the rounding of a few floats or at `mean_level`, and that
/// an error of `sees` times the expected mean would be seen with a probability of 99 %.
void check_mean(const Estimate& found, double expected, double sees);
/// The same for two estimates of one mean; `sees` is relative to the second one's.
void check_same_mean(const Estimate& a, const Estimate& b, double sees);

/// Of all pixels.
std::uint64_t sample_count(const Film& film);

/// Whether every pixel of every layer has the same sums and counts.
bool same_bits(const Film& a, const Film& b);

}  // namespace twinray::test
