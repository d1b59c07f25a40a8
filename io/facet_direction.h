// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace twinray {

/// Warns of facets of unequal widths on a mesh that cannot say where these lie.
inline constexpr const char* no_facet_direction =
    "the mesh has no texture coordinates, which the direction of its facets goes by; it is any direction";

}  // namespace twinray
