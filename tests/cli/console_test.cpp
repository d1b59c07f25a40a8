// SPDX-License-Identifier: Apache-2.0
// What the program does when its words cannot be written: the work is done, and the exit code is 1.
#include "cli/console.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "io/picture/image_file.h"
#include "tests/support/catch.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

const std::string small_frame = " -r 24 18 -s 2 ";
const std::string small_box = TWINRAY_SOURCE_DIR "/scenes/box.dae" + small_frame;
/// A scene and options that give a warning, in quiet runs too.
const std::string warned = TWINRAY_SOURCE_DIR "/scenes/lights.dae" + small_frame + "-H -q ";
const std::string box_statistics = "stats " TWINRAY_SOURCE_DIR "/scenes/box.dae -r 8 6 --seconds=0 -q";

std::string to(const std::string& picture) { return "-o '" + picture + "' "; }

bool is_picture(const std::string& path) { return read_image(path).width == 24; }

}  // namespace

TEST_CASE("words lost on a full standard output make the exit code 1, and are missed by a message") {
  const TemporaryFolder folder;
  const std::string message = "twinray: standard output cannot be written: No space left on device\n";
  const std::vector<std::string> commands{"--help ", "crosscheck --help ",
                                          small_box + to(folder.file("a.png")),
                                          "stats " TWINRAY_SOURCE_DIR "/scenes/box.dae -r 8 6 --seconds=0 "};
  for (const std::string& arguments : commands) {
    CAPTURE(arguments);
    const ProcessResult result = run_program(arguments + ">/dev/full");
    CHECK(result.exit_code == 1);
    CHECK(result.err == message);
  }
  CHECK(is_picture(folder.file("a.png")));
}

TEST_CASE("a picture is rendered when standard error cannot be written, and the exit code is 1") {
  const TemporaryFolder folder;
  for (const std::string where : {"2>/dev/full", "2>&-", ">&- 2>&-", "<&- >&- 2>&-"}) {
    CAPTURE(where);
    const std::string picture = folder.file("a.png");
    CHECK(run_program(warned + to(picture) + where).exit_code == 1);
    CHECK(is_picture(picture));
    std::filesystem::remove(picture);
  }
}

TEST_CASE("a file that is opened never becomes a standard stream that was closed") {
  for (const int closed : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    const pid_t child = fork();
    REQUIRE(child >= 0);
    if (child == 0) {
      close(closed);
      console::open();
      _exit(::open("/dev/null", O_RDONLY) > STDERR_FILENO ? 0 : 1);
    }
    int status = -1;
    REQUIRE(waitpid(child, &status, 0) == child);
    CHECK(status == 0);
  }
}

TEST_CASE("a program that has nothing to say needs no standard output or error") {
  const TemporaryFolder folder;
  CHECK(run_program(small_box + "-q " + to(folder.file("a.png")) + "<&- >&- 2>&-").exit_code == 0);
  CHECK(is_picture(folder.file("a.png")));
  CHECK(run_program(box_statistics + ">/dev/full 2>/dev/full").exit_code == 0);
}

TEST_CASE("a usage error keeps its exit code where nobody can be told") {
  CHECK(run_program("--no-such-option 2>&-").exit_code == 2);
  CHECK(run_program("--no-such-option 2>/dev/full").exit_code == 2);
}

TEST_CASE("words to a reader who has gone do not end the program") {
  const TemporaryFolder folder;
  // The pipe's reader ends at once; the program begins a second later.
  const ProcessResult result =
      run_shell("{ sleep 1; '" TWINRAY_PROGRAM "' " + small_box + to(folder.file("a.png")) + "; echo $? >'" +
                folder.file("code") + "'; } | true");
  CHECK(read_text(folder.file("code")) == "1\n");
  CHECK(is_picture(folder.file("a.png")));
  CHECK(result.err == "twinray: standard output cannot be written: Broken pipe\n");
}

}  // namespace twinray::test
