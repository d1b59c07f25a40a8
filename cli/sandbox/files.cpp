// SPDX-License-Identifier: Apache-2.0
#include "cli/sandbox/files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/landlock.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>

#include "core/error.h"

namespace twinray {
namespace {

// Rights that later kernels know: headers may not have them yet (Linux's userspace-api/landlock.rst).
constexpr std::uint64_t right_truncate = std::uint64_t(1) << 14;  // From version 3 on.
constexpr std::uint64_t right_device = std::uint64_t(1) << 15;    // ioctl() of devices: version 5.

constexpr std::uint64_t rights_of_version_1 = (LANDLOCK_ACCESS_FS_MAKE_SYM << 1) - 1;
constexpr std::uint64_t reading = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
/// A folder is opened to be flushed.
constexpr std::uint64_t writing = LANDLOCK_ACCESS_FS_WRITE_FILE | LANDLOCK_ACCESS_FS_MAKE_REG |
                                  LANDLOCK_ACCESS_FS_REMOVE_FILE | LANDLOCK_ACCESS_FS_READ_DIR |
                                  right_truncate;
constexpr std::uint64_t rights_of_a_file = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_WRITE_FILE |
                                           LANDLOCK_ACCESS_FS_EXECUTE | right_truncate | right_device;

[[noreturn]] void fail(const char* what) {
  throw Error(fmt::format("--sandbox: {}: {}", what, std::strerror(errno)));
}

/// A descriptor that is closed with it.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return number_; }

 private:
  int number_;
};

/// All rights that the kernel can take away; 0 where it can none.
std::uint64_t known_rights() {
  const long version = syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
  if (version < 1) return 0;
  std::uint64_t rights = rights_of_version_1;
  if (version >= 2) rights |= LANDLOCK_ACCESS_FS_REFER;
  if (version >= 3) rights |= right_truncate;
  if (version >= 5) rights |= right_device;
  return rights;
}

void allow(int rules, const std::string& path, std::uint64_t rights) {
  const Descriptor place(open(path.c_str(), O_PATH | O_CLOEXEC));
  struct stat status {};
  if (place.number() < 0 || fstat(place.number(), &status) != 0) return;
  if (!S_ISDIR(status.st_mode)) rights &= rights_of_a_file;
  const landlock_path_beneath_attr rule{.allowed_access = rights, .parent_fd = place.number()};
  if (syscall(SYS_landlock_add_rule, rules, LANDLOCK_RULE_PATH_BENEATH, &rule, 0) != 0) fail(path.c_str());
}

}  // namespace

bool close_files(const OpenPlaces& places) {
  const std::uint64_t known = known_rights();
  if (known == 0) return false;
  const landlock_ruleset_attr attributes{.handled_access_fs = known};
  const Descriptor rules(int(syscall(SYS_landlock_create_ruleset, &attributes, sizeof attributes, 0)));
  if (rules.number() < 0) fail("Landlock");
  for (const std::string& place : places.read) allow(rules.number(), place, reading & known);
  for (const std::string& place : places.write) allow(rules.number(), place, writing & known);
  for (const std::string& place : places.scratch) allow(rules.number(), place, (reading | writing) & known);
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) fail("no_new_privs");
  if (syscall(SYS_landlock_restrict_self, rules.number(), 0) != 0) fail("Landlock");
  return true;
}

}  // namespace twinray
