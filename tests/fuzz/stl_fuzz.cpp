// SPDX-License-Identifier: Apache-2.0
// The STL reader on any bytes: triangles whose corners are there, or an Error that names the file.
#include <cstdint>

#include "core/error.h"
#include "io/stl/reader.h"
#include "tests/fuzz/require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  twinray::WarningList warnings(false);
  try {
    const twinray::ObjModel model =
        twinray::read_stl({reinterpret_cast<const char*>(data), size}, "input.stl", warnings);
    for (const twinray::ObjFaces& faces : model.faces)
      for (const twinray::ObjCorner& corner : faces.corners)
        twinray::fuzz::require(corner.position < model.positions.size());
  } catch (const twinray::Error& error) {
    twinray::fuzz::require(std::string_view(error.what()).starts_with("input.stl"));
  }
  return 0;
}
