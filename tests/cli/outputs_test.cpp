// SPDX-License-Identifier: Apache-2.0
// Where the program's pictures and statistics go, and what becomes of the old ones.
#include <fmt/format.h>
#include <sys/stat.h>

#include <tuple>

#include "cli/outputs.h"
#include "cli/picture_metadata.h"
#include "io/picture/image_file.h"
#include "tests/support/catch.h"
#include "tests/support/json.h"
#include "tests/support/own_scenes.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

namespace fs = std::filesystem;

const std::string small_output = box_scene + " -r 24 18 -s 2 ";
const std::string statistics = "stats " + box_scene + " -r 8 6 --seconds=0 ";

/// The environment in which something happens when half of a file is written (AT_WRITE), or when it is
/// flushed (AT_SYNC).
std::string while_writing(const std::string& moment, const std::string& what) {
  return "ASAN_OPTIONS=verify_asan_link_order=0 LD_PRELOAD='" TWINRAY_AT_SYNC "' " + moment + "=" + what;
}

std::string at_sync(const std::string& what) { return while_writing("AT_SYNC", what); }

}  // namespace

TEST_CASE("no command writes over what it reads") {
  const TemporaryFolder folder;
  const std::string scene = folder.file("box.dae"), picture = folder.file("a.png");
  fs::copy_file(box_scene, scene);
  const std::string text = read_text(scene);
  const std::string render = "render " + quoted(scene) + " -r 8 6 -s 1 -q -o " + quoted(picture);
  REQUIRE(run_program(render).exit_code == 0);
  const std::string before = read_text(picture), link = folder.file("link");
  fs::create_symlink(scene, link);
  for (const std::string& command :
       {render + " --stats " + quoted(scene), render + " --checkpoint " + quoted(scene),
        render + " --metrics-file " + quoted(scene), render + " --stats " + quoted(link),
        render + " --replay 1 1 0 --replay-json " + quoted(scene),
        "stats " + quoted(scene) + " -r 8 6 --seconds=0 --csv " + quoted(scene),
        "error " + quoted(scene) + " -r 8 6 -s 1 --converge --csv " + quoted(scene),
        "compare " + quoted(picture) + " " + quoted(picture) + " --html " + quoted(picture)}) {
    INFO(command);
    const ProcessResult result = run_program(command);
    CHECK(result.exit_code == 1);
    CHECK(result.err.find("choose another name") != std::string::npos);
  }
  CHECK(read_text(scene) == text);
  CHECK(read_text(picture) == before);
}

TEST_CASE("what is no file may be read and written, and what is not there is no file that is read") {
  const TemporaryFolder folder;
  const std::string file = folder.file("a"), other = folder.file("b");
  write_text(file, "a");
  CHECK_NOTHROW(check_not_read({"/dev/null", other, ""}, {"/dev/null", file, other, ""}));
  CHECK_THROWS_WITH(check_not_read({other, file}, {"/dev/null", file}), Catch::Contains("this file is read"));
}

TEST_CASE("no command writes over a file that belongs to the scene") {
  const TemporaryFolder folder;
  const std::string picture = folder.file("wood.png"), scene = folder.file("a.pbrt");
  REQUIRE(run_program("render " + small_output + "-q -o " + quoted(picture)).exit_code == 0);
  write_text(scene,
             "WorldBegin Texture \"wood\" \"spectrum\" \"imagemap\" \"string filename\" \"wood.png\" "
             "Material \"diffuse\" \"texture reflectance\" \"wood\" Shape \"sphere\"");
  const std::string before = read_text(picture);
  const std::string render = "render " + quoted(scene) + " -r 8 6 -s 1 -q ";
  for (const std::string& command :
       {render + "-o " + quoted(picture), render + "--replay 1 1 0 --replay-obj " + quoted(picture)}) {
    INFO(command);
    const ProcessResult result = run_program(command);
    CHECK(result.exit_code == 1);
    CHECK(result.err.find("wood.png: this file is read; choose another name") != std::string::npos);
  }
  CHECK(read_text(picture) == before);
}

