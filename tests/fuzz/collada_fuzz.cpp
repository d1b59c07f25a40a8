// SPDX-License-Identifier: Apache-2.0
// The COLLADA reader on any bytes: a scene that is consistent, or an Error that names the file. Anything else
// that is thrown ends the fuzzer, and so do the sanitizers.
#include <cstdint>

#include "core/error.h"
#include "core/scene.h"
#include "io/collada/collada.h"
#include "tests/fuzz/require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    const auto document = twinray::XmlDocument::parse(text, "input.dae");
    const twinray::LoadedScene loaded = twinray::read_collada(
        *document, {.keep_both_lamps = size % 2 == 0},
        {.picture = [](const std::string& path, const twinray::PictureMeaning&, const twinray::LoadOptions&) {
          return twinray::missing_texture(path + ": not read here");
        }});
    twinray::check_scene(loaded.scene);
    for (const twinray::Diagnostic& warning : loaded.warnings)
      twinray::fuzz::require(warning.text().starts_with("input.dae"));
  } catch (const twinray::Error& error) {
    twinray::fuzz::require(std::string_view(error.what()).starts_with("input.dae"));
  }
  return 0;
}
