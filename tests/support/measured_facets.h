// SPDX-License-Identifier: Apache-2.0
// What would be measured of microfacets whose light is known in closed form.
#pragma once
#include <cstddef>
#include <memory>

#include "core/material.h"
#include "core/measured_brdf.h"
#include "core/microfacet.h"

namespace twinray::test {

/// From so many angles to the normal and, unless that is 1, azimuths around the circle or the part 1 / folds
/// of it, in tables of nodes x nodes. The facets are GGX; each reflects the color, and light meets one only.
BrdfMeasurement measured_facets(const Ggx& facets, const Rgb& color, std::size_t thetas = 6,
                                std::size_t phis = 1, std::size_t nodes = 32, int folds = 1);

/// f(wo, wi) of those facets.
Rgb facets_value(const Ggx& facets, const Rgb& color, const Vec3& wo, const Vec3& wi);

/// A material of such facets: uneven where there are azimuths.
Measured measured_material(const Rgb& color, std::size_t phis = 1);

}  // namespace twinray::test
