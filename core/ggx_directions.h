// SPDX-License-Identifier: Apache-2.0
// How much more or less of the light along a direction GGX facets of two alphas, as of brushed metal, lose to
// each other than facets without direction (core/ggx_albedo.h) whose alpha is the root mean square of both.
//
// A direction counts by its cosine, the alpha along it and the alpha across it, as if these were the axes';
// what the slopes' correlation between the axes adds is nearly as its square, and has a table of its own.
#pragma once
#include "core/microfacet.h"

namespace twinray {

/// What is to be added to ggx_loss(w.z, facets.mean_alpha()) along w, w.z > 0. Within 0.06, and within 0.13
/// nearer to the horizon than a cosine of 0.1.
float ggx_loss_change(const Ggx& facets, const Vec3& w);
/// The same for light that is the same from all directions, to average_ggx_loss.
float average_ggx_loss_change(const Ggx& facets);

/// What is to be added to ggx_boundary_loss. eta as there.
float ggx_boundary_loss_change(const Ggx& facets, const Vec3& w, float eta);
/// The same for light that is the same from all directions.
float average_ggx_boundary_loss_change(const Ggx& facets, float eta);

}  // namespace twinray
