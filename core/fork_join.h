// SPDX-License-Identifier: Apache-2.0
// Private: tells the thread sanitizer the order that oneTBB gives to work. The library that Debian ships is
// not compiled with the sanitizer, which would otherwise report all data that one task hands to another.
// Without the sanitizer nothing of this is left.
#pragma once

#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define TWINRAY_THREAD_SANITIZER
#endif
#elif defined(__SANITIZE_THREAD__)
#define TWINRAY_THREAD_SANITIZER
#endif

#ifdef TWINRAY_THREAD_SANITIZER
extern "C" void __tsan_acquire(void* address);
extern "C" void __tsan_release(void* address);
#endif

namespace twinray {

/// Made before the work starts. What happened until then happens before each part, and each part before what
/// follows its end of life; nothing is said about two parts, so that a race between them is still found.
class ForkJoin {
 public:
  ForkJoin() { release(forked_); }
  /// The first and the last thing that a part of the work does.
  class Part {
   public:
    explicit Part(ForkJoin& work) : work_(work) { acquire(work_.forked_); }
    ~Part() { release(work_.joined_); }
    Part(const Part&) = delete;
    Part& operator=(const Part&) = delete;

   private:
    ForkJoin& work_;
  };
  /// When all parts are done, also where one of them threw.
  ~ForkJoin() { acquire(joined_); }
  ForkJoin(const ForkJoin&) = delete;
  ForkJoin& operator=(const ForkJoin&) = delete;

 private:
#ifdef TWINRAY_THREAD_SANITIZER
  static void acquire(char& token) { __tsan_acquire(&token); }
  static void release(char& token) { __tsan_release(&token); }
#else
  static void acquire(char&) {}
  static void release(char&) {}
#endif
  char forked_ = 0, joined_ = 0;
};

}  // namespace twinray
