// SPDX-License-Identifier: Apache-2.0
// The OBJ reader on any bytes, and on any materials: a scene, or an Error that names the file. What follows
// the first byte 255 is the material file, whatever it is called.
#include <cstdint>
#include <string>

#include "core/error.h"
#include "io/obj/scene.h"
#include "tests/fuzz/require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  const std::size_t end = bytes.find('\xff');
  const std::string materials = end == bytes.npos ? "" : bytes.substr(end + 1);
  const auto read = [&](const std::string& path) {
    return path == "input.obj" ? bytes.substr(0, end) : materials;
  };
  twinray::WarningList warnings(false);
  twinray::LoadOptions options;
  options.pictures = std::make_shared<std::vector<twinray::PictureUse>>();
  try {
    const twinray::ObjModel model = twinray::read_obj("input.obj", read, warnings);
    try {
      twinray::make_scene(model, options, warnings);
    } catch (const twinray::Error&) {  // A coordinate that no scene may have names its mesh.
    }
  } catch (const twinray::Error& error) {
    twinray::fuzz::require(std::string_view(error.what()).starts_with("input.obj"));
  }
  return 0;
}
