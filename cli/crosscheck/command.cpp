// SPDX-License-Identifier: Apache-2.0
#include "cli/crosscheck/command.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "cli/console.h"
#include "cli/crosscheck/report.h"
#include "cli/progress.h"
#include "io/scene_file.h"

namespace twinray {
namespace {

int check_one_ray(const CrosscheckArguments& arguments, const Scene& scene) {
  const RayCrosscheck result = crosscheck_ray(scene, *arguments.ray, arguments.placement, arguments.options);
  console::write(ray_crosscheck_text(result));
  return std::any_of(result.rows.begin(), result.rows.end(),
                     [](const RayCrosscheck::Row& row) { return row.difference == Difference::unexplained; });
}

int check_scene(const CrosscheckArguments& arguments, const Scene& scene) {
  ProgressLine line = progress_line(!arguments.quiet);
  const auto start = std::chrono::steady_clock::now();
  const SceneCrosscheck result = crosscheck_scene(scene, arguments.options, [&](std::uint64_t done) {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    const double fraction = std::min(1.0, double(done) / double(arguments.options.rays));
    line.show(fmt::format("{:3.0f} % | {:.2f} of {:.2f} M rays | {}, {} left", 100 * fraction,
                          1e-6 * double(done), 1e-6 * double(arguments.options.rays),
                          duration_text(elapsed.count()),
                          duration_text(elapsed.count() * (1 - fraction) / fraction)));
  });
  line.finish();
  const std::string replay = replay_command(arguments.scene, arguments.load, arguments.options.engines);
  console::write(arguments.json ? crosscheck_json(result, arguments.scene, replay, arguments.ceilings)
                                : crosscheck_text(result, replay, arguments.ceilings));
  return is_passed(result.report, arguments.ceilings) ? 0 : 1;
}

}  // namespace

int crosscheck_command(const CrosscheckArguments& arguments) {
  const Scene scene = load_with_warnings(arguments.scene, arguments.load).scene;
  return arguments.ray ? check_one_ray(arguments, scene) : check_scene(arguments, scene);
}

}  // namespace twinray
