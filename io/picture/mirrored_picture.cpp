// SPDX-License-Identifier: Apache-2.0
#include "io/picture/mirrored_picture.h"

namespace twinray {

Image mirrored(const Image& image, bool to_right, bool below) {
  Image wide(image.width * (to_right ? 2 : 1), image.height * (below ? 2 : 1));
  for (int y = 0; y < wide.height; ++y)
    for (int x = 0; x < wide.width; ++x)
      wide.at(x, y) = image.at(x < image.width ? x : 2 * image.width - 1 - x,
                               y < image.height ? y : 2 * image.height - 1 - y);
  return wide;
}

UvTransform halved(const UvTransform& uv, bool to_right, bool below) {
  UvTransform result = uv;
  for (float& number : result.m[0]) number *= to_right ? 0.5f : 1.0f;
  for (float& number : result.m[1]) number *= below ? 0.5f : 1.0f;
  if (below) result.m[1][2] += 0.5f;
  return result;
}

}  // namespace twinray
