// SPDX-License-Identifier: Apache-2.0
// What a glTF file's URIs stand for: data within the text, or files beside it.
#pragma once
#include <string>
#include <string_view>

#include "io/gltf/context.h"

namespace twinray {

/// Whether the data stand in the URI itself: "data:...".
bool is_data_uri(std::string_view uri);

/// The bytes of a "data:" URI (RFC 2397), in base64 or not. Throws Error with the place.
std::string data_of_uri(std::string_view uri, const std::string& pointer, const GltfContext& context);

/// What is said of a URI that leads to another machine.
std::string remote_fault(const std::string& uri);

/// The path of a file that a URI names. Throws Error for one on another machine.
std::string gltf_path(const std::string& uri, const std::string& pointer, const GltfContext& context);

/// The bytes that a URI stands for, of either kind. Throws Error with the place.
std::string bytes_of_uri(const std::string& uri, const std::string& pointer, const GltfContext& context);

}  // namespace twinray
