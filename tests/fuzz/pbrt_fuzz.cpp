// SPDX-License-Identifier: Apache-2.0
// The pbrt reader on any bytes, which are all other files that it names, too: a scene that is consistent, or
// an Error that names the file. Anything else that is thrown ends the fuzzer, and so do the sanitizers.
#include <cstdint>

#include "core/error.h"
#include "core/scene.h"
#include "io/pbrt/scene.h"
#include "tests/fuzz/require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  int reads = 0;
  const auto read = [&](const std::string& path) -> std::string {
    if (++reads > 4) throw twinray::Error(path + ": there is no such file");
    return text.substr(text.size() / 2);
  };
  try {
    const twinray::LoadedScene loaded = twinray::read_pbrt(text, "input.pbrt", {}, read);
    twinray::check_scene(loaded.scene);
    for (const twinray::Diagnostic& warning : loaded.warnings)
      twinray::fuzz::require(!warning.text().empty());
  } catch (const twinray::Error& error) {
    twinray::fuzz::require(std::string_view(error.what()).find(':') != std::string_view::npos);
  }
  return 0;
}
