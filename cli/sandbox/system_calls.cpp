// SPDX-License-Identifier: Apache-2.0
#include "cli/sandbox/system_calls.h"

#include <asm/ioctls.h>
#include <fmt/format.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/prctl.h>

#include <cerrno>
#include <cstring>
#include <initializer_list>
#include <memory>

#include "core/error.h"

namespace twinray {
namespace {

using Filter = std::unique_ptr<void, decltype(&seccomp_release)>;

constexpr std::initializer_list<const char*> processes{"execve",
                                                       "execveat",
                                                       "fork",
                                                       "vfork",
                                                       "ptrace",
                                                       "process_vm_readv",
                                                       "process_vm_writev",
                                                       "pidfd_open",
                                                       "pidfd_getfd",
                                                       "pidfd_send_signal",
                                                       "kill",
                                                       "setns",
                                                       "unshare",
                                                       "personality",
                                                       "setuid",
                                                       "setgid",
                                                       "setreuid",
                                                       "setregid",
                                                       "setresuid",
                                                       "setresgid",
                                                       "setgroups",
                                                       "setfsuid",
                                                       "setfsgid",
                                                       "capset",
                                                       "setpgid",
                                                       "setsid",
                                                       "kcmp"};
constexpr std::initializer_list<const char*> the_system{"bpf",
                                                        "perf_event_open",
                                                        "userfaultfd",
                                                        "keyctl",
                                                        "add_key",
                                                        "request_key",
                                                        "mount",
                                                        "umount2",
                                                        "pivot_root",
                                                        "chroot",
                                                        "move_mount",
                                                        "open_tree",
                                                        "fsopen",
                                                        "fsconfig",
                                                        "fsmount",
                                                        "fspick",
                                                        "mount_setattr",
                                                        "init_module",
                                                        "finit_module",
                                                        "delete_module",
                                                        "kexec_load",
                                                        "kexec_file_load",
                                                        "reboot",
                                                        "swapon",
                                                        "swapoff",
                                                        "acct",
                                                        "sethostname",
                                                        "setdomainname",
                                                        "settimeofday",
                                                        "clock_settime",
                                                        "adjtimex",
                                                        "clock_adjtime",
                                                        "iopl",
                                                        "ioperm",
                                                        "name_to_handle_at",
                                                        "open_by_handle_at",
                                                        "quotactl",
                                                        "quotactl_fd",
                                                        "syslog",
                                                        "mknod",
                                                        "mknodat"};
/// Landlock leaves them to anybody who may change the file.
constexpr std::initializer_list<const char*> attributes{
    "chmod",     "fchmodat",    "fchmodat2",    "chown",       "lchown",   "fchownat",
    "utime",     "utimes",      "utimensat",    "futimesat",   "setxattr", "lsetxattr",
    "fsetxattr", "removexattr", "lremovexattr", "fremovexattr"};
/// And rings of calls, which no filter sees.
constexpr std::initializer_list<const char*> connections{
    "socket", "socketpair", "connect",        "bind",           "listen",
    "accept", "accept4",    "io_uring_setup", "io_uring_enter", "io_uring_register",
    "shmget", "shmat",      "msgget",         "semget",         "mq_open"};

void check(int result) {
  if (result < 0)
    throw Error(fmt::format("--sandbox: the kernel's filter of calls: {}", std::strerror(-result)));
}

/// A call that this machine's kernel does not have needs no rule.
template <typename... Conditions>
void deny(const Filter& filter, const char* call, int error, Conditions... conditions) {
  const int number = seccomp_syscall_resolve_name(call);
  if (number == __NR_SCMP_ERROR) return;
  const int result = seccomp_rule_add(filter.get(), SCMP_ACT_ERRNO(std::uint32_t(error)), number,
                                      sizeof...(conditions), conditions...);
  if (result != -EDOM) check(result);  // One of another processor.
}

void deny(const Filter& filter, std::initializer_list<const char*> calls) {
  for (const char* const call : calls) deny(filter, call, EPERM);
}

}  // namespace

bool close_system_calls(Network network) {
  if (prctl(PR_GET_SECCOMP, 0, 0, 0, 0) < 0) return false;
  const Filter filter(seccomp_init(SCMP_ACT_ALLOW), seccomp_release);
  if (!filter) throw Error("--sandbox: the kernel's filter of calls: there is not enough memory");
  deny(filter, processes);
  deny(filter, the_system);
  deny(filter, attributes);
  if (network == Network::closed) deny(filter, connections);
  // Threads may be made, processes not. The flags of clone3 lie where no filter sees them: the C library then
  // takes clone.
  deny(filter, "clone3", ENOSYS);
  deny(filter, "clone", EPERM, SCMP_A0(SCMP_CMP_MASKED_EQ, CLONE_THREAD, 0));
  deny(filter, "prlimit64", EPERM, SCMP_A0(SCMP_CMP_NE, 0));  // 0: the process itself.
  // Characters put into a terminal would be somebody else's command.
  deny(filter, "ioctl", EPERM, SCMP_A1(SCMP_CMP_MASKED_EQ, 0xffffffffu, TIOCSTI));
  deny(filter, "ioctl", EPERM, SCMP_A1(SCMP_CMP_MASKED_EQ, 0xffffffffu, TIOCLINUX));
  check(seccomp_attr_set(filter.get(), SCMP_FLTATR_CTL_NNP, 1));
  const int result = seccomp_load(filter.get());
  if (result == -EINVAL || result == -ENOSYS) return false;
  check(result);
  return true;
}

}  // namespace twinray
