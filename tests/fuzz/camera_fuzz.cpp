// SPDX-License-Identifier: Apache-2.0
// The camera settings file on any bytes: a camera of finite numbers, or an Error that names the file.
#include <cmath>
#include <cstdint>

#include "core/error.h"
#include "io/camera_file.h"
#include "tests/fuzz/require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const twinray::Camera camera =
        twinray::parse_camera({reinterpret_cast<const char*>(data), size}, "input.info", {});
    for (const float number : {camera.tan_half_width, camera.tan_half_height, camera.position.x,
                               camera.right.x, camera.up.y, camera.forward.z, camera.clip_near})
      twinray::fuzz::require(std::isfinite(number));
  } catch (const twinray::Error& error) {
    twinray::fuzz::require(std::string_view(error.what()).starts_with("input.info"));
  }
  return 0;
}
