// SPDX-License-Identifier: Apache-2.0
#include "cli/finite_picture.h"

#include <fmt/format.h>

#include "cli/console.h"
#include "core/error.h"
#include "io/picture/image_file.h"

namespace twinray {

Image read_finite_image(const std::string& path) {
  Image image = read_image(path);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      if (!is_finite(image.at(x, y)))
        throw Error(fmt::format("{}: pixel {} {} is not finite: it cannot be compared", path, x, y));
  if (const std::string warning = unread_parts(path); !warning.empty()) console::warn(warning);
  return image;
}

}  // namespace twinray
