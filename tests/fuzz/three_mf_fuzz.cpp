// SPDX-License-Identifier: Apache-2.0
// The 3MF reader on any model in a package: a scene that is consistent, or an Error that names the package.
#include <cstdint>
#include <filesystem>
#include <fstream>

#include "core/error.h"
#include "core/scene.h"
#include "io/three_mf/scene.h"
#include "tests/fuzz/require.h"
#include "tests/support/three_mf_text.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // Packages are read from files alone.
  static const std::string path = std::filesystem::temp_directory_path() / "twinray_fuzz.3mf";
  std::ofstream(path, std::ios::binary)
      << twinray::test::three_mf_package({reinterpret_cast<const char*>(data), size});
  try {
    const twinray::LoadedScene loaded = twinray::load_three_mf(path, {});
    twinray::check_scene(loaded.scene);
  } catch (const twinray::Error& error) {
    twinray::fuzz::require(std::string_view(error.what()).starts_with(path));
  }
  return 0;
}
