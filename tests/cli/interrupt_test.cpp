// SPDX-License-Identifier: Apache-2.0
// What becomes of a render that is interrupted.
#include "cli/interrupt.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <utility>

#include "cli/partial_picture.h"
#include "core/rgb.h"
#include "io/picture/image_file.h"
#include "tests/support/catch.h"
#include "tests/support/own_scenes.h"
#include "tests/support/process.h"
#include "tests/support/sanitizer.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/terminal.h"
#include "tests/support/text.h"

namespace twinray::test {
namespace {

/// A render that would take days, into a file.
std::vector<std::string> endless(const std::string& path, std::vector<std::string> more = {}) {
  std::vector<std::string> words{box_scene, "-r", "48", "36", "-s", "4000000", "-o", path};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// Whether there is a picture of that size that is not all black.
bool is_rendered(const std::string& path) {
  const Image image = read_image(path);
  return image.width == 48 && !std::all_of(image.pixels.begin(), image.pixels.end(), is_black);
}

}  // namespace

TEST_CASE("outputs that belong together go together when a signal ends their writing, but for old ones") {
  using Outputs = InterruptGuard::Outputs;
  for (const Outputs are : {Outputs::apart, Outputs::together}) {
    const TemporaryFolder folder;
    const std::string old = folder.file("old.ply"), added = folder.file("new.ply"),
                      last = folder.file("a.json");
    write_text(old, "as it was");
    const pid_t child = fork();
    if (child == 0) {
      const InterruptGuard guard({old, added, last}, 0, are);
      write_text(added, "finished");
      std::raise(SIGTERM);
      _exit(0);
    }
    int status = 0;
    REQUIRE(waitpid(child, &status, 0) == child);
    CHECK(WEXITSTATUS(status) == 143);
    CHECK(read_text(old) == "as it was");
    CHECK(folder.file_count() == (are == Outputs::together ? 1 : 2));
  }
}

TEST_CASE("Ctrl-C keeps what was rendered, with the samples that it has") {
  for (const std::string ending : {".png", ".exr"}) {
    CAPTURE(ending);
    const TemporaryFolder folder;
    const std::string path = folder.file("a" + ending), partial = folder.file("a_partial" + ending);
    write_text(path, "old");
    TerminalProgram program(endless(path));
    REQUIRE(program.wait_for(" samples |"));
    program.press_control_c();
    CHECK(program.exit_code() == 130);
    CHECK(program.shown().find("twinray: interrupted; " + partial + " holds what there is: ") !=
          std::string::npos);
    CHECK(read_text(path) == "old");
    CHECK(is_rendered(partial));
    CHECK(read_text(partial).find(" of 4000000") != std::string::npos);
    CHECK(folder.file_count() == 2);
  }
}

TEST_CASE("SIGTERM and the end of the terminal keep what was rendered") {
  for (const auto& [signal_number, code] : {std::pair{SIGTERM, 143}, {SIGHUP, 129}}) {
    CAPTURE(signal_number);
    const TemporaryFolder folder;
    TerminalProgram program(endless(folder.file("a.png")));
    REQUIRE(program.wait_for(" samples |"));
    program.send(signal_number);
    CHECK(program.exit_code() == code);
    CHECK(is_rendered(folder.file("a_partial.png")));
    CHECK(folder.file_count() == 1);
  }
}

TEST_CASE("the picture of sample rates is kept beside what was rendered") {
  const TemporaryFolder folder;
  TerminalProgram program(endless(folder.file("a.png"), {"-a", "64", "0"}));
  REQUIRE(program.wait_for(" samples |"));
  program.press_control_c();
  CHECK(program.exit_code() == 130);
  CHECK(read_image(folder.file("a_rate_partial.png")).width == 48);
  CHECK(folder.file_count() == 2);
}

TEST_CASE("Ctrl-C keeps what CS184's program rendered, the rates and a part of the frame too") {
  const TemporaryFolder folder;
  const std::vector<std::string> words{
      "--cs184", box_scene, "-r", "48", "36", "-s", "4000000",           "-a", "64", "0",
      "-p",      "4",       "2",  "30", "20", "-f", folder.file("a.png")};
  TerminalProgram program(words);
  REQUIRE(program.wait_for("Rendering... 0%"));
  program.press_control_c();
  CHECK(program.exit_code() == 130);
  // On a line of its own.
  CHECK(program.shown().find("\r\npathtracer: interrupted; " + folder.file("a_partial.png")) !=
        std::string::npos);
  CHECK(program.shown().find("completed") == std::string::npos);
  CHECK(read_image(folder.file("a_partial.png")).width == 30);
  CHECK(read_image(folder.file("a_rate_partial.png")).width == 48);
  CHECK(read_text(folder.file("a_partial.png")).find(" of 4000000") != std::string::npos);
  CHECK(folder.file_count() == 2);
}

TEST_CASE("a second Ctrl-C ends at once") {
  const TemporaryFolder folder;
  // The second comes while the partial picture is written.
  TerminalProgram program(
      endless(folder.file("a.png")),
      {"ASAN_OPTIONS=verify_asan_link_order=0", "LD_PRELOAD=" TWINRAY_AT_SYNC, "AT_SYNC=interrupt"});
  REQUIRE(program.wait_for(" samples |"));
  program.press_control_c();
  CHECK(program.exit_code() == 130);
  CHECK(program.shown().find("twinray: interrupted; unfinished outputs are removed, old files are as they "
                             "were") != std::string::npos);
  CHECK(folder.file_count() == 0);
}

TEST_CASE("an interruption while the picture is written lets it be written") {
  const TemporaryFolder folder;
  for (const std::string moment : {"AT_WRITE", "AT_SYNC"}) {
    CAPTURE(moment);
    const std::string path = folder.file("a.png");
    write_text(path, "old");
    const ProcessResult result =
        run_program(fmt::format("{} -r 48 36 -s 2 -q -o {}", quoted(box_scene), quoted(path)),
                    "ASAN_OPTIONS=verify_asan_link_order=0 LD_PRELOAD='" TWINRAY_AT_SYNC "' " + moment +
                        "=interrupt-once");
    CHECK(result.exit_code == 0);
    CHECK(result.err == "twinray: interrupted once all samples were there: all outputs are written\n");
    CHECK(is_rendered(path));
    CHECK(folder.file_count() == 1);
  }
}

TEST_CASE("an interruption while the film to go on with is opened says to try again") {
  const TemporaryFolder folder;
  const std::string film = folder.file("a.ck");
  REQUIRE(run_program(fmt::format("{} -r 8 6 -s 2 -q -o {} --checkpoint={}", quoted(box_scene),
                                  quoted(folder.file("a.png")), quoted(film)))
              .exit_code == 0);
  const std::string at_open =
      "ASAN_OPTIONS=verify_asan_link_order=0 LD_PRELOAD='" TWINRAY_AT_SYNC "' AT_OPEN=" + quoted(film);
  const ProcessResult result = run_program("resume " + quoted(film), at_open);
  CHECK(result.exit_code == 75);
  CHECK(result.err == "twinray: ended by a signal\n");
  CHECK(run_program("resume " + quoted(film) + " -q -s 4").exit_code == 0);
}

TEST_CASE("with a checkpoint an interruption before the first sample says to try again: nothing is lost") {
  for (const auto& [checkpoint, code] : {std::pair{"--checkpoint=", 75}, {"--stats=", 143}}) {
    CAPTURE(checkpoint);
    const TemporaryFolder folder;
    const std::string scene = folder.file("scene.dae");
    REQUIRE(mkfifo(scene.c_str(), 0600) == 0);  // Nobody writes into it: loading waits.
    TerminalProgram program(
        {scene, "--progress=json", checkpoint + folder.file("a.ck"), "-o", folder.file("a.png")});
    REQUIRE(program.wait_for("\"loading\""));
    program.send(SIGTERM);
    // The thread sanitizer hands it on when the file is open: it is, though nothing is written there either.
    const int writer = has_thread_sanitizer ? open(scene.c_str(), O_RDWR) : -1;
    CHECK(program.exit_code() == code);
    if (writer >= 0) close(writer);
    CHECK(folder.file_count() == 1);
  }
}

TEST_CASE("under its other name the program ends by a signal under that name, too") {
  TerminalProgram program({"--cs184", box_scene, "-s", "4000000", "-f", "/dev/null"});
  REQUIRE(program.wait_for("Rendering... 0%"));
  program.press_control_c();
  CHECK(program.exit_code() == 130);
  CHECK(program.shown().find("\npathtracer: interrupted") != std::string::npos);
  CHECK(program.shown().find("unfinished outputs") == std::string::npos);
}

TEST_CASE("a picture that has no name has no partial one: Ctrl-C ends at once") {
  TerminalProgram program(endless("/dev/null"));
  REQUIRE(program.wait_for(" samples |"));
  program.press_control_c();
  CHECK(program.exit_code() == 130);
  CHECK(program.shown().find("\ntwinray: interrupted") != std::string::npos);
  CHECK(program.shown().find("_partial") == std::string::npos);
}

TEST_CASE("where the picture goes to a pipe an interruption says that it is not finished") {
  const ProcessResult result =
      run_program(fmt::format("render {} -r 48 36 -s 4000000 -q -o - --time-limit=1", box_scene));
  CHECK(result.exit_code != 0);
  CHECK(result.out.empty());
  CHECK(contains(result.err, "; the output is not finished\n"));
}

TEST_CASE("a partial picture is named like the whole one, and states the samples that its pixels have") {
  const TemporaryFolder folder;
  CHECK(partial_outputs({.picture = folder.file("c.d.exr")}).picture == folder.file("c.d_partial.exr"));
  CHECK(partial_outputs({.picture = folder.file("picture")}).picture == folder.file("picture_partial"));
  const std::string longest(251, 'n');
  CHECK(partial_outputs({.picture = folder.file(longest + ".png")}).picture ==
        folder.file(longest.substr(0, 243) + "_partial.png"));
  Film film(2, 1, {0, 0, 2, 1});
  film.add(0, 0, 0, {1, 1, 1});
  CHECK(sample_range_text(film, 16) == "0 to 1 of 16");
  film.add(1, 0, 0, {1, 1, 1});
  CHECK(sample_range_text(film, 16) == "1 of 16");
  CHECK(sample_range_text(film, Film::max_samples) == "1");
}

}  // namespace twinray::test
