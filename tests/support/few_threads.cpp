// SPDX-License-Identifier: Apache-2.0
// Preloaded before a program (LD_PRELOAD): a system that lets it have TWINRAY_TEST_THREADS threads at a time
// beside its first, as a limit of processes does (ulimit -u does not bind root).
#include <dlfcn.h>
#include <pthread.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <memory>

namespace {

using Start = void* (*)(void*);
using Create = int (*)(pthread_t*, const pthread_attr_t*, Start, void*);

std::atomic<int> alive{0};

struct Thread {
  Start start;
  void* argument;
};

void* run(void* pointer) {
  const std::unique_ptr<Thread> thread(static_cast<Thread*>(pointer));
  void* result = thread->start(thread->argument);
  --alive;
  return result;
}

int most_threads() {
  const char* text = std::getenv("TWINRAY_TEST_THREADS");
  return text ? std::atoi(text) : 0;
}

}  // namespace

extern "C" int pthread_create(pthread_t* handle, const pthread_attr_t* attributes, Start start,
                              void* argument) {
  static const Create create = reinterpret_cast<Create>(dlsym(RTLD_NEXT, "pthread_create"));
  if (++alive > most_threads()) {
    --alive;
    return EAGAIN;
  }
  auto thread = std::make_unique<Thread>(Thread{start, argument});
  const int error = create(handle, attributes, run, thread.get());
  if (error == 0)
    thread.release();
  else
    --alive;
  return error;
}