TEST_CASE("an old file survives a disk that is full, whichever output it is") {
  const TemporaryFolder folder;
  const std::string large = box_scene + " -r 160 120 -s 1 -q ";
  for (const auto& [name, arguments] : std::vector<std::pair<std::string, std::string>>{
           {"a.png", large + "-o "},
           {"a.exr", large + "-o "},
           {"render.json", small_output + "-q -o /dev/null --stats "},
           {"stats.json", statistics + "-q --json "},
           {"stats.csv", statistics + "-q --csv "}}) {
    CAPTURE(name);
    const std::string path = folder.file(name);
    write_text(path, "old");
    // Of what is larger than a block nothing can be written.
    const ProcessResult result = run_shell("ulimit -f 1; '" TWINRAY_PROGRAM "' " + arguments + quoted(path));
    CHECK(result.exit_code == 1);
    CHECK(result.err == fmt::format("twinray: {}: cannot be written: File too large\n", path));
    CHECK(read_text(path) == "old");
    fs::remove(path);
    CHECK(folder.file_count() == 0);
  }
}

TEST_CASE("an old file survives a disk that fails when it is flushed") {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.png");
  write_text(path, "old");
  const ProcessResult result = run_program(small_output + "-q -o " + quoted(path), at_sync("fail"));
  CHECK(result.exit_code == 1);
  CHECK(result.err == fmt::format("twinray: {}: cannot be written: Input/output error\n", path));
  CHECK(read_text(path) == "old");
  CHECK(folder.file_count() == 1);
}

TEST_CASE("an old file survives an interruption in the middle, and no unfinished file stays") {
  const TemporaryFolder folder;
  for (const std::string& arguments :
       {small_output + "-q -o /dev/null --stats ", statistics + "-q --json ", statistics + "-q --csv "})
    for (const std::string moment : {"AT_WRITE", "AT_SYNC"})
      for (const auto& [what, code, word] :
           {std::tuple("interrupt", 130, "interrupted"), {"terminate", 143, "ended by a signal"}}) {
        CAPTURE(arguments, moment, what);
        const std::string path = folder.file("a.png");
        write_text(path, "old");
        const ProcessResult result = run_program(arguments + quoted(path), while_writing(moment, what));
        CHECK(result.exit_code == code);
        CHECK(result.err == fmt::format("twinray: {}; unfinished outputs are removed, old files are as they "
                                        "were\n",
                                        word));
        CHECK(read_text(path) == "old");
        CHECK(folder.file_count() == 1);
      }
}

TEST_CASE("an old file survives SIGKILL in the middle, and the next run replaces it") {
  for (const std::string moment : {"AT_WRITE", "AT_SYNC"}) {
    CAPTURE(moment);
    const TemporaryFolder folder;
    const std::string path = folder.file("a.png");
    write_text(path, "old");
    CHECK(run_program(small_output + "-q -o " + quoted(path), while_writing(moment, "kill")).exit_code ==
          137);
    CHECK(read_text(path) == "old");
    CHECK(run_program(small_output + "-q -o " + quoted(path)).exit_code == 0);
    CHECK(read_image(path).width == 24);
  }
}

TEST_CASE("an old file survives a disk that fails when half of the new one is written") {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.png");
  write_text(path, "old");
  const ProcessResult result =
      run_program(small_output + "-q -o " + quoted(path), while_writing("AT_WRITE", "fail"));
  CHECK(result.exit_code == 1);
  CHECK(result.err == fmt::format("twinray: {}: cannot be written: Input/output error\n", path));
  CHECK(read_text(path) == "old");
  CHECK(folder.file_count() == 1);
}

TEST_CASE("a folder that may not be written into is an error before rendering, and keeps what is in it") {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.png"), anew = folder.file("b.png");
  write_text(path, "old");
  fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec);
  for (const std::string& output : {path, anew}) {
    const ProcessResult result = run_shell(without_rights() + "'" TWINRAY_PROGRAM "' " + box_scene +
                                           " -s 1000000 -q -o " + quoted(output));
    CHECK(result.exit_code == 1);
    CHECK(result.err == fmt::format("twinray: {}: cannot be written: Permission denied\n", output));
  }
  fs::permissions(folder.path(), fs::perms::owner_all);
  CHECK(read_text(path) == "old");
  CHECK(folder.file_count() == 1);
}

