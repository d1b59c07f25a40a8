// SPDX-License-Identifier: Apache-2.0
// The two forms of a glTF file: JSON text, or a binary one (.glb) that holds the text and a buffer.
#pragma once
#include <optional>
#include <string>

namespace twinray {

struct GltfContext;

struct GltfContainer {
  std::string json;
  std::optional<std::string> buffer;  ///< The binary chunk, if there is one.
};

/// Takes the bytes of a file apart. Throws Error, which begins with the name, where a binary file (one that
/// begins as such, or is called ".glb" and does not begin as JSON does) is not whole, is not of version 2 or
/// does not begin with its JSON chunk. Warns of what lies behind its end.
GltfContainer open_gltf(std::string bytes, GltfContext& context);

}  // namespace twinray
