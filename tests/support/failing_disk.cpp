// SPDX-License-Identifier: Apache-2.0
// Preloaded before a program (LD_PRELOAD): a disk on which one thing goes wrong. Of all that happens to files
// whose names have DISK_FILE in them (bytes written, flushed, a name given or changed) the one of number
// DISK_EVENT, from 1 on, is what DISK_DOES says: "fail", as a full disk; "tear", half of it is done and the
// process is killed (as by kill -9); "kill", all of it is done and then the process is killed.
#include <dlfcn.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

enum class Does { nothing, fail, tear, kill };

bool is_watched(const char* name) {
  const char* const part = std::getenv("DISK_FILE");
  return part && name && std::strstr(name, part);
}

bool is_watched(int descriptor) {
  char link[64], name[4096];
  std::snprintf(link, sizeof link, "/proc/self/fd/%d", descriptor);
  const ssize_t length = readlink(link, name, sizeof name - 1);
  if (length < 0) return false;
  name[length] = '\0';
  return is_watched(name);
}

/// What the next event does.
Does next_event() {
  static long events = 0;
  const char* const chosen = std::getenv("DISK_EVENT");
  const char* const does = std::getenv("DISK_DOES");
  if (!chosen || !does || ++events != std::atol(chosen)) return Does::nothing;
  if (std::strcmp(does, "fail") == 0) return Does::fail;
  return std::strcmp(does, "tear") == 0 ? Does::tear : Does::kill;
}

/// Calls the C library's function as what happens says; `half` does a part of it.
template <typename Call, typename Half>
auto happen(bool watched, const Call& call, const Half& half) -> decltype(call()) {
  const Does does = watched ? next_event() : Does::nothing;
  if (does == Does::fail) {
    errno = ENOSPC;
    return -1;
  }
  if (does == Does::tear) half();
  if (does == Does::kill) call();
  if (does == Does::tear || does == Does::kill) raise(SIGKILL);
  return call();
}

template <typename Function>
Function* real(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" ssize_t write(int descriptor, const void* bytes, size_t count) {
  static auto* const call = real<ssize_t(int, const void*, size_t)>("write");
  return happen(
      is_watched(descriptor), [&] { return call(descriptor, bytes, count); },
      [&] { call(descriptor, bytes, count / 2); });
}

extern "C" int fsync(int descriptor) {
  static auto* const call = real<int(int)>("fsync");
  return happen(
      is_watched(descriptor), [&] { return call(descriptor); }, [] {});
}

extern "C" int rename(const char* from, const char* to) noexcept {
  static auto* const call = real<int(const char*, const char*)>("rename");
  return happen(
      is_watched(to), [&] { return call(from, to); }, [] {});
}

extern "C" int link(const char* from, const char* to) noexcept {
  static auto* const call = real<int(const char*, const char*)>("link");
  return happen(
      is_watched(to), [&] { return call(from, to); }, [] {});
}
