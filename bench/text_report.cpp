// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "bench/reports.h"

namespace twinray::bench {
namespace {

std::string row(const EngineStatistics& engine, std::size_t widest) {
  if (!engine.complaint.empty())
    return fmt::format("{:{}}  NOT TIMED: {}\n", engine.name, widest, engine.complaint);
  const Quartiles all = quartiles(engine.mean_speed());
  std::string text =
      fmt::format("{:{}}  {:6.3f} [{:5.3f} {:5.3f}] ", engine.name, widest, all.median, all.low, all.high);
  for (const TraceStatistics& statistics : engine.trace)
    text += statistics.speed.empty() ? fmt::format(" {:>6} {:>6}", "-", "-")
                                     : fmt::format(" {:6.3f} {:6.2f}", quartiles(statistics.speed).median,
                                                   1e3 / quartiles(statistics.nanoseconds).median);
  return text + fmt::format("  {:8.3f} {:7.1f}\n", quartiles(engine.build.wall_seconds).median,
                            double(engine.build.stats.bytes) /
                                double(std::max<std::size_t>(1, engine.build.stats.primitives)));
}

}  // namespace

std::string text_report(const SceneStatistics& scene) {
  std::size_t widest = 6;
  for (const EngineStatistics& engine : scene.engines) widest = std::max(widest, engine.name.size());
  std::string text =
      fmt::format("{}: {} primitives. Speed against {} [quartiles], and million rays per second\n",
                  scene.name, scene.primitives, scene.engines.front().name);
  text += fmt::format("{:{}}  {:<21}", "engine", widest, "all sets");
  for (const RaySetKind& set : ray_sets) text += fmt::format(" {:^13}", set.title);
  text += fmt::format("  {:>8} {:>7}\n", "build s", "bytes");
  for (const EngineStatistics& engine : scene.engines) text += row(engine, widest);
  return text;
}

std::string text_report(const ReadingStatistics& reading) {
  const Quartiles q = quartiles(reading.seconds);
  return fmt::format("{}: a file of {:.2f} MB is read in {:.4f} s [{:.4f} {:.4f}], {:.0f} MB/s\n",
                     reading.scene, reading.megabytes, q.median, q.low, q.high, reading.megabytes / q.median);
}

std::string text_report(const PictureOfScene& picture) {
  std::string text =
      fmt::format("{}: a picture of {:.0f} samples, CPU seconds on one thread; in it rays alone\n",
                  picture.scene, picture.samples);
  for (const PictureStatistics& engine : picture.engines) {
    const Quartiles speed = quartiles(engine.speed);
    text +=
        fmt::format("{:<20} {:7.3f} s  {:7.3f} s  speed {:.3f} [{:.3f} {:.3f}]  all threads {:.3f} s\n",
                    engine.engine, quartiles(engine.seconds).median, quartiles(engine.replay_seconds).median,
                    speed.median, speed.low, speed.high, quartiles(engine.wall_seconds).median);
  }
  return text;
}

}  // namespace twinray::bench
