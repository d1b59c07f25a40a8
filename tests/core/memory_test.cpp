// SPDX-License-Identifier: Apache-2.0
#include "core/memory.h"

#include <unistd.h>

#include <array>
#include <filesystem>

#include "core/error.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

/// A machine of our own: the folder that holds its proc and sys.
class Machine {
 public:
  Machine() {
    write("proc/meminfo",
          "MemTotal:       9000 kB\nMemFree:         100 kB\nMemAvailable:   5000 kB\n"
          "SwapTotal:      2000 kB\nSwapFree:       1000 kB\n");
    write("proc/self/limits",
          "Limit                     Soft Limit           Hard Limit           Units     \n"
          "Max address space         unlimited            unlimited            bytes     \n");
    write("proc/self/statm", "10 5 3 1 0 4 0\n");
    write("proc/self/cgroup", "0::/\n");
  }
  void write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories(std::filesystem::path(folder_.file(name)).parent_path());
    write_text(folder_.file(name), text);
  }
  MemoryLimit limit() const { return available_memory(folder_.file("")); }

 private:
  TemporaryFolder folder_;
};

constexpr std::uint64_t machine_bytes = 6000 * 1024;  // available and swap

}  // namespace

TEST_CASE("the machine has its available memory and its free swap") {
  const MemoryLimit limit = Machine().limit();
  CHECK(limit.bytes == machine_bytes);
  CHECK(limit.name == "the machine");
}

TEST_CASE("what cannot be read limits nothing") {
  const TemporaryFolder nothing;
  CHECK(available_memory(nothing.file("")).bytes == UINT64_MAX);
  const Machine machine;
  machine.write("proc/self/cgroup", "not a group\n0::\n");
  machine.write("sys/fs/cgroup/memory.max", "max\n");
  machine.write("sys/fs/cgroup/memory.current", "1000\n");
  CHECK(machine.limit().bytes == machine_bytes);
}

TEST_CASE("a limit of the address space counts less what is mapped") {
  const Machine machine;
  machine.write("proc/self/limits",
                "Max address space         5000000              unlimited            bytes\n");
  CHECK(machine.limit().bytes == 5000000 - 10 * std::uint64_t(sysconf(_SC_PAGESIZE)));
  CHECK(machine.limit().name == "its address space (ulimit -v)");
  machine.write("proc/self/statm", "100000 5 3 1 0 4 0\n");
  CHECK(machine.limit().bytes == 0);
}

TEST_CASE("a control group of version 2 counts less what is used, and files in memory are left") {
  const Machine machine;
  machine.write("proc/self/cgroup", "0::/user/job\n");
  machine.write("sys/fs/cgroup/user/job/memory.max", "3000000\n");
  machine.write("sys/fs/cgroup/user/job/memory.current", "1000000\n");
  machine.write("sys/fs/cgroup/user/job/memory.stat",
                "anon 5\nfile 9\ninactive_anon 7\nactive_anon 8\ninactive_file 300000\nactive_file 20000\n");
  CHECK(machine.limit().bytes == 2320000);
  CHECK(machine.limit().name == "its control group");
  machine.write("sys/fs/cgroup/user/memory.max", "900000\n");  // the group above allows less
  machine.write("sys/fs/cgroup/user/memory.current", "100000\n");
  CHECK(machine.limit().bytes == 800000);
  machine.write("sys/fs/cgroup/user/memory.current", "1000000\n");
  CHECK(machine.limit().bytes == 0);
}

TEST_CASE("a control group of version 1 is found by its controller, in a container at the mount itself") {
  const Machine machine;
  machine.write("proc/self/cgroup", "9:name=systemd:/\n4:cpu,memory:/docker/123\n3:cpuset:/\n0::/\n");
  machine.write("sys/fs/cgroup/memory/memory.limit_in_bytes", "4000000\n");
  machine.write("sys/fs/cgroup/memory/memory.usage_in_bytes", "2500000\n");
  machine.write("sys/fs/cgroup/memory/memory.stat",
                "inactive_file 1\nactive_file 1\ntotal_inactive_file 300\ntotal_active_file 200\n");
  CHECK(machine.limit().bytes == 1500500);
  machine.write("sys/fs/cgroup/memory/memory.limit_in_bytes", "9223372036854771712\n");  // no limit
  CHECK(machine.limit().bytes == machine_bytes);
}

TEST_CASE("this machine's limit is known") { CHECK(available_memory().bytes < UINT64_MAX); }

TEST_CASE("needs beyond the limit are an error that names each") {
  const std::array<MemoryNeed, 2> needs{{{"the film of 8 x 8 pixels", 4096}, {"the picture", 1'000'000}}};
  CHECK_NOTHROW(check_memory(needs, {1'004'096, "the machine"}));
  CHECK_THROWS_WITH(check_memory(needs, {1'004'095, "the machine"}),
                    "1.0 MB of memory are needed (4.1 kB for the film of 8 x 8 pixels, 1.0 MB for the "
                    "picture); the machine leaves the program 1.0 MB");
  const std::array<MemoryNeed, 1> avoidable{{{"the tree", 1'000'000, "2.0 kB with --small"}}};
  CHECK_THROWS_WITH(
      check_memory(avoidable, {4000, "the machine"}),
      "1.0 MB of memory are needed (1.0 MB for the tree); the machine leaves the program 4.0 kB; "
      "the tree: 2.0 kB with --small");
  const std::array<MemoryNeed, 2> endless{{{"a", UINT64_MAX, {}}, {"b", UINT64_MAX, {}}}};
  CHECK_THROWS_AS(check_memory(endless, {UINT64_MAX - 1, "the machine"}), Error);
}

TEST_CASE("bytes in units of powers of 1000") {
  CHECK(bytes_text(0) == "0 bytes");
  CHECK(bytes_text(999) == "999 bytes");
  CHECK(bytes_text(1000) == "1.0 kB");
  CHECK(bytes_text(999'949) == "999.9 kB");
  CHECK(bytes_text(999'950) == "1.0 MB");
  CHECK(bytes_text(64'000'000'000) == "64.0 GB");
  CHECK(bytes_text(UINT64_MAX) == "18.4 EB");
}

}  // namespace twinray::test
