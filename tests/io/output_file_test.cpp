// SPDX-License-Identifier: Apache-2.0
#include "io/output_file.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <thread>

#include "io/destination.h"
#include "tests/support/catch.h"
#include "tests/support/file_size_limit.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

namespace fs = std::filesystem;

struct stat file_status(const std::string& path) {
  struct stat status {};
  REQUIRE(stat(path.c_str(), &status) == 0);
  return status;
}

}  // namespace

TEST_CASE("an old file survives where the new one cannot be written to its end") {
  const TemporaryFolder folder;
  const std::string name = folder.file("a");
  write_text(name, "old");
  {
    const FileSizeLimit limit(1000);
    CHECK_THROWS_WITH(write_file(name, std::string(1001, 'x')),
                      fmt::format("{}: cannot be written: File too large", name));
    CHECK(read_text(name) == "old");
    CHECK(folder.file_count() == 1);
    write_file(name, std::string(1000, 'x'));
  }
  CHECK(read_text(name) == std::string(1000, 'x'));
  CHECK(folder.file_count() == 1);
}

TEST_CASE("a file that is written anew keeps its mode and its owner") {
  const TemporaryFolder folder;
  const std::string name = folder.file("a");
  write_text(name, "old");
  if (geteuid() == 0) REQUIRE(chown(name.c_str(), 65534, 65533) == 0);  // Nobody else may give a file away.
  REQUIRE(chmod(name.c_str(), 04751) == 0);
  const struct stat before = file_status(name);
  write_file(name, "new");
  const struct stat after = file_status(name);
  CHECK(read_text(name) == "new");
  CHECK(before.st_ino != after.st_ino);
  CHECK(after.st_mode == before.st_mode);
  CHECK(after.st_uid == before.st_uid);
  CHECK(after.st_gid == before.st_gid);
}

TEST_CASE("a new file has the mode that the umask leaves") {
  const TemporaryFolder folder;
  const mode_t before = umask(027);
  write_file(folder.file("a"), "new");
  umask(before);
  CHECK((file_status(folder.file("a")).st_mode & 07777) == 0640);
}

TEST_CASE("links are followed, to files that are not there yet too") {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "inner");
  fs::create_symlink("inner/b", folder.path() / "link");
  fs::create_symlink(folder.path() / "link", folder.path() / "inner/link");
  for (const std::string text : {"new", "newer"}) {
    check_outputs({folder.file("inner/link")});
    write_file(folder.file("inner/link"), text);
    CHECK(read_text(folder.file("inner/b")) == text);
    CHECK(fs::is_symlink(folder.path() / "link"));
    CHECK(fs::is_symlink(folder.path() / "inner/link"));
    CHECK_FALSE(fs::is_symlink(folder.path() / "inner/b"));
  }
}

TEST_CASE("a device is written into, and stays one") {
  check_outputs({"/dev/full", "/dev/null", "/dev/null"});
  CHECK_NOTHROW(write_file("/dev/null", "bytes"));
  CHECK_THROWS_WITH(write_file("/dev/full", "bytes"),
                    "/dev/full: cannot be written: No space left on device");
  CHECK(fs::is_character_file("/dev/null"));
  CHECK(fs::is_character_file("/dev/full"));
}

TEST_CASE("a FIFO is written into, and its check neither waits for a reader nor disturbs one") {
  const TemporaryFolder folder;
  const std::string name = folder.file("fifo"), text(100000, 'x');
  REQUIRE(mkfifo(name.c_str(), 0600) == 0);
  check_outputs({name});
  std::string read;
  std::thread reader([&] { read = read_text(name); });
  write_file(name, text);
  reader.join();
  CHECK(read == text);
  CHECK(fs::is_fifo(name));
  CHECK(folder.file_count() == 1);
}

TEST_CASE("names of open descriptors stand for them, and - for standard output") {
  for (const std::string name : {"-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"})
    CHECK(is_standard_output(name));
  for (const std::string name : {"/dev/stderr", "/dev/fd/2", "/dev/null", "./-"})
    CHECK_FALSE(is_standard_output(name));
  CHECK(destination_of("/dev/stderr").descriptor == 2);
  CHECK_THROWS_WITH(check_outputs({"/dev/fd/1000"}), "/dev/fd/1000: cannot be written: Bad file descriptor");
  CHECK_THROWS_WITH(check_outputs({"-", "/dev/stdout"}),
                    "/dev/stdout: the same place as -; every output needs its own");
}

TEST_CASE("names that cannot be written are refused with what is wrong, and nothing is left behind") {
  const TemporaryFolder folder;
  const auto message = [&](const std::string& name, const std::string& reason) {
    CHECK_THROWS_WITH(check_outputs({name}), fmt::format("{}: {}", name, reason));
  };
  fs::create_directory(folder.path() / "folder");
  fs::create_symlink("round", folder.path() / "about");
  fs::create_symlink("about", folder.path() / "round");
  write_text(folder.file("file"), "");
  const std::string too_long = "the name is too long; valid are up to 255 bytes, and 4095 with its folders";
  message(folder.file("x/a"), "there is no folder " + folder.file("x"));
  message(folder.file("file/a"), "there is no folder " + folder.file("file"));
  message(folder.file("folder"), "cannot be written: it is a folder");
  message(folder.file("round"), "a link that leads back to itself");
  const std::string long_name(256, 'a');
  message(folder.file(long_name), too_long);
  message(folder.file(long_name) + "/a", too_long);
  CHECK(folder.file_count() == 4);
  CHECK_NOTHROW(write_file(folder.file(std::string(255, 'a')), "as long as a name may be"));
}

TEST_CASE("two outputs with one place are refused") {
  const TemporaryFolder folder;
  const std::string a = folder.file("a");
  fs::create_symlink("a", folder.path() / "link");
  const auto refused = [&](const std::string& name) {
    CHECK_THROWS_WITH(check_outputs({a, folder.file("b"), name}),
                      fmt::format("{}: the same place as {}; every output needs its own", name, a));
  };
  // Before the file is there, and afterwards.
  for (const std::string name : {"a", "./a", "link"}) refused(folder.file(name));
  write_text(a, "old");
  fs::create_hard_link(a, folder.file("hard"));
  for (const std::string name : {"a", "./a", "link", "hard"}) refused(folder.file(name));
  CHECK_NOTHROW(check_outputs({a, folder.file("b"), folder.file("c")}));
  CHECK(read_text(a) == "old");
}

}  // namespace twinray::test
