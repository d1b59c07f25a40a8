// SPDX-License-Identifier: Apache-2.0
// Broken files through the reader and the program that users have.
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/broken/broken_files.h"
#include "tests/support/catch.h"
#include "tests/support/collada_text.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

constexpr int is_read = 0, is_refused = 1, took_too_much = 2, threw_otherwise = 3;

std::size_t peak_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024 * std::size_t(usage.ru_maxrss);
}

/// Reads a text, and says what came of it.
int outcome_of(const std::string& text) {
  const std::size_t before = peak_bytes();
  int outcome = is_read;
  try {
    load_collada(text, {.clip_as_file = true});
  } catch (const Error&) {
    outcome = is_refused;
  } catch (...) {
    return threw_otherwise;
  }
  return peak_bytes() - before <= 16 * text.size() + 64'000'000 ? outcome : took_too_much;
}

/// The same in a process of its own, whose most memory is its own: 128 + the signal that ended it.
int outcome_in_child(const std::string& text) {
  const pid_t child = fork();
  if (child == 0) {
    alarm(100);
    _exit(outcome_of(text));
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

TEST_CASE("a broken file is read in memory that goes by its size") {
  for (const BrokenFile& file : broken_files()) {
    INFO(file.name);
    const int outcome = outcome_in_child(file.text);
    CHECK((outcome == is_read || outcome == is_refused));
  }
}

TEST_CASE("memory that does not go by a file's size is noticed") {
  const auto repeated = [](const std::string& text, int times) {
    std::string all;
    for (int i = 0; i < times; ++i) all += text;
    return all;
  };
  // Half a million meshes: legal, and large.
  const std::string library = "<library_nodes><node id=\"a\">" +
                              repeated("<instance_geometry url=\"#shape\"/>", 500) +
                              "</node></library_nodes>";
  const std::string nodes = repeated("<node><instance_node url=\"#a\"/></node>", 1000);
  CHECK(outcome_in_child(collada_text(collada_triangle() + library, nodes)) == took_too_much);
}

TEST_CASE("the program refuses a broken file with 1 and its place, or renders it with a warning") {
  const TemporaryFolder folder;
  const std::string path = folder.file("broken.dae");
  const std::vector<BrokenFile> files = broken_files();
  for (std::size_t i = 0; i < files.size(); ++i) {
    INFO(files[i].name);
    write_text(path, files[i].text);
    const ProcessResult result =
        run_program(fmt::format("'{}' -r 1 1 -s 1 -q -t 1 --clip=file -o /dev/null", path));
    INFO(result.err);
    CHECK((result.exit_code == 0 || result.exit_code == 1));
    CHECK((result.exit_code == 0 || result.err.starts_with("twinray: " + path + ":")));
    CHECK((result.exit_code == 1 || !files[i].must_speak || result.err.starts_with("warning: ")));
  }
}

}  // namespace twinray::test
