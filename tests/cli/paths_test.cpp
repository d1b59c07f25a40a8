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

TEST_CASE("what keeps names in JSON refuses those that are not UTF-8 before it writes anything") {
  const TemporaryFolder folder;
  const std::string named = folder.file("a\xff"), scene = named + ".dae", plain = folder.file("a.dae");
  std::filesystem::copy_file(source, scene);
  std::filesystem::copy_file(source, plain);
  const std::string small = " -r 8 6 -s 2 -q ", picture = folder.file("a.png");
  const auto refused = [&](const std::string& arguments, const std::string& name, const char* holder) {
    CAPTURE(arguments);
    const ProcessResult result = run_program(arguments);
    CHECK(result.exit_code == 1);
    CHECK(result.err == fmt::format("twinray: {}: this name is not UTF-8, as all names in JSON are, which {} "
                                    "keeps them in; give it another one\n",
                                    name, holder));
    CHECK(folder.file_count() == 2);
  };
  const std::string checkpoint = small + "--checkpoint " + quoted(folder.file("a.ck")) + " -o ";
  refused(quoted(scene) + checkpoint + quoted(picture), scene, "a film");
  refused(quoted(plain) + checkpoint + quoted(named + ".png"), named + ".png", "a film");
  refused(quoted(plain) + small + "-o " + quoted(named + ".film"), named + ".film", "a film");
  const std::string plan = "plan -q --jobs=2 -o " + quoted(picture);
  refused(plan + " --folder=" + quoted(folder.file("p")) + " " + quoted(scene), scene, "a film");
  refused(plan + " --folder=" + quoted(named) + " " + quoted(plain), named, "a job's template");
  refused("info --json " + quoted(scene), scene, "--json");
}

TEST_CASE("a scene reads files whose names are not UTF-8, but a film cannot name them") {
  const TemporaryFolder folder;
  const std::string scene = folder.file("a.obj");
  write_image(folder.file("p\xff.png"), Image(2, 2));
  write_text(folder.file("a.mtl"), "newmtl m\nmap_Kd p\xff.png\n");
  write_text(scene, "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 2 0\nvt 0 0\nusemtl m\nf 1/1 2/1 3/1\n");
  const std::string render = quoted(scene) + " -r 8 6 -s 2 -q -o ";
  CHECK(run_program(render + quoted(folder.file("a.png"))).exit_code == 0);
  for (const std::string& command :
       {render + quoted(folder.file("a.film")), "info --json " + quoted(scene),
        "plan " + quoted(scene) + " -q --jobs=2 --folder=" + quoted(folder.file("p")) + " -o a.png"})
    CHECK(run_program(command).err.find("p\xff.png: this name is not UTF-8") != std::string::npos);
  CHECK(folder.file_count() == 4);
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
