// SPDX-License-Identifier: Apache-2.0
// What is checked before and while a picture is read, on any bytes. The first byte chooses the name's ending,
// and so the format; the others are the file.
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include "core/error.h"
#include "io/image_file.h"
#include "tests/fuzz/require.h"

namespace {

std::string ending(std::uint8_t letter) {
  switch (letter) {
    case 'e':
      return ".exr";
    case 'h':
      return ".hdr";
    case 'j':
      return ".jpg";
    case 't':
      return ".tga";
    default:
      return ".png";
  }
}

/// A file of this process for each ending: written anew for each input.
std::string path_for(std::uint8_t letter) {
  static const std::string stem =
      (std::filesystem::temp_directory_path() / ("twinray-fuzz-" + std::to_string(getpid()))).string();
  return stem + ending(letter);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string path = path_for(data[0]);
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(data) + 1, std::streamsize(size - 1));
  try {
    const twinray::Image image = twinray::read_image(path);
    twinray::fuzz::require(image.pixels.size() == std::size_t(image.width) * std::size_t(image.height));
  } catch (const twinray::Error& error) {
    twinray::fuzz::require(std::string_view(error.what()).find(path) != std::string_view::npos);
  }
  std::filesystem::remove(path);
  return 0;
}
