// SPDX-License-Identifier: Apache-2.0
// --sandbox, --memory and --time-limit: what a scene of a stranger can reach, and take.
#include <fmt/format.h>
#include <linux/sched.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <functional>
#include <thread>

#include "cli/sandbox/files.h"
#include "cli/sandbox/system_calls.h"
#include "io/picture/image_file.h"
#include "tests/support/catch.h"
#include "tests/support/process.h"
#include "tests/support/sanitizer.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

namespace fs = std::filesystem;

ByteImage gray_picture() { return {2, 2, std::vector<std::uint8_t>(12, 128)}; }

/// In a process of its own: what a sandbox closes stays closed. Its exit code, or 128 + the signal.
int in_a_process(const std::function<int()>& act) {
  const pid_t child = fork();
  if (child == 0) _exit(act());
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// Whether a process can be begun by the call that no filter sees into.
bool begun_by_clone3() {
  clone_args arguments{};
  arguments.exit_signal = SIGCHLD;
  const long process = syscall(SYS_clone3, &arguments, sizeof arguments);
  if (process == 0) _exit(0);
  return process > 0;
}

/// Whether this machine's kernel has Landlock; the tests below then prove that it closes something, and
/// otherwise that its absence is said.
bool has_landlock() {
  static const bool has = in_a_process([] { return close_files({}) ? 0 : 1; }) == 0;
  return has;
}

/// Whether it filters calls.
bool has_filters() {
  static const bool has = in_a_process([] { return close_system_calls(Network::open) ? 0 : 1; }) == 0;
  return has;
}

/// A scene in a folder "scene", and a secret beside it.
class Stranger {
 public:
  Stranger() {
    fs::create_directory(folder_.file("scene"));
    fs::create_directory(folder_.file("out"));
    write_png(folder_.file("secret.png"), gray_picture());
    write_text(folder_.file("secret.pbrt"), "Shape \"sphere\"\n");
  }
  std::string path(const std::string& name) const { return folder_.file(name); }
  std::string picture() const { return path("out/a.png"); }
  /// A sphere, with these lines before it.
  void write_scene(const std::string& lines) const {
    write_text(path("scene/a.pbrt"),
               "LookAt 0 0 5  0 0 0  0 1 0\nCamera \"perspective\"\nWorldBegin\n"
               "LightSource \"infinite\"\n" +
                   lines + "\nShape \"sphere\"\n");
  }
  ProcessResult render(const std::string& more = "--sandbox") const {
    return run_program(fmt::format("render {} -r 8 6 -s 1 -q {} {} -o {}", quoted(path("scene/a.pbrt")),
                                   has_thread_sanitizer ? "-t 1" : "", more, quoted(picture())));
  }

 private:
  NoLeakSearch without_leaks_;
  TemporaryFolder folder_;
};

std::string image_texture(const std::string& file) {
  return fmt::format(
      "Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"{}\"\n"
      "Material \"diffuse\" \"texture reflectance\" \"t\"",
      file);
}

}  // namespace

TEST_CASE("a scene reads its own folder in a sandbox, and the picture is the same") {
  const Stranger stranger;
  write_png(stranger.path("scene/own.png"), gray_picture());
  stranger.write_scene(image_texture("own.png"));
  REQUIRE(stranger.render("").exit_code == 0);
  const Image open = read_image(stranger.picture());
  fs::remove(stranger.picture());
  const ProcessResult closed = stranger.render();
  CHECK(closed.exit_code == 0);
  CHECK((closed.err == "") == (has_landlock() && has_filters()));
  CHECK(read_image(stranger.picture()).pixels == open.pixels);
}

TEST_CASE("no path of a scene leads out of its folder in a sandbox") {
  const Stranger stranger;
  fs::create_symlink(stranger.path("secret.png"), stranger.path("scene/link.png"));
  fs::create_directory_symlink(stranger.path(""), stranger.path("scene/up"));
  std::string to_the_root;  // From a folder of any depth: the root is above itself.
  for (int i = 0; i < 40; ++i) to_the_root += "/..";
  const std::vector<std::string> ways{
      image_texture("../secret.png"),
      image_texture(stranger.path("secret.png")),
      image_texture("link.png"),
      image_texture("up/secret.png"),
      "Include \"../secret.pbrt\"",
      "Include \"/proc/self/environ\"",
      "Include \"/proc/self/root" + stranger.path("secret.pbrt") + "\"",
      "Include \"/proc/self/cwd" + to_the_root + stranger.path("secret.pbrt") + "\"",
      "Include \"/etc/passwd\"",
      "Import \"../secret.pbrt\""};
  for (const std::string& way : ways) {
    CAPTURE(way);
    stranger.write_scene(way);
    const ProcessResult closed = stranger.render();
    // A picture on a surface that cannot be read is shown magenta.
    const bool is_refused = closed.err.find("cannot be opened") != std::string::npos ||
                            closed.err.find("cannot be read: Permission denied") != std::string::npos;
    CHECK(is_refused == has_landlock());
    CHECK((closed.err.find("Landlock") == std::string::npos) == has_landlock());
  }
  stranger.write_scene(image_texture("../secret.png"));
  CHECK(stranger.render("--sandbox=" + quoted(stranger.path(""))).exit_code == 0);
  CHECK(stranger.render("").exit_code == 0);
}

