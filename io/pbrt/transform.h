// SPDX-License-Identifier: Apache-2.0
// The transforms that statements of pbrt's format mean, as matrices.
#pragma once
#include <array>
#include <optional>

#include "core/transform.h"

namespace twinray {

/// Of sixteen numbers column by column, as Transform and ConcatTransform have them. Nothing where the last
/// row is not 0 0 0 1 (up to its factor): such a matrix is no affine transform.
std::optional<Transform> affine(const std::array<double, 16>& numbers);

/// From world to camera space, of nine numbers: the camera's place, what it looks at, up. In camera space x
/// is to the right, y up, z along the view. Nothing where these do not span a space.
std::optional<Transform> look_at(const std::array<double, 16>& numbers);

/// Nothing where the transform flattens.
std::optional<Transform> inverse(const Transform& t);

/// The factor by which a transform scales all lengths; 0 where it scales some more than others.
double similarity_scale(const Transform& t);

/// How long a unit vector along axis `column` becomes.
double axis_length(const Transform& t, int column);

}  // namespace twinray
