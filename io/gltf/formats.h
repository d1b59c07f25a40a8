// SPDX-License-Identifier: Apache-2.0
// What an accessor may hold, by what it is used for (Khronos Group, "glTF 2.0 Specification", 2.0.1, sections
// 3.6 to 3.11, and KHR_mesh_quantization and EXT_mesh_gpu_instancing).
#pragma once
#include <string_view>

namespace twinray {

/// Lists are words between spaces. A component is its code and, of whole numbers that stand for those up to
/// 1, an "n": "5126 5121n".
struct GltfFormat {
  std::string_view use;    ///< "COLOR_n"
  std::string_view types;  ///< "VEC3 VEC4"
  std::string_view components;
  std::string_view quantized = "";  ///< Components that KHR_mesh_quantization adds.
  bool is_finite = false;           ///< Whether a number that is not finite is an error.
};

/// Of an attribute of vertices whose name is known.
const GltfFormat& vertex_format(std::string_view attribute);
/// Of an attribute of a morph target: POSITION, NORMAL or TANGENT.
const GltfFormat& target_format(std::string_view attribute);
/// Of TRANSLATION, ROTATION or SCALE of instances.
const GltfFormat& instance_format(std::string_view attribute);
/// Of the values of an animation that moves a translation, rotation, scale or weights.
const GltfFormat& output_format(std::string_view path);

inline constexpr GltfFormat time_format{"times of an animation", "SCALAR", "5126"};
inline constexpr GltfFormat matrix_format{"inverse bind matrices", "MAT4", "5126", "", true};

}  // namespace twinray
