// SPDX-License-Identifier: Apache-2.0
// Loaded before the C library: what happens while the program writes a file, or opens one. The environment's
// AT_WRITE says what does when half of it is written, AT_SYNC what does when it is flushed, that is, when all
// of it is written and nothing has been renamed: "fail", as a broken disk does, "interrupt", as Ctrl-C at
// that very moment, "interrupt-once" at the first such moment alone, "terminate" (SIGTERM) or "kill"
// (SIGKILL). AT_OPEN names a file: SIGTERM comes when a stream opens it.
#include <dlfcn.h>
#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace {

/// Whether what the variable says is a failure; a signal is raised here.
bool fails(const char* variable) {
  const char* chosen = getenv(variable);
  if (!chosen) return false;
  if (strcmp(chosen, "interrupt") == 0) raise(SIGINT);
  static bool is_interrupted = false;
  if (strcmp(chosen, "interrupt-once") == 0 && !is_interrupted) is_interrupted = raise(SIGINT) == 0;
  if (strcmp(chosen, "terminate") == 0) raise(SIGTERM);
  if (strcmp(chosen, "kill") == 0) raise(SIGKILL);
  errno = EIO;
  return strcmp(chosen, "fail") == 0;
}

bool is_output(int descriptor) {
  struct stat status {};
  return descriptor > STDERR_FILENO && fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
}

}  // namespace

extern "C" FILE* fopen64(const char* name, const char* mode) {
  const char* chosen = getenv("AT_OPEN");
  if (chosen && strcmp(chosen, name) == 0) raise(SIGTERM);
  return reinterpret_cast<FILE* (*)(const char*, const char*)>(dlsym(RTLD_NEXT, "fopen64"))(name, mode);
}

extern "C" int fsync(int) { return fails("AT_SYNC") ? -1 : 0; }

extern "C" ssize_t write(int descriptor, const void* bytes, size_t count) {
  if (!is_output(descriptor) || !getenv("AT_WRITE")) return syscall(SYS_write, descriptor, bytes, count);
  static bool is_half_written = false;
  if (is_half_written && fails("AT_WRITE")) return -1;
  is_half_written = true;
  return syscall(SYS_write, descriptor, bytes, (count + 1) / 2);
}
