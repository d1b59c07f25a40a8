// SPDX-License-Identifier: Apache-2.0
#include "core/parallel.h"

#include <atomic>
#include <chrono>
#include <limits>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <vector>

#include "core/denormals.h"
#include "core/threads.h"
#include "tests/support/catch.h"
#include "tests/support/flush_denormals.h"

namespace twinray {
namespace {

using Clock = std::chrono::steady_clock;

/// How many of `expected` parts are inside their bodies at the same time. Each waits until all are there; the
/// patience only bounds how long a failure takes.
int meeting(int expected, const std::function<void(const std::function<void()>&)>& run) {
  constexpr auto patience = std::chrono::seconds(20);
  const auto start = Clock::now();
  std::atomic<int> present{0};
  run([&] {
    ++present;
    while (present < expected && Clock::now() - start < patience) std::this_thread::yield();
  });
  return Clock::now() - start < patience ? present.load() : 0;
}

using test::FlushDenormals;

/// Both a denormal result and a denormal operand.
bool denormals_kept() {
  volatile float smallest = std::numeric_limits<float>::min(), denormal = 1e-40f;
  volatile float result = smallest * 0.5f, product = denormal * 0x1p60f;
  return result > 0 && product > 0;
}

}  // namespace

TEST_CASE("every index is visited once, in parts that depend on count and grain only") {
  for (const int threads : {0, 1, 2, 7}) {
    CAPTURE(threads);
    std::vector<std::atomic<int>> visits(1003);
    std::atomic<bool> as_promised{true};
    parallel_for(visits.size(), 10, threads, [&](std::size_t begin, std::size_t end) {
      if (begin % 10 != 0 || end != std::min<std::size_t>(begin + 10, 1003)) as_promised = false;
      for (std::size_t i = begin; i < end; ++i) ++visits[i];
    });
    CHECK(as_promised);
    CHECK(std::all_of(visits.begin(), visits.end(), [](const auto& count) { return count == 1; }));
  }
}

TEST_CASE("nothing to do, and a grain of zero") {
  parallel_for(0, 10, 2, [](std::size_t, std::size_t) { throw std::logic_error("called"); });
  std::atomic<int> parts{0};
  parallel_for(5, 0, 2, [&](std::size_t begin, std::size_t end) { parts += int(end - begin); });
  CHECK(parts == 5);
}

TEST_CASE("sums made of parts have the same bits with any number of threads") {
  const auto sum = [](int threads) {
    std::vector<float> parts(100);
    parallel_for(10000, 100, threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) parts[begin / 100] += 1.0f / float(i + 1);
    });
    float total = 0;
    for (const float part : parts) total += part;
    return total;
  };
  const float one = sum(1);
  CHECK(sum(2) == one);
  CHECK(sum(7) == one);
}

TEST_CASE("as many threads run as were asked for, more than the machine has too") {
  for (const int threads : {2, 7}) {
    CHECK(meeting(threads, [&](const auto& meet) {
            parallel_for(std::size_t(threads), 1, threads, [&](std::size_t, std::size_t) { meet(); });
          }) == threads);
    CHECK(meeting(threads, [&](const auto& meet) {
            with_threads(threads, [&] {
              parallel_for(std::size_t(threads), 1, 0, [&](std::size_t, std::size_t) { meet(); });
            });
          }) == threads);
  }
}

TEST_CASE("no more threads run than were asked for") {
  for (const int threads : {1, 2, 3}) {
    std::atomic<int> inside{0}, most{0};
    const auto body = [&](std::size_t, std::size_t) {
      const int now = ++inside;
      for (int seen = most; seen < now && !most.compare_exchange_weak(seen, now);) continue;
      std::this_thread::yield();
      --inside;
    };
    parallel_for(2000, 1, threads, body);
    with_threads(threads, [&] { parallel_for(2000, 1, 0, body); });
    CHECK(most <= threads);
  }
}

TEST_CASE("one thread means the calling thread") {
  const auto caller = std::this_thread::get_id();
  std::atomic<int> strangers{0};
  parallel_for(100, 1, 1,
               [&](std::size_t, std::size_t) { strangers += std::this_thread::get_id() != caller; });
  with_threads(1, [&] {
    parallel_invoke([&] { strangers += std::this_thread::get_id() != caller; },
                    [&] { strangers += std::this_thread::get_id() != caller; });
  });
  CHECK(strangers == 0);
}

TEST_CASE("parallel_invoke runs both, and at the same time where there are threads") {
  CHECK(meeting(2, [](const auto& meet) { with_threads(2, [&] { parallel_invoke(meet, meet); }); }) == 2);
}

TEST_CASE("an exception of a part reaches the caller once") {
  for (const int threads : {1, 2, 7}) {
    int caught = 0;
    try {
      parallel_for(1000, 1, threads, [](std::size_t begin, std::size_t) {
        if (begin % 10 == 3) throw std::runtime_error("a part failed");
      });
    } catch (const std::runtime_error& error) {
      ++caught;
      CHECK(std::string(error.what()) == "a part failed");
    }
    CHECK(caught == 1);
  }
  const auto fail = [] { throw std::runtime_error("failed"); };
  CHECK_THROWS_AS(parallel_invoke(fail, [] {}), std::runtime_error);
  CHECK_THROWS_AS(parallel_invoke([] {}, fail), std::runtime_error);
  CHECK_THROWS_AS(parallel_invoke(fail, fail), std::runtime_error);
  CHECK_THROWS_AS(with_threads(3, fail), std::runtime_error);
}

TEST_CASE("denormal numbers are kept in every part, whatever the caller's setting") {
  for (const int threads : {0, 1, 7}) {
    std::atomic<int> flushed{0};
    bool flushed_outside = false, flushed_after = false;
    {
      const FlushDenormals flush;
      flushed_outside = !denormals_kept();
      parallel_for(1000, 1, threads, [&](std::size_t, std::size_t) { flushed += !denormals_kept(); });
      with_threads(threads, [&] { flushed += !denormals_kept(); });
      const auto check = [&] { flushed += !denormals_kept(); };
      parallel_invoke(check, check);
      const KeepDenormals keep;
      check();
    }
    {
      const FlushDenormals flush;
      { const KeepDenormals keep; }
      flushed_after = !denormals_kept();
    }
    CHECK(flushed == 0);
    CHECK(flushed_outside);  // Else this test shows nothing.
    CHECK(flushed_after);
    CHECK(denormals_kept());
  }
}

TEST_CASE("there is a thread, and as many can be made as are asked for") {
  CHECK(available_threads() >= 1);
  for (const int threads : {1, 5, 3}) {
    CHECK(count_threads(threads).wanted == threads);
    CHECK(count_threads(threads).usable == threads);
  }
  CHECK(count_threads(0).usable == available_threads());
}

}  // namespace twinray
