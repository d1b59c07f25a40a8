// SPDX-License-Identifier: Apache-2.0
#include "io/picture/image_metadata.h"

namespace twinray {

std::string value_of(const ImageMetadata& metadata, const std::string& name) {
  for (const auto& [known, value] : metadata)
    if (known == name) return value;
  return "";
}

void set_value(ImageMetadata& metadata, const std::string& name, const std::string& value) {
  for (auto& [known, old] : metadata)
    if (known == name) {
      old = value;
      return;
    }
  metadata.emplace_back(name, value);
}

}  // namespace twinray
