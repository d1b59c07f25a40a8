// SPDX-License-Identifier: Apache-2.0
#include "io/uri.h"

#include <charconv>
#include <filesystem>

namespace twinray {

std::string decoded_uri(std::string_view uri) {
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    unsigned byte = 0;
    const char* digits = uri.data() + i + 1;
    if (uri[i] == '%' && i + 2 < uri.size() &&
        std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2) {
      text += char(byte);
      i += 2;
    } else {
      text += uri[i];
    }
  }
  return text;
}

bool is_remote(std::string_view uri) {
  const std::size_t scheme = uri.find("://");
  return scheme != std::string_view::npos && uri.substr(0, scheme) != "file";
}

std::string path_of_uri(std::string_view uri, const std::string& from_file) {
  constexpr std::string_view scheme = "file:";
  if (uri.rfind(scheme, 0) == 0) {
    uri.remove_prefix(scheme.size());
    if (uri.rfind("//", 0) == 0) uri.remove_prefix(2);  // an authority, which is empty
  }
  return path_of_name(decoded_uri(uri), from_file);
}

std::string path_of_name(const std::string& name, const std::string& from_file) {
  return normal_path((std::filesystem::path(from_file).parent_path() / name).string());
}

std::string normal_path(const std::string& path) {
  return std::filesystem::path(path).lexically_normal().string();
}

}  // namespace twinray
