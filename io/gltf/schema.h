// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

namespace twinray {

/// Under this name among its extensions a primitive has "indices" that have no bytes of their own.
inline constexpr const char* moved_indices = "twinray_indices";

struct GltfContext;

/// Checks the JSON text of a glTF file against what the format says of each property: its type and range,
/// that an index points to something, that what is required is there. Throws Error with the line, for text
/// that is no JSON, or with the JSON pointer and what would be valid. Names that are not known are warned of,
/// with the nearest known one; so are extensions that are not rendered, of which a required one is an error.
/// Gives the text as tinygltf takes it: without buffers and images, which it would read.
struct CheckedGltf {
  std::string json;
  struct Source {
    std::string uri;              ///< "" where there is none.
    std::size_t byte_length = 0;  ///< Of a buffer.
    int buffer_view = -1;         ///< Of an image within a buffer.
    std::string name;
  };
  std::vector<Source> buffers, images;
};
CheckedGltf check_gltf(const std::string& json, GltfContext& context);

}  // namespace twinray
