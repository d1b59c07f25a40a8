// SPDX-License-Identifier: Apache-2.0
// Loaded before the C library: what happens when the program flushes a file, that is, when all of it is
// written and nothing has been renamed. The environment's AT_SYNC chooses: "fail", as a broken disk does, or
// "interrupt", as Ctrl-C at that very moment.
#include <errno.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>

extern "C" int fsync(int) {
  const char* chosen = getenv("AT_SYNC");
  if (chosen && strcmp(chosen, "interrupt") == 0) raise(SIGINT);
  if (!chosen || strcmp(chosen, "fail") != 0) return 0;
  errno = EIO;
  return -1;
}
