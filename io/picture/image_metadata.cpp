// SPDX-License-Identifier: Apache-2.0
#include "io/picture/image_metadata.h"

#include <fmt/format.h>

#include "io/number_list.h"

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

std::string frame_value(const ImageFrame& frame) {
  return fmt::format("{} {} {} {}", frame.x, frame.y, frame.width, frame.height);
}

std::optional<ImageFrame> frame_of_value(const std::string& value) {
  constexpr double most = 1 << 24;  // Of more, no sums are asked for.
  try {
    const std::vector<double> n = parse_doubles(value);
    for (const double number : n)
      if (!(number >= -most && number <= most)) return std::nullopt;
    if (n.size() != 4 || !(n[2] >= 1) || !(n[3] >= 1)) return std::nullopt;
    return ImageFrame{int(n[0]), int(n[1]), int(n[2]), int(n[3])};
  } catch (const NumberError&) {
    return std::nullopt;
  }
}

}  // namespace twinray
