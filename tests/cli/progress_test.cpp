// SPDX-License-Identifier: Apache-2.0
#include "cli/progress.h"

#include "tests/support/catch.h"

namespace twinray {

TEST_CASE("progress says per cent, samples, speed, elapsed and remaining time") {
  const RenderProgress progress{.samples_done = 1500000, .samples_total = 6000000, .rays = 9000000};
  CHECK(progress_text(progress, 30) ==
        " 25 % | 1.5 of 6.0 M samples | 0.30 M rays/s | 30 s, 1 min 30 s left");
  CHECK(progress_text({.samples_done = 4000000, .samples_total = 5000000, .rays = 1000000}, 100) ==
        " 80 % | 4.0 of 5.0 M samples | 0.01 M rays/s | 1 min 40 s, 25 s left");
  CHECK(progress_text({.samples_total = 1000000}, 0) == "  0 % | 0.0 of 1.0 M samples | 0.00 M rays/s | 0 s");
}

TEST_CASE("progress is that of samples or of time, whichever ends the render first") {
  RenderProgress progress{.samples_done = 1000000, .samples_total = 4000000, .seconds_total = 50};
  CHECK(progress_text(progress, 20) == " 40 % | 1.0 M samples | 0.00 M rays/s | 20 s, 30 s left");
  CHECK(progress_text(progress, 60) == "100 % | 1.0 M samples | 0.00 M rays/s | 1 min 0 s, 0 s left");
  progress.seconds_total = 200;
  CHECK(progress_text(progress, 20) == " 25 % | 1.0 of 4.0 M samples | 0.00 M rays/s | 20 s, 1 min 0 s left");
}

TEST_CASE("a render that is resumed has the speed of all its processes, and its time anew") {
  RenderProgress progress{
      .samples_done = 3000000, .samples_total = 4000000, .seconds_before = 50, .rays = 6000000};
  CHECK(progress_text(progress, 10) == " 75 % | 3.0 of 4.0 M samples | 0.10 M rays/s | 10 s, 20 s left");
  progress.seconds_total = 25;
  CHECK(seconds_left(progress, 10) == 15.0);
  CHECK(seconds_left({.samples_total = 4, .seconds_total = 25}, 0) == 25.0);
  CHECK_FALSE(seconds_left({.samples_total = 4}, 5));
}

TEST_CASE("progress towards a noise target says the error that is left") {
  RenderProgress progress{
      .samples_done = 1000000, .samples_total = 4000000, .noise_target = 0.02, .error = {}};
  CHECK(progress_text(progress, 20) == " 25 % | 1.0 of 4.0 M samples | 0.00 M rays/s | 20 s, 1 min 0 s left");
  progress.error = 0.04;
  CHECK(progress_text(progress, 20) ==
        " 25 % | 1.0 of 4.0 M samples | error 0.04, target 0.02 | 0.00 M rays/s | 20 s, 1 min 0 s left");
  progress.error = 0.025;  // The error falls with the root of the samples: 64 % are there.
  CHECK(progress_text(progress, 20) ==
        " 64 % | 1.0 M samples | error 0.025, target 0.02 | 0.00 M rays/s | 20 s, 11 s left");
}

TEST_CASE("durations are read at a glance") {
  CHECK(duration_text(0.4) == "0 s");
  CHECK(duration_text(59.4) == "59 s");
  CHECK(duration_text(59.6) == "1 min 0 s");
  CHECK(duration_text(125) == "2 min 5 s");
  CHECK(duration_text(3840) == "1 h 4 min");
}

}  // namespace twinray
