// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/exclusions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace twinray {
namespace {

/// What the extensions' own pages exclude beside both.
constexpr std::array<std::string_view, 8> layers{
    "KHR_materials_anisotropy",   "KHR_materials_clearcoat", "KHR_materials_ior",
    "KHR_materials_iridescence",  "KHR_materials_sheen",     "KHR_materials_specular",
    "KHR_materials_transmission", "KHR_materials_volume",
};

}  // namespace

std::string fault_beside(std::string_view exclusive, std::string_view extension) {
  const bool is_layer = std::find(layers.begin(), layers.end(), extension) != layers.end();
  if (exclusive == exclusive_extensions[0]) {
    if (extension == exclusive_extensions[1])
      return fmt::format("beside {} its diffuse color alone counts", exclusive);
    return is_layer || extension == "KHR_materials_emissive_strength"
               ? fmt::format("{} has no effect beside {}", extension, exclusive)
               : "";
  }
  if (!is_layer) return "";
  if (extension == "KHR_materials_ior" || extension == "KHR_materials_specular")
    return fmt::format("{} has no effect beside {}, which says what is reflected", extension, exclusive);
  return fmt::format("the format excludes {} beside {}; both are rendered", extension, exclusive);
}

}  // namespace twinray
