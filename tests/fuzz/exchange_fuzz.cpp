// SPDX-License-Identifier: Apache-2.0
// The reader of the exchange form on any bytes; what follows the first byte 255 is each file that it names. A
// scene that is consistent, or an Error that names the file. Anything else that is thrown ends the fuzzer.
#include <cstdint>
#include <string>
#include <string_view>

#include "core/error.h"
#include "core/scene.h"
#include "io/exchange/reader.h"
#include "tests/fuzz/require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  const std::size_t end = bytes.find('\xff');
  const std::string rest = end == bytes.npos ? "" : bytes.substr(end + 1);
  try {
    const twinray::LoadedScene loaded = twinray::read_exchange(bytes.substr(0, end), "input.json", {},
                                                               [&](const std::string&) { return rest; });
    twinray::check_scene(loaded.scene);
  } catch (const twinray::Error& error) {
    twinray::fuzz::require(std::string_view(error.what()).starts_with("input"));
  }
  return 0;
}
