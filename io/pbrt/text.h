// SPDX-License-Identifier: Apache-2.0
// Parts of pbrt-v4's text, as writers put them together. A number has as many digits as tell it from any
// other of its type.
#pragma once
#include <string>
#include <string_view>

#include "core/rgb.h"
#include "core/transform.h"
#include "core/vec.h"

namespace twinray {

/// In quotation marks, with a backslash before what would end it.
std::string pbrt_string(std::string_view text);

// A parameter, behind a space: ` "float fov" [ 45 ]`.
std::string pbrt_real(std::string_view name, float value);
std::string pbrt_integer(std::string_view name, int value);
std::string pbrt_flag(std::string_view name, bool value);
std::string pbrt_rgb(std::string_view name, const Rgb& value);
std::string pbrt_point(std::string_view name, const Vec3& value);
std::string pbrt_vector(std::string_view name, const Vec3& value);
std::string pbrt_word(std::string_view name, std::string_view value);
/// The value is the name of a texture.
std::string pbrt_texture(std::string_view name, std::string_view texture);

/// A statement that replaces the current transform.
std::string pbrt_transform(const Transform& transform);

/// A line that readers skip.
std::string pbrt_comment(std::string_view text);

}  // namespace twinray
