// SPDX-License-Identifier: Apache-2.0
// Private: triangles from STL files (3D Systems, "StereoLithography Interface Specification", 1988), ASCII
// and binary.
#pragma once
#include <string>
#include <string_view>

#include "io/diagnostic.h"
#include "io/obj/reader.h"

namespace twinray {

/// Reads the bytes of a file; `path` stands for it in messages. A solid is an object. Normals are left out:
/// they say again what the triangles say, and may say it wrongly. Throws Error, with the place or the count,
/// where the file is none of STL, is cut off, or has a coordinate beyond +-max_coordinate. A text that ends
/// within a solid, but between facets, is a warning.
ObjModel read_stl(std::string_view bytes, const std::string& path, WarningList& warnings);

}  // namespace twinray
