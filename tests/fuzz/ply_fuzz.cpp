// SPDX-License-Identifier: Apache-2.0
// The PLY reader on any bytes: a mesh whose indices and positions are valid, or an Error that names the file.
#include <cstdint>

#include "core/error.h"
#include "io/ply/reader.h"
#include "tests/fuzz/require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    std::vector<twinray::Shape> shapes;
    shapes.push_back(twinray::read_ply({reinterpret_cast<const char*>(data), size}, "input.ply").mesh);
    const auto& mesh = std::get<twinray::Mesh>(shapes[0]);
    bool is_near = true;
    for (const twinray::Vec3& p : mesh.positions)
      is_near = is_near && twinray::max_abs(p) <= twinray::max_coordinate;
    if (is_near) twinray::Geometry geometry(std::move(shapes));
  } catch (const twinray::Error& error) {
    twinray::fuzz::require(std::string_view(error.what()).starts_with("input.ply"));
  }
  return 0;
}
