// SPDX-License-Identifier: Apache-2.0
// What the program loads before it does anything: OpenImageIO and the 260 libraries behind it only for
// pictures that no smaller library reads or writes.
#include <fmt/format.h>

#include <filesystem>

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

TEST_CASE("OpenImageIO is loaded to read HDR, to write JPEG, TIFF and HDR, and for nothing else") {
  const TemporaryFolder folder;
  for (const std::string arguments : {"--version", "--help", "render --help"})
    CHECK_FALSE(loads_openimageio(arguments));
  const auto output = [&](const std::string& name) {
    return fmt::format("{} -o '{}'", tiny_box, folder.file(name));
  };
  for (const std::string name : {"a.png", "a.exr", "a.pfm"}) CHECK_FALSE(loads_openimageio(output(name)));
  for (const std::string name : {"a.jpg", "a.tif", "a.hdr"}) CHECK(loads_openimageio(output(name)));
  const auto environment = [&](const std::string& name) {
    write_image(folder.file(name), Image(4, 2));
    return fmt::format("{} -e '{}'", output("b.png"), folder.file(name));
  };
  for (const std::string name : {"sky.png", "sky.exr", "sky.pfm", "sky.jpg"})
    CHECK_FALSE(loads_openimageio(environment(name)));
  CHECK(loads_openimageio(environment("sky.hdr")));
}

#ifdef TWINRAY_FEW_THREADS  // Sanitizers look for libraries in another order.

TEST_CASE("where OpenImageIO cannot be loaded PNGs and EXRs are written, and a JPEG is a clear error") {
  const TemporaryFolder folder;
  write_text(folder.file("libtwinray_image_codec.so"), "broken");
  const std::string environment = fmt::format("LD_LIBRARY_PATH='{}'", folder.path().string());
  const auto render = [&](const std::string& name) {
    return run_program(fmt::format("{} -o '{}'", tiny_box, folder.file(name)), environment);
  };
  const ProcessResult jpeg = render("a.jpg");
  CHECK(jpeg.exit_code == 1);
  CHECK(jpeg.err.starts_with("twinray: JPEG, TIFF and HDR pictures cannot be written, nor HDR ones read: "));
  CHECK(jpeg.err.find("libtwinray_image_codec.so") != std::string::npos);
  for (const std::string name : {"a.png", "a.exr"}) {
    CHECK(render(name).exit_code == 0);
    CHECK(read_image(folder.file(name)).width == 8);
  }
}

TEST_CASE("a library of another version of twinray is refused, not called") {
  const TemporaryFolder folder;
  // What cannot be told from an older version: a library that has no function of that name.
  std::filesystem::copy_file(TWINRAY_FEW_THREADS, folder.file("libtwinray_image_codec.so"));
  const ProcessResult result = run_program(fmt::format("{} -o '{}'", tiny_box, folder.file("a.jpg")),
                                           fmt::format("LD_LIBRARY_PATH='{}'", folder.path().string()));
  CHECK(result.exit_code == 1);
  CHECK(result.err.ends_with("libtwinray_image_codec.so is of another version of twinray\n"));
  CHECK_FALSE(std::filesystem::exists(folder.file("a.jpg")));
}

#endif

}  // namespace twinray::test