TEST_CASE("a program that was started to ignore interruptions ignores them") {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.png");
  const ProcessResult result = run_shell("trap '' INT; " + at_sync("interrupt") + " '" TWINRAY_PROGRAM "' " +
                                         small_output + "-q -o " + quoted(path));
  CHECK(result.exit_code == 0);
  CHECK(read_image(path).width == 24);
}

TEST_CASE("a dash is standard output for a picture, and words go to standard error") {
  const TemporaryFolder folder;
  for (const std::string name : {"-", "/dev/stdout"}) {
    CAPTURE(name);
    const ProcessResult result = run_program(small_output + "-o " + name);
    CHECK(result.exit_code == 0);
    CHECK(result.err.find("Picture        " + name) != std::string::npos);
    write_text(folder.file("a.png"), result.out);
    REQUIRE(run_program(small_output + "-q -o " + quoted(folder.file("b.png"))).exit_code == 0);
    CHECK(read_image(folder.file("a.png")).pixels == read_image(folder.file("b.png")).pixels);
    CHECK(result.out.ends_with("IEND\xae\x42\x60\x82"));
  }
  CHECK(folder.file_count() == 2);
}

TEST_CASE("a dash is standard output for statistics, and words go to standard error") {
  const ProcessResult render = run_program(small_output + "-o /dev/null --stats -");
  CHECK(render.exit_code == 0);
  CHECK(nlohmann::json::parse(render.out)["rays"].contains("camera"));
  CHECK(render.err.find("Picture        /dev/null") != std::string::npos);
  const ProcessResult json = run_program(statistics + "--json -");
  CHECK(json.exit_code == 0);
  CHECK(nlohmann::json::parse(json.out).is_object());
  CHECK_FALSE(json.err.empty());
  const ProcessResult csv = run_program(statistics + "-q --csv -");
  CHECK(csv.exit_code == 0);
  CHECK(std::count(csv.out.begin(), csv.out.end(), '\n') > 3);
  CHECK(csv.err.empty());
}

TEST_CASE("a picture or statistics that a full device does not take end with 1 and a message") {
  const std::string full = "/dev/full: cannot be written: No space left on device\n";
  for (const std::string& arguments :
       {small_output + "-q -o /dev/full", small_output + "-q -o /dev/null --stats /dev/full"}) {
    const ProcessResult result = run_program(arguments);
    CHECK(result.exit_code == 1);
    CHECK(result.err == "twinray: " + full);
  }
  const ProcessResult result = run_program(small_output + "-q -o - >/dev/full");
  CHECK(result.exit_code == 1);
  CHECK(result.err == "twinray: -: cannot be written: No space left on device\n");
  CHECK(fs::is_character_file("/dev/full"));
  CHECK(fs::is_character_file("/dev/null"));
}

TEST_CASE("a picture goes into a FIFO, which stays one") {
  const TemporaryFolder folder;
  const std::string fifo = folder.file("a.exr");
  REQUIRE(mkfifo(fifo.c_str(), 0600) == 0);
  const ProcessResult result =
      run_shell("cat " + quoted(fifo) + " >" + quoted(folder.file("b.exr")) + " & '" TWINRAY_PROGRAM "' " +
                small_output + "-q -o " + quoted(fifo) + " && wait");
  CHECK(result.exit_code == 0);
  CHECK(read_image(folder.file("b.exr")).width == 24);
  CHECK(fs::is_fifo(fifo));
}

TEST_CASE("a scene comes out of a FIFO, which is read once") {
  const TemporaryFolder folder;
  const std::string fifo = folder.file("a.dae"), picture = folder.file("a.exr");
  REQUIRE(mkfifo(fifo.c_str(), 0600) == 0);
  const ProcessResult result =
      run_shell("cat " + quoted(box_scene) + " >" + quoted(fifo) + " & timeout 60 '" TWINRAY_PROGRAM "' " +
                quoted(fifo) + " -r 8 6 -s 1 -q -o " + quoted(picture) + " && wait");
  CHECK(result.exit_code == 0);
  CHECK(read_image(picture).width == 8);
}

