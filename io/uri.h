// SPDX-License-Identifier: Apache-2.0
// References of documents to files, as URIs have them (RFC 3986), as far as they are paths.
#pragma once
#include <string>
#include <string_view>

namespace twinray {

/// With "%20" and the like as the bytes that they stand for; what is no such code stays.
std::string decoded_uri(std::string_view uri);

/// Whether it leads to another machine: "http://...".
bool is_remote(std::string_view uri);

/// The path that a reference within a file means, without "." and "..": relative to the file's folder, or
/// that of a "file:" URI.
std::string path_of_uri(std::string_view uri, const std::string& from_file);

/// The path that a file's name within a file means, as it stands: relative to the folder of that.
std::string path_of_name(const std::string& name, const std::string& from_file);

/// A path without "." and "..", as far as its text tells.
std::string normal_path(const std::string& path);

}  // namespace twinray
