// SPDX-License-Identifier: Apache-2.0
// Renders in tests: means with their standard errors, and comparisons of films bit for bit.
#pragma once
#include "integrators/path.h"
#include "integrators/render.h"

namespace twinray::test {

struct Estimate {
  double mean = 0;            ///< Of the luminance over all pixels.
  double standard_error = 0;  ///< From the pixels' own variances; an upper bound for stratified samples.
};

/// Renders with one thread by default, on the engine.
RenderResult render_with(const Scene& scene, const Integrator& integrator, const RenderOptions& options,
                         Backend backend = default_backend());

Estimate estimate_of(const Film& film);

/// The mean luminance of the picture, with the independent sampler unless the options say otherwise.
Estimate estimate(const Scene& scene, const PathOptions& path, const RenderOptions& options,
                  Backend backend = default_backend());

/// Two-sided: |a - b| in units of the standard error of the difference.
double z_score(const Estimate& a, const Estimate& b);
double z_score(const Estimate& a, double exact);

/// z beyond this has a probability of 1e-6 under the null hypothesis, so that a suite of 1000 such checks
/// rejects wrongly once in 1000 seeds; the seeds are fixed.
inline constexpr double z_limit = 4.892;

/// Whether every pixel of every layer has the same sums and counts.
bool same_bits(const Film& a, const Film& b);

}  // namespace twinray::test