TEST_CASE("what would stand beside a picture that is no file is left out, with a warning") {
  const ProcessResult result = run_program(small_output + "-q --integrator=cost -o /dev/null");
  CHECK(result.exit_code == 0);
  CHECK(result.err ==
        "warning: /dev/null is no file: the picture that would stand beside it is not written\n");
}

TEST_CASE("two outputs with one place are an error before rendering") {
  const TemporaryFolder folder;
  const std::string picture = folder.file("a.exr");
  fs::create_symlink("a.exr", folder.path() / "link");
  const std::string endless = box_scene + " -s 1000000 -q ";
  for (const std::string other : {"a.exr", "./a.exr", "link"}) {
    const ProcessResult result =
        run_program(endless + "-o " + quoted(picture) + " --stats " + quoted(folder.file(other)));
    CHECK(result.exit_code == 1);
    CHECK(result.err == fmt::format("twinray: {}: the same place as {}; every output needs its own\n",
                                    folder.file(other), picture));
  }
  CHECK(run_program(endless + "-a 32 0.1 -o " + quoted(picture) + " --stats " +
                    quoted(folder.file("a_rate.png")))
            .exit_code == 1);
  CHECK(run_program(statistics + "--csv - --json -").exit_code == 1);
  // What a render leaves that is stopped would replace what it goes on with.
  for (const auto& [checkpoint, written] :
       {std::pair("a_partial.exr", "a_partial.exr"), std::pair("b", "b.before")}) {
    const ProcessResult result =
        run_program(endless + "-o " + quoted(picture) + " --stats " + quoted(folder.file("b.before")) +
                    " --checkpoint " + quoted(folder.file(checkpoint)));
    CHECK(result.exit_code == 1);
    CHECK(result.err ==
          fmt::format("twinray: --checkpoint={}: {} would be written there, too; choose another name\n",
                      folder.file(checkpoint), folder.file(written)));
  }
  CHECK(folder.file_count() == 1);
}

TEST_CASE("the same command gives the same bytes, and SOURCE_DATE_EPOCH is the only time in them") {
  const TemporaryFolder folder;
  for (const std::string name : {"a.png", "a.exr"}) {
    const std::string path = folder.file(name), command = small_output + "-q -o " + quoted(path);
    REQUIRE(run_program(command, "SOURCE_DATE_EPOCH=1700000000 TZ=Asia/Tokyo").exit_code == 0);
    const std::string dated = read_text(path);
    REQUIRE(run_program(command, "SOURCE_DATE_EPOCH=1700000000").exit_code == 0);
    CHECK(read_text(path) == dated);
    REQUIRE(run_program(command).exit_code == 0);
    CHECK(read_text(path).size() < dated.size());
  }
  CHECK(time_stamp("0") == "1970:01:01 00:00:00");
  CHECK(time_stamp("1700000000") == "2023:11:14 22:13:20");
  const ProcessResult wrong = run_program(small_output + "-q -o /dev/null", "SOURCE_DATE_EPOCH=today");
  CHECK(wrong.exit_code == 1);
  CHECK(wrong.err ==
        "twinray: SOURCE_DATE_EPOCH: \"today\" is not a time; valid are 0 to 253402300799, seconds since "
        "1970\n");
}

TEST_CASE("a cropped EXR says where in its frame it lies") {
  const TemporaryFolder folder;
  REQUIRE(run_program(small_output + "-q -p 5 6 7 8 -o " + quoted(folder.file("a.exr"))).exit_code == 0);
  const std::string text = read_text(folder.file("a.exr"));
  const auto window = [&](const std::string& name) {
    const std::string attribute = name + '\0' + "box2i" + '\0' + '\x10' + std::string(3, '\0');
    std::array<int, 4> found{};
    const std::size_t at = text.find(attribute);
    if (at != std::string::npos) std::memcpy(found.data(), text.data() + at + attribute.size(), sizeof found);
    return found;
  };
  CHECK(window("dataWindow") == std::array{5, 6, 11, 13});
  CHECK(window("displayWindow") == std::array{0, 0, 23, 17});
}

}  // namespace twinray::test
