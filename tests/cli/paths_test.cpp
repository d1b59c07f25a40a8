// SPDX-License-Identifier: Apache-2.0
// Names of files that are no plain words.
#include <fmt/format.h>

#include "io/picture/image_file.h"
#include "tests/support/catch.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

const std::string source = TWINRAY_SOURCE_DIR "/scenes/box.dae";
const std::string view =
    "90 60 1.5 0.1 100\n0 1 5\n0 1 0\n1.57 0 5 0.5 20\n1 0 0 0 1 0 0 0 1\n800 600 519.6\n4.7 0\n";

/// Names that are hard for a shell, for an eye, or for who takes letters for bytes.
const std::vector<std::string> names{"two words", "Größe",   "箱", "🐇",    "quote\"s",
                                     "$HOME",     "a;b|c&d", "-q", "#%{}", "bytes\xff\xfe"};

}  // namespace

TEST_CASE("names of files may hold spaces, any letters and any bytes, whichever option they go with") {
  for (const std::string& name : names) {
    CAPTURE(name);
    const TemporaryFolder folder;
    const std::filesystem::path inner = folder.path() / name;
    std::filesystem::create_directory(inner);
    const auto file = [&](const std::string& ending) { return (inner / (name + ending)).string(); };
    std::filesystem::copy_file(source, file(".dae"));
    write_text(file(".info"), view);
    write_image(file("-sky.exr"), Image(4, 2));
    const ProcessResult result = run_program(fmt::format(
        "{} -r 8 6 -s 2 -c {} -e {} -o {} --stats {}", quoted(file(".dae")), quoted(file(".info")),
        quoted(file("-sky.exr")), quoted(file(".png")), quoted(file(".json"))));
    CHECK(result.exit_code == 0);
    CHECK(read_image(file(".png")).width == 8);
    CHECK(result.out.find("Picture        " + file(".png")) != std::string::npos);
    CHECK(read_text(file(".json")).size() > 100);
    if (name != names.front() && name != names.back()) continue;  // The others take the same way.
    for (const std::string command :
         {"stats -r 2 2 --seconds=0 -q ", "agreement -r 2 2 -s 1 -q ", "crosscheck --rays=16 -q "})
      CHECK(run_program(command + quoted(file(".dae"))).exit_code == 0);
  }
}

TEST_CASE("a message has a file's name as it was given") {
  const TemporaryFolder folder;
  for (const std::string& name : names) {
    const std::string path = folder.file(name + ".dae");
    CHECK(run_program(quoted(path) + " -q").err == fmt::format("twinray: {}: there is no such file\n", path));
    write_text(path, "<svg/>");
    CHECK(run_program(quoted(path) + " -q").err.starts_with("twinray: " + path + ":1:1: not COLLADA"));
  }
}

}  // namespace twinray::test
