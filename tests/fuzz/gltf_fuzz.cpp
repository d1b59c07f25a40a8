// SPDX-License-Identifier: Apache-2.0
// The glTF reader on any bytes, whose second half all other files are that it names: a scene that is
// consistent, or an Error that names the file. Anything else that is thrown ends the fuzzer, and so do the
// sanitizers.
#include <cstdint>

#include "core/error.h"
#include "core/scene.h"
#include "io/gltf/gltf.h"
#include "tests/fuzz/require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  const auto read = [&](const std::string&) { return bytes.substr(bytes.size() / 2); };
  try {
    const twinray::LoadedScene loaded = twinray::read_gltf(bytes, "input.gltf", {}, read);
    twinray::check_scene(loaded.scene);
    for (const twinray::Diagnostic& warning : loaded.warnings)
      twinray::fuzz::require(!warning.text().empty());
  } catch (const twinray::Error& error) {
    twinray::fuzz::require(std::string_view(error.what()).find(':') != std::string_view::npos);
  }
  return 0;
}