TEST_CASE("what lies above the program stays closed in a sandbox, too") {
  const Stranger stranger;
  fs::create_directory(stranger.path("bin"));
  fs::copy_file(TWINRAY_PROGRAM, stranger.path("bin/twinray"));
  stranger.write_scene("Include \"../secret.pbrt\"");
  const auto render = [&](const char* sandbox) {
    return run_shell(fmt::format("{} render {} -r 8 6 -s 1 -q {} -o {}", quoted(stranger.path("bin/twinray")),
                                 quoted(stranger.path("scene/a.pbrt")), sandbox,
                                 quoted(stranger.path("out/a.exr"))))
        .exit_code;
  };
  CHECK(render("--sandbox") == (has_landlock() ? 1 : 0));
  CHECK(render("") == 0);
  stranger.write_scene("");
  CHECK(render("--sandbox") == 0);  // The library that writes EXR is found.
}

TEST_CASE("checkpoints, films, metrics and layers are written in a sandbox as outside") {
  const Stranger stranger;
  stranger.write_scene("");
  const std::string more = fmt::format(
      "--sandbox --checkpoint={} --checkpoint-seconds=0.001 --metrics-file={} "
      "--stats={} -a 2 0.1",
      quoted(stranger.path("out/a.ck")), quoted(stranger.path("out/a.prom")),
      quoted(stranger.path("out/a.json")));
  for (int i = 0; i < 2; ++i) CHECK(stranger.render(more).exit_code == 0);
  for (const char* name : {"a.png", "a_rate.png", "a.ck", "a.ck.before", "a.prom", "a.json"})
    CHECK(fs::exists(stranger.path(std::string("out/") + name)));
  CHECK(run_program(fmt::format("resume {} -q", quoted(stranger.path("out/a.ck")))).exit_code == 0);
}

TEST_CASE("a page of the picture is served from a sandbox") {
  const Stranger stranger;
  stranger.write_scene("");
  CHECK(stranger.render("--sandbox --serve=127.0.0.1:0").exit_code == 0);
}

TEST_CASE("a picture is verified in a sandbox, with a scene of the places that are named alone") {
  if (has_thread_sanitizer) {
    WARN("not run: the sanitizer has a thread of its own before there is a sandbox");
    return;
  }
  const Stranger stranger;
  write_png(stranger.path("scene/own.png"), gray_picture());
  stranger.write_scene(image_texture("own.png"));
  REQUIRE(stranger.render("").exit_code == 0);
  const auto verify = [&](const std::string& more) {
    return run_program(fmt::format("verify {} --seed=1 {}", quoted(stranger.picture()), more)).exit_code;
  };
  CHECK(verify("") == 0);
  CHECK(verify("--sandbox") == (has_landlock() ? 1 : 0));
  CHECK(verify("--sandbox=" + quoted(stranger.path("scene"))) == 0);
  CHECK(verify("--sandbox --scene=" + quoted(stranger.path("scene/a.pbrt"))) == 0);
  CHECK(verify("--sandbox=/nowhere") == 1);
  fs::create_directory(stranger.path("temporary"));
  const ProcessResult clean = run_shell(
      fmt::format("TMPDIR={} {} verify {} --sandbox={}", quoted(stranger.path("temporary")),
                  quoted(TWINRAY_PROGRAM), quoted(stranger.picture()), quoted(stranger.path("scene"))));
  CHECK(clean.exit_code == 0);
  CHECK(fs::is_empty(stranger.path("temporary")));
  const ProcessResult late =
      run_program(fmt::format("verify {} --time-limit=0.001", quoted(stranger.picture())));
  CHECK(late.exit_code == 142);
  CHECK(late.err == "twinray: the time of --time-limit is over\n");
}

TEST_CASE("a scene that Assimp reads is read in a sandbox, where no process can be begun") {
  const Stranger stranger;
  write_text(stranger.path("scene/a.off"), "OFF\n3 1 0\n0 0 0\n1 0 0\n0 2 0\n3 0 1 2\n");
  CHECK(run_program(fmt::format("render {} -r 8 6 -s 1 -q --sandbox -o {}",
                                quoted(stranger.path("scene/a.off")), quoted(stranger.picture())))
            .exit_code == 0);
}

TEST_CASE("what writes beside the scene, or in another process, does not go with a sandbox") {
  const Stranger stranger;
  stranger.write_scene("");
  CHECK(stranger.render("--sandbox --convert-textures").exit_code == 2);
  CHECK(stranger.render("--sandbox=/nowhere").err.find("--sandbox: there is no file or folder /nowhere") !=
        std::string::npos);
}

