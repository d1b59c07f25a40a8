// SPDX-License-Identifier: Apache-2.0
// What glTF calls the attributes of vertices, of morph targets and of instances.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace twinray {

/// What is wrong with an attribute's name on an object of a kind of the rules ("primitive", "target",
/// "EXT_mesh_gpu_instancing"), with the nearest name that is known; "" where the format knows it, or it
/// begins with "_", as a program's own do.
std::string fault_of_attribute(std::string_view object, std::string_view name);

/// The attributes that one of a primitive cannot be without: WEIGHTS_1 and JOINTS_0 of JOINTS_1.
std::vector<std::string> needed_beside(std::string_view name);

}  // namespace twinray
