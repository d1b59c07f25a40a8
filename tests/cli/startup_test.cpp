// SPDX-License-Identifier: Apache-2.0
// What the program loads before it does anything: OpenImageIO and the 260 libraries behind it only for
// pictures that need them.
#include <fmt/format.h>

#include "io/picture/image_file.h"
#include "tests/support/catch.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

const std::string tiny_box = "'" TWINRAY_SOURCE_DIR "/scenes/box.dae' -r 8 6 -s 1 -q";

/// Whether the dynamic linker opens OpenImageIO for this command line.
bool loads_openimageio(const std::string& arguments) {
  const ProcessResult result = run_program(arguments + " 2>&1", "LD_DEBUG=files");
  INFO(result.out);
  REQUIRE(result.exit_code == 0);
  REQUIRE(result.out.find("libstdc++") != std::string::npos);
  return result.out.find("libOpenImageIO") != std::string::npos;
}

}  // namespace

TEST_CASE("OpenImageIO is loaded for an EXR and an environment, and for nothing else") {
  const TemporaryFolder folder;
  const std::string sky = folder.file("sky.exr"), png = folder.file("a.png");
  write_image(sky, Image(4, 2));
  for (const std::string arguments : {"--version", "--help", "render --help"})
    CHECK_FALSE(loads_openimageio(arguments));
  CHECK_FALSE(loads_openimageio(fmt::format("{} -o '{}'", tiny_box, png)));
  CHECK(loads_openimageio(fmt::format("{} -o '{}'", tiny_box, folder.file("a.exr"))));
  CHECK(loads_openimageio(fmt::format("{} -o '{}' -e '{}'", tiny_box, png, sky)));
}

#ifdef TWINRAY_FEW_THREADS  // Sanitizers look for libraries in another order.

TEST_CASE("where OpenImageIO cannot be loaded PNGs are written, and an EXR is a clear error") {
  const TemporaryFolder folder;
  write_text(folder.file("libtwinray_image_codec.so"), "broken");
  const std::string environment = fmt::format("LD_LIBRARY_PATH='{}'", folder.path().string());
  const ProcessResult exr =
      run_program(fmt::format("{} -o '{}'", tiny_box, folder.file("a.exr")), environment);
  CHECK(exr.exit_code == 1);
  CHECK(exr.err.starts_with("twinray: pictures other than PNG cannot be read or written: "));
  CHECK(exr.err.find("libtwinray_image_codec.so") != std::string::npos);
  CHECK(run_program(fmt::format("{} -o '{}'", tiny_box, folder.file("a.png")), environment).exit_code == 0);
  CHECK(read_image(folder.file("a.png")).width == 8);
}

#endif

}  // namespace twinray::test