TEST_CASE("a closed process opens, makes and removes no other file") {
  const TemporaryFolder folder;
  fs::create_directory(folder.file("read"));
  fs::create_directory(folder.file("write"));
  write_text(folder.file("read/a"), "a");
  write_text(folder.file("write/b"), "b");
  write_text(folder.file("secret"), "c");
  const int code = in_a_process([&] {
    if (!close_files({.read = {folder.file("read")}, .write = {folder.file("write")}, .scratch = {}}))
      return 100;
    if (read_text(folder.file("read/a")) != "a") return 1;
    if (!read_text(folder.file("write/b")).empty()) return 2;
    if (!read_text(folder.file("secret")).empty()) return 3;
    if (access("/bin/sh", X_OK) == 0 && execl("/bin/sh", "sh", "-c", "exit 0", nullptr) == 0) return 4;
    write_text(folder.file("write/new"), "d");
    if (fs::file_size(folder.file("write/new")) != 1) return 5;
    std::error_code error;
    write_text(folder.file("read/new"), "e");
    if (fs::exists(folder.file("read/new"))) return 6;
    if (fs::remove(folder.file("read/a"), error)) return 7;
    fs::rename(folder.file("secret"), folder.file("write/moved"), error);
    if (!error) return 8;
    if (truncate(folder.file("secret").c_str(), 0) == 0) return 9;
    return 0;
  });
  CHECK(code == (has_landlock() ? 0 : 100));
}

TEST_CASE("a closed process starts none, signals none and has no network, and its threads work") {
  const TemporaryFolder folder;
  const int code = in_a_process([&] {
    if (!close_system_calls(Network::closed)) return 100;
    if (fork() >= 0) return 1;
    if (begun_by_clone3()) return 7;
    if (kill(getppid(), 0) == 0) return 2;
    if (run_shell("exit 0").exit_code == 0) return 3;
    if (socket(AF_INET, SOCK_STREAM, 0) >= 0) return 4;
    if (chmod(folder.path().c_str(), 0700) == 0) return 5;
    int value = 0;
    std::thread([&] { value = 7; }).join();
    return value == 7 ? 0 : 6;
  });
  CHECK(code == (has_filters() ? 0 : 100));
  CHECK(in_a_process([] {
          close_system_calls(Network::open);
          return socket(AF_INET, SOCK_STREAM, 0) >= 0 ? 0 : 1;
        }) == 0);
}

TEST_CASE("a render that needs more memory than it may have says so before it begins, or ends in an error") {
  if (has_sanitizer) {
    WARN("not run: the memory of a sanitizer has no bound");
    return;
  }
  const TemporaryFolder folder;
  const std::string box = TWINRAY_SOURCE_DIR "/scenes/box.dae", picture = quoted(folder.file("a.png"));
  const ProcessResult film =
      run_program(fmt::format("render {} -r 8000 6000 -s 1 --memory=200 -o {}", quoted(box), picture));
  CHECK(film.exit_code == 1);
  CHECK(film.err.find("--memory") != std::string::npos);
  const ProcessResult scene =
      run_program(fmt::format("render generated:ball:20000000 -s 1 -q --memory=200 -o {}", picture));
  CHECK(scene.exit_code == 1);
  CHECK(scene.err.find("memory") != std::string::npos);
  CHECK(run_program(fmt::format("render {} -r 8 6 -s 1 -t 2 -q --memory=400 -o {}", quoted(box), picture))
            .exit_code == 0);
}

TEST_CASE("a time limit ends a render like a signal, also while it loads") {
  const TemporaryFolder folder;
  const std::string box = TWINRAY_SOURCE_DIR "/scenes/box.dae", picture = folder.file("a.png");
  const ProcessResult late = run_program(fmt::format(
      "render {} -r 48 36 -s 4000000 -t 1 -q --time-limit=1 -o {}", quoted(box), quoted(picture)));
  CHECK(late.exit_code == 142);
  CHECK(late.err.starts_with("twinray: the time of --time-limit is over; " + folder.file("a_partial.png")));
  const ProcessResult kept =
      run_program(fmt::format("render {} -r 48 36 -s 4000000 -t 1 -q --time-limit=1 --checkpoint={} -o {}",
                              quoted(box), quoted(folder.file("a.ck")), quoted(picture)));
  CHECK(kept.exit_code == 75);
  const ProcessResult loading = run_program(
      fmt::format("render generated:ball:30000000 -s 1 -q --time-limit=0.2 -o {}", quoted(picture)));
  CHECK(loading.exit_code == 142);
  CHECK(loading.err.starts_with("twinray: the time of --time-limit is over; unfinished outputs are removed"));
}

}  // namespace twinray::test
