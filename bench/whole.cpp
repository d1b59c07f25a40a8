// SPDX-License-Identifier: Apache-2.0
#include "bench/whole.h"

#include <benchmark/benchmark.h>

#include <algorithm>

#include "bench/workers.h"
#include "core/image_error.h"
#include "core/parallel.h"
#include "integrators/path.h"
#include "integrators/render.h"

namespace twinray::bench {
namespace {

constexpr int max_depth = 5;
/// The truth has so many times the samples of the best picture.
constexpr std::uint32_t reference_factor = 16;

/// Of each point of an error's curve, at most.
constexpr int error_rounds = 3;

/// A scene with its accelerator and integrator, ready to render.
class Renderable {
 public:
  Renderable(const Scene& scene, std::unique_ptr<Accelerator> accelerator)
      : scene_(scene), accelerator_(std::move(accelerator)), path_(scene, {.max_depth = max_depth}) {}

  RenderResult render(const RenderOptions& options) const {
    return twinray::render(scene_, *accelerator_, path_, options);
  }
  void replay(const std::vector<RecordedRay>& rays) const {
    for (const RecordedRay& entry : rays) {
      if (entry.kind == RayKind::shadow)
        benchmark::DoNotOptimize(accelerator_->any_hit(entry.ray));
      else
        benchmark::DoNotOptimize(accelerator_->closest_hit(entry.ray));
    }
  }

 private:
  const Scene& scene_;
  std::unique_ptr<Accelerator> accelerator_;
  PathIntegrator path_;
};

std::vector<std::unique_ptr<Renderable>> renderables(const Workload& workload) {
  std::vector<std::unique_ptr<Renderable>> all;
  for (const Engine& engine : rendering_engines())
    all.push_back(
        std::make_unique<Renderable>(workload.scene(), workload.build(engine, available_threads())));
  return all;
}

/// The picture whose rays record_rays() gives.
RenderOptions one_sample(const WholeOptions& options, int threads) {
  return {.width = options.width,
          .height = options.height,
          .samples = 1,
          .sampler = SamplerKind::independent,
          .threads = threads};
}

std::vector<double> cpu_of(const std::vector<Seconds>& rounds) {
  std::vector<double> seconds;
  for (const Seconds& round : rounds) seconds.push_back(round.cpu);
  return seconds;
}

std::vector<double> wall_of(const std::vector<Seconds>& rounds) {
  std::vector<double> seconds;
  for (const Seconds& round : rounds) seconds.push_back(round.wall);
  return seconds;
}

/// Each body once a round, after one round to warm up.
Rounds once_a_round(const WholeOptions& options) {
  return {.count = options.rounds, .least_seconds = 1e-6, .clock = Clock::process};
}

}  // namespace

std::vector<Engine> rendering_engines() {
  std::vector<Engine> chosen;
  for (const Engine& engine : engines())
    if (engine.name == "embree-native-default" || engine.name == "embree" || engine.name == "bvh")
      chosen.push_back(engine);
  return chosen;
}

PictureOfScene measure_pictures(const Workload& workload, const WholeOptions& options) {
  const auto scenes = renderables(workload);
  const std::vector<RecordedRay> rays = record_rays(
      workload.scene(), {.width = options.width, .height = options.height, .max_depth = max_depth});
  std::vector<Timed> timed;
  for (const auto& scene : scenes) {
    timed.push_back({"one thread", [&] { scene->render(one_sample(options, 1)); }});
    timed.push_back({"replay", [&] { scene->replay(rays); }});
    timed.push_back({"all threads", [&] { scene->render(one_sample(options, 0)); }});
  }
  const auto results = run_rounds(timed, once_a_round(options));
  PictureOfScene statistics{workload.source().name, double(options.width) * double(options.height), {}};
  const std::vector<Engine> all = rendering_engines();
  for (std::size_t i = 0; i < all.size(); ++i) {
    PictureStatistics engine{
        all[i].name, cpu_of(results[3 * i]), {}, cpu_of(results[3 * i + 1]), wall_of(results[3 * i + 2])};
    for (std::size_t round = 0; round < engine.seconds.size(); ++round)
      engine.speed.push_back(results[0][round].cpu / engine.seconds[round]);
    statistics.engines.push_back(std::move(engine));
  }
  return statistics;
}

std::vector<ErrorStatistics> measure_error(const Workload& workload, const WholeOptions& options) {
  RenderOptions render{.width = options.width / 3, .height = options.height / 3, .seed = 1};
  const auto scenes = renderables(workload);
  render.samples = reference_factor * options.most_samples;
  const Image truth = mean_image(scenes.back()->render(render).film);
  render.seed = 0;
  std::vector<ErrorStatistics> all;
  for (const Engine& engine : rendering_engines())
    all.push_back({workload.source().name, engine.name, reference_factor * options.most_samples, {}});
  WholeOptions few = options;
  few.rounds = std::min(options.rounds, error_rounds);
  for (std::uint32_t samples = 1; samples <= options.most_samples; samples *= 2) {
    render.samples = samples;
    std::vector<double> errors(scenes.size());
    std::vector<Timed> timed;
    for (std::size_t i = 0; i < scenes.size(); ++i)
      timed.push_back({"picture", [&, i] {
                         errors[i] = image_error(mean_image(scenes[i]->render(render).film), truth).relative;
                       }});
    const auto results = run_rounds(timed, once_a_round(few));
    for (std::size_t i = 0; i < scenes.size(); ++i)
      all[i].points.push_back({samples, cpu_of(results[i]), errors[i]});
  }
  return all;
}

void serve_renders(const SceneSource& source, const std::string& engine_name, const WholeOptions& options) {
  const Scene scene = source.make();
  for (const Engine& engine : rendering_engines()) {
    if (engine.name != engine_name) continue;
    BuildOptions build = engine.build;
    build.threads = 1;
    const Renderable renderable(scene, build_accelerator(engine.backend, scene.geometry, build));
    answer_lines([&] { return renderable.render(one_sample(options, 1)).seconds; });
  }
}

std::vector<ScalingStatistics> measure_scaling(const Workload& workload, const WholeOptions& options) {
  const int most = available_threads();
  const double samples = double(options.width) * double(options.height);
  const auto scenes = renderables(workload);
  const std::vector<Engine> all = rendering_engines();
  std::vector<ScalingStatistics> statistics;
  for (std::size_t i = 0; i < all.size(); ++i) {
    WorkerCrew crew(options.worker_command, workload.source().name, all[i].name, most);
    ScalingStatistics scaling{workload.source().name, all[i].name, {}};
    for (int threads = 1; threads <= most; threads = threads < most ? std::min(2 * threads, most) : most + 1)
      scaling.points.push_back({threads, {}, {}});
    for (int round = 0; round < options.rounds; ++round)
      for (ScalingPoint& point : scaling.points) {
        point.rate.push_back(samples / scenes[i]->render(one_sample(options, point.threads)).seconds);
        double sum = 0;
        for (const double seconds : crew.work(point.threads)) sum += samples / seconds;
        point.processes_rate.push_back(sum);
      }
    statistics.push_back(std::move(scaling));
  }
  return statistics;
}

}  // namespace twinray::bench
