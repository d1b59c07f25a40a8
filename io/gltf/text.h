// SPDX-License-Identifier: Apache-2.0
// The JSON text of a glTF file before it is values.
#pragma once
#include <cstddef>
#include <string>

namespace twinray {

struct GltfContext;

/// Throws Error with line and column where objects and arrays nest too deeply for readers that call
/// themselves.
void check_depth(const std::string& text, const GltfContext& context);

/// Where the first number is that no double holds; the end where there is none. The text is JSON otherwise.
std::size_t too_large_number(const std::string& text);

}  // namespace twinray
