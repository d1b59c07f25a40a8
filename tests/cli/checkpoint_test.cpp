// SPDX-License-Identifier: Apache-2.0
// Renders that are stopped, and go on, as a user sees them.
#include <fmt/format.h>
#include <signal.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <thread>

#include "io/picture/image_file.h"
#include "tests/support/film_commands.h"
#include "tests/support/sanitizer.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/terminal.h"

namespace twinray::test {
namespace {

namespace fs = std::filesystem;

/// A render that is stopped once it has its first checkpoint; the exit code.
int interrupted(const TemporaryFolder& folder, std::vector<std::string> more, int signal_number) {
  std::vector<std::string> all{box_scene,
                               "-r",
                               "48",
                               "36",
                               "-s",
                               "4000000",
                               "-o",
                               folder.file("a.pfm"),
                               "--checkpoint=" + folder.file("a.ck"),
                               "--checkpoint-seconds=0.01"};
  all.insert(all.end(), more.begin(), more.end());
  TerminalProgram program(all);
  REQUIRE(program.wait_for(" samples |"));
  while (!fs::exists(folder.file("a.ck"))) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  program.send(signal_number);
  const int code = program.exit_code();
  if (signal_number != SIGKILL)
    check_says(program.shown(), "twinray: `twinray resume " + folder.file("a.ck") + "` goes on with it");
  return code;
}

}  // namespace

TEST_CASE("an interrupted render with a checkpoint says to try again, and goes on to the same bits") {
  for (const int signal_number : {SIGTERM, SIGINT, SIGXCPU}) {
    CAPTURE(signal_number);
    const TemporaryFolder folder;
    CHECK(interrupted(folder, {}, signal_number) == 75);
    CHECK(fs::exists(folder.file("a_partial.pfm")));
    CHECK_FALSE(fs::exists(folder.file("a.pfm")));
    const std::uint32_t samples = samples_in(folder.file("a.ck")) + 40;
    run_well(
        fmt::format("resume {} -s {} -t 3 --accel=brute-force -q", quoted(folder.file("a.ck")), samples));
    run_well(box_words(fmt::format("-s {} -o {}", samples, quoted(folder.file("b.pfm")))));
    CHECK(read_text(folder.file("a.pfm")) == read_text(folder.file("b.pfm")));
    CHECK(samples_in(folder.file("a.ck")) == samples);
  }
}

TEST_CASE("a render that was killed goes on from its last checkpoint, or the one before") {
  const TemporaryFolder folder;
  interrupted(folder, {"--layers=albedo,ids", "-o", folder.file("a.exr")}, SIGKILL);
  const std::string film = folder.file("a.ck");
  const std::uint32_t samples = samples_in(film) + 20;
  const std::string resume = fmt::format("resume {} -q -s {}", quoted(film), samples);
  run_well(box_words(fmt::format("-s {} --layers=albedo,ids -o {}", samples, quoted(folder.file("b.exr")))));
  const auto check_bits = [&] {
    CHECK(read_layers(folder.file("a.exr")).values == read_layers(folder.file("b.exr")).values);
  };
  fs::copy(film, folder.file("copy.ck"));
  run_well(resume);
  check_bits();
  // Its last checkpoint is damaged: the one before counts.
  fs::copy(folder.file("copy.ck"), earlier_film_name(film), fs::copy_options::overwrite_existing);
  std::string bytes = read_text(film);
  bytes[bytes.size() / 2] = char(~bytes[bytes.size() / 2]);
  write_text(film, bytes);
  fs::remove(folder.file("a.exr"));
  const ProcessResult result = run_program(resume + " --checkpoint-seconds=1000");
  CHECK(result.exit_code == 0);
  check_says(result.err, film + ": a band of it is damaged; " + film + ".before is taken in its place");
  check_bits();
  CHECK(read_text(earlier_film_name(film)) == read_text(folder.file("copy.ck")));  // The damaged one is gone.
  write_text(film, "wrong");
  write_text(earlier_film_name(film), "wrong, too");
  const std::string both = told_error(resume);
  check_says(both, film + ": this is no film file");
  check_says(both, film + ".before: this is no film file");
  fs::remove(film);
  fs::remove(earlier_film_name(film));
  check_says(told_error(resume), film + ": there is no such file");
}

TEST_CASE("a second signal soon after the first is the same request, but for Ctrl-C") {
  const TemporaryFolder folder;
  const std::string command = fmt::format(
      "cd {}; {} {} -r 48 36 -s 4000000 -t 1 -o a.pfm --checkpoint=a.ck --checkpoint-seconds=1000 "
      "--progress=json 2>errors & "
      "program=$!; until grep -q 'samples_done\":[1-9]' errors; do sleep 0.05; done; ",
      quoted(folder.path().string()), quoted(TWINRAY_PROGRAM), quoted(box_scene));
  const auto code_after = [&](const std::string& signals) {
    return run_shell(command + signals + "; wait $program").exit_code;
  };
  CHECK(code_after("kill -TERM $program; kill -TERM $program; kill -HUP $program") == 75);
  CHECK(fs::exists(folder.file("a.ck")));
  CHECK(read_text(folder.file("errors")).find("goes on with it") != std::string::npos);
}

TEST_CASE(
    "a checkpoint that is there is not replaced without a word, nor taken for written where it is not") {
  const TemporaryFolder folder;
  const std::string words = box_words(
      fmt::format("-s 2 -o {} --checkpoint={}", quoted(folder.file("a.pfm")), quoted(folder.file("a.ck"))));
  run_well(words);
  const ProcessResult again = run_program(words);
  CHECK(again.exit_code == 0);
  check_says(again.err, "warning: " + folder.file("a.ck") +
                            ": the film that is there is replaced; --resume "
                            "goes on with it");
  const ProcessResult failed = run_program(
      box_words(fmt::format("-s 2 -o /dev/null --checkpoint={} --resume", quoted(folder.file("a.ck")))),
      "ASAN_OPTIONS=verify_asan_link_order=0 LD_PRELOAD='" TWINRAY_AT_SYNC "' AT_SYNC=fail");
  CHECK(failed.exit_code == 1);
  check_says(failed.err, "warning: no checkpoint: " + folder.file("a.ck") + ": cannot be written");
}

TEST_CASE("a render without a checkpoint ends as it did, and its film can go on") {
  const TemporaryFolder folder;
  TerminalProgram program(
      {box_scene, "-r", "48", "36", "-s", "4000000", "-t", "1", "-o", folder.file("a.film")});
  REQUIRE(program.wait_for(" samples |"));
  program.send(SIGTERM);
  CHECK(program.exit_code() == 143);
  const std::string partial = folder.file("a_partial.film");
  REQUIRE(fs::exists(partial));
  const std::uint32_t samples = samples_in(partial) + 17;
  check_says(told_error("merge " + quoted(partial) + " -o " + quoted(folder.file("a.pfm"))),
             partial + ": this film is not done; `twinray resume` goes on with it");
  run_well(fmt::format("resume {} -q -s {}", quoted(partial), samples));
  run_well(box_words(fmt::format("-s {} -o {}", samples, quoted(folder.file("b.pfm")))));
  run_well(fmt::format("merge {} -q -o {}", quoted(folder.file("a.film")), quoted(folder.file("a.pfm"))));
  CHECK(read_text(folder.file("a.pfm")) == read_text(folder.file("b.pfm")));
}

TEST_CASE("a film that is interrupted beside its checkpoint is not written twice") {
  const TemporaryFolder folder;
  CHECK(interrupted(folder, {"-o", folder.file("a.film")}, SIGTERM) == 75);
  CHECK(fs::exists(folder.file("a.ck")));
  CHECK_FALSE(fs::exists(folder.file("a_partial.film")));
}

TEST_CASE("a checkpoint of before counts where none can be written any more") {
  const TemporaryFolder folder;
  interrupted(folder, {}, SIGTERM);
  const std::string film = read_text(folder.file("a.ck"));
  TerminalProgram program(
      {"resume", folder.file("a.ck"), "-s", "4000000", "-t", "1", "--checkpoint-seconds=1000"},
      {"ASAN_OPTIONS=verify_asan_link_order=0", "LD_PRELOAD=" TWINRAY_AT_SYNC, "AT_SYNC=fail"});
  REQUIRE(program.wait_for(" samples |"));
  program.send(SIGTERM);
  CHECK(program.exit_code() == 75);
  CHECK(read_text(folder.file("a.ck")) == film);
  check_says(program.shown(), "a_partial.pfm: cannot be written");
  check_says(program.shown(), "goes on with it");
}

TEST_CASE("SIGUSR1 writes a picture of what there is, and the render goes on") {
  const TemporaryFolder folder;
  TerminalProgram program(
      {box_scene, "-r", "48", "36", "-s", "4000000", "-t", "1", "-o", folder.file("a.png")});
  REQUIRE(program.wait_for(" samples |"));
  program.send(SIGUSR1);
  REQUIRE(program.wait_for("note: " + folder.file("a_partial.png") + " holds what there is"));
  CHECK(read_image(folder.file("a_partial.png")).width == 48);
  REQUIRE(program.wait_for(" samples |"));
  program.send(SIGTERM);
  CHECK(program.exit_code() == 143);
}

TEST_CASE("where SIGUSR1's picture cannot be written, or is a film of a checkpoint, the render goes on") {
  const TemporaryFolder folder;
  const auto asked = [&](const std::string& output, const std::vector<std::string>& more) {
    std::vector<std::string> all{box_scene, "-r", "48", "36", "-s",
                                 "4000000", "-t", "1",  "-o", folder.file(output)};
    all.insert(all.end(), more.begin(), more.end());
    auto program = std::make_unique<TerminalProgram>(all);
    REQUIRE(program->wait_for(" samples |"));
    fs::create_directories(folder.file("a_partial.png/full"));
    program->send(SIGUSR1);
    return program;
  };
  const auto blocked = asked("a.png", {});
  REQUIRE(blocked->wait_for("; the render goes on"));
  REQUIRE(blocked->wait_for(" samples |"));
  blocked->send(SIGTERM);
  CHECK(blocked->exit_code() != 0);
  const auto film = asked("b.film", {"--checkpoint=" + folder.file("b.ck")});
  for (int lines = 0; lines < 100 && !fs::exists(folder.file("b.ck")); ++lines)
    REQUIRE(film->wait_for(" samples |"));
  film->send(SIGTERM);
  CHECK(film->exit_code() == 75);
  CHECK_FALSE(fs::exists(folder.file("b_partial.film")));
}

TEST_CASE("a copy of a checkpoint goes on where it is, and by the words that were last said") {
  const TemporaryFolder folder;
  const auto film = [&](const std::string& name) { return quoted(folder.file(name)); };
  run_well(box_words("-s 4 --checkpoint=" + film("a.ck") + " -o " + film("a.pfm")));
  fs::copy(folder.file("a.ck"), folder.file("b.ck"));
  run_well("resume " + film("a.ck") + " -s 9");
  for (int time = 0; time < 3; ++time) run_well("resume " + film("b.ck") + " -s 6 --tone=agx");
  CHECK(samples_in(folder.file("a.ck")) == 9);
  CHECK(samples_in(folder.file("b.ck")) == 6);
  const Words& said = open_film(folder.file("b.ck")).notes.words;
  CHECK(std::count(said.begin(), said.end(), "--tone=agx") == 1);
  run_well("resume " + film("b.ck") + " -s 7");
  CHECK(samples_in(folder.file("b.ck")) == 7);
  // The one before is no other one, however it is called.
  run_well("resume " + film("./b.ck.before") + " -s 8");
  CHECK(samples_in(folder.file("b.ck")) == 8);
  CHECK_FALSE(fs::exists(folder.file("b.ck.before.before")));
  // Also where the folder that it was begun in is gone.
  fs::create_directory(folder.file("run"));
  run_well(box_words("-s 4 --checkpoint=" + film("run/c.ck") + " -o " + film("c.pfm")));
  fs::rename(folder.file("run/c.ck"), folder.file("c.ck"));
  fs::remove_all(folder.file("run"));
  run_well("resume " + film("c.ck") + " -s 5");
  CHECK(samples_in(folder.file("c.ck")) == 5);
}

TEST_CASE("a checkpoint behind a link has its one before beside itself, under either name") {
  const TemporaryFolder folder;
  fs::create_directory(folder.file("far"));
  const std::string link = folder.file("lk"), real = folder.file("far/real.ck");
  fs::create_symlink("far/real.ck", link);
  write_text(folder.file("far/lk.before"), "mine");
  const std::string words =
      box_words(fmt::format("-s 4 -o {} --checkpoint={}", quoted(folder.file("a.pfm")), quoted(link)));
  run_well(words);
  run_well(words);
  CHECK(read_text(folder.file("far/lk.before")) == "mine");
  const std::string before = read_text(real + ".before");
  for (const std::string& name : {link, real}) {
    CAPTURE(name);
    std::string bytes = read_text(real);
    bytes.resize(bytes.size() / 2);
    write_text(real, bytes);
    const ProcessResult result = run_program(fmt::format("resume {} -q", quoted(name)));
    CHECK(result.exit_code == 0);
    check_says(result.err, real + ".before is taken in its place");
    CHECK(fs::is_symlink(link));
    CHECK(samples_in(real) == 4);
    CHECK(read_text(real + ".before") == before);
  }
}

TEST_CASE("a checkpoint replaces films alone") {
  const NoLeakSearch without_leaks;  // For the sandbox.
  const TemporaryFolder folder;
  const std::string notes = folder.file("notes.txt");
  const auto words = [&](const std::string& name) {
    return box_words(
        fmt::format("-s 2 -o {} --checkpoint={}", quoted(folder.file("a.pfm")), quoted(folder.file(name))));
  };
  write_text(notes, "all that I know");
  fs::copy(notes, folder.file("b.ck.before"));
  for (const char* more : {"", " --resume", " --sandbox"}) {
    const std::string error = told_error(words("notes.txt") + more);
    check_says(error, notes);
    check_says(error, "is no film file of this version of the program");
    check_says(told_error(words("b.ck") + more), folder.file("b.ck.before"));
  }
  CHECK(read_text(notes) == "all that I know");
  CHECK(read_text(folder.file("b.ck.before")) == "all that I know");
  CHECK(folder.file_count() == 2);
  // Nothing is lost with an empty file; and a damaged film is still one.
  write_text(folder.file("c.ck"), "");
  run_well(words("c.ck"));
  write_text(folder.file("c.ck"), read_text(folder.file("c.ck")).substr(0, 40));
  for (const char* more : {"", " --sandbox"}) {
    const ProcessResult again = run_program(words("c.ck") + more);
    CHECK(again.exit_code == 0);
    check_says(again.err, "the film that is there is replaced");
  }
}

TEST_CASE("defaults of several words count as none, too") {
  const TemporaryFolder folder;
  const std::string film = quoted(folder.file("a.ck"));
  run_well(box_words("-s 2 --checkpoint=" + film + " -o " + quoted(folder.file("a.pfm"))));
  run_well("resume " + film + " -s 3 --filter=blackman-harris:1.5 --clip=none");
  check_says(told_error("resume " + film + " -s 4 --filter=box"), "it was made without --filter box");
}

}  // namespace twinray::test
