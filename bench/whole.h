// SPDX-License-Identifier: Apache-2.0
// Whole pictures: how long they take, what of that are rays, how their error falls, and what threads give.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "bench/timing.h"
#include "bench/workload.h"

namespace twinray::bench {

/// One engine's picture. Lists hold one number a round.
struct PictureStatistics {
  std::string engine;
  std::vector<double> seconds;         ///< CPU time on one thread.
  std::vector<double> speed;           ///< The baseline's time in the same round over this one's.
  std::vector<double> replay_seconds;  ///< CPU time of the same rays without the renderer.
  std::vector<double> wall_seconds;    ///< On all threads.
};

/// A picture of one sample a pixel, five bounces.
struct PictureOfScene {
  std::string scene;
  double samples = 0;  ///< Of all pixels together.
  std::vector<PictureStatistics> engines;
};

struct ErrorPoint {
  std::uint32_t samples = 0;    ///< Per pixel.
  std::vector<double> seconds;  ///< CPU time of all threads, one a round.
  double error = 0;  ///< Root of the mean squared difference in luminance, over the mean luminance.
};
struct ErrorStatistics {
  std::string scene, engine;
  std::uint32_t reference_samples = 0;  ///< Per pixel, of the picture that stands for the truth.
  std::vector<ErrorPoint> points;
};

struct ScalingPoint {
  int threads = 1;
  std::vector<double> rate;  ///< Samples per second of one process with so many threads, one a round.
  std::vector<double> processes_rate;  ///< The sum over so many processes of one thread each.
};
struct ScalingStatistics {
  std::string scene, engine;
  std::vector<ScalingPoint> points;
};

struct WholeOptions {
  int width = 288, height = 216;
  int rounds = 3;
  std::uint32_t most_samples = 256;  ///< Of the error's last point.
  /// Starts a process that answers by serve_renders(); the arguments are the scene's and engine's names.
  std::vector<std::string> worker_command;
};

/// The engines that render: Embree with its own triangles, which is the baseline here, Embree with our leaf,
/// our BVH.
std::vector<Engine> rendering_engines();

PictureOfScene measure_pictures(const Workload& workload, const WholeOptions& options);
/// Of a small picture, for each rendering engine.
std::vector<ErrorStatistics> measure_error(const Workload& workload, const WholeOptions& options);
/// 1, 2, 4, ... threads, and all of the machine; against as many processes.
std::vector<ScalingStatistics> measure_scaling(const Workload& workload, const WholeOptions& options);

/// The other end of a worker: for each line on standard input renders the picture of measure_scaling once on
/// one thread, and prints the seconds.
void serve_renders(const SceneSource& source, const std::string& engine, const WholeOptions& options);

}  // namespace twinray::bench
