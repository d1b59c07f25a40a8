// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <string_view>

namespace twinray {

/// Extensions of a material that say alone what its surface is, the stronger one first.
inline constexpr std::string_view exclusive_extensions[] = {"KHR_materials_unlit",
                                                            "KHR_materials_pbrSpecularGlossiness"};

/// What becomes of an extension of a material beside one of these, as a sentence; "" where the format does
/// not exclude that.
std::string fault_beside(std::string_view exclusive, std::string_view extension);

}  // namespace twinray
