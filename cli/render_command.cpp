// SPDX-License-Identifier: Apache-2.0
#include "cli/render_command.h"

#include <fmt/format.h>

#include <memory>

#include "check/render_check.h"
#include "cli/console.h"
#include "cli/crosscheck_report.h"
#include "cli/frame_note.h"
#include "cli/interrupt.h"
#include "cli/no_effect.h"
#include "cli/outputs.h"
#include "cli/picture_metadata.h"
#include "cli/progress.h"
#include "cli/render_command_line.h"
#include "cli/render_outputs.h"
#include "cli/resources.h"
#include "cli/scene_warnings.h"
#include "cli/statistics_report.h"
#include "core/error.h"
#include "core/memory.h"
#include "integrators/normals.h"
#include "integrators/path.h"
#include "io/camera_file.h"
#include "io/environment_file.h"
#include "io/image_file.h"
#include "io/output_file.h"

namespace twinray {
namespace {

std::unique_ptr<Integrator> make_integrator(const RenderArguments& arguments, const Scene& scene) {
  if (arguments.integrator == IntegratorKind::cost) return std::make_unique<CostIntegrator>(arguments.cost);
  if (arguments.integrator == IntegratorKind::normals) return std::make_unique<NormalsIntegrator>(scene);
  return std::make_unique<PathIntegrator>(scene, arguments.path);
}

/// Moves the camera as asked for, or says that another view would show more.
void choose_view(const RenderArguments& arguments, Scene& scene) {
  const Camera fitted = fit_frame(scene.camera, arguments.render.width, arguments.render.height);
  if (arguments.view == View::whole) {
    scene.camera = view_whole(fitted, scene.geometry->bounds());
  } else if (!arguments.quiet) {
    const std::string note = frame_note(fitted, *scene.geometry);
    if (!note.empty()) console::print("note: {}\n", note);
  }
}

EnvironmentLight read_environment(const RenderArguments& arguments) {
  LoadedEnvironment loaded = load_environment(arguments.environment);
  if (!loaded.fault.empty() && !arguments.lenient_environment)
    throw Error(loaded.fault + "; with --lenient-environment such pixels are black");
  if (!loaded.fault.empty()) console::warn(loaded.fault + "; such pixels are black");
  return {std::make_shared<const Image>(std::move(loaded.map))};
}

LoadedScene load(const RenderArguments& arguments) {
  LoadedScene loaded = load_with_warnings(arguments.scene, arguments.load);
  if (!arguments.quiet)
    for (const std::string& line : summary_lines(loaded.summary)) console::print("{}\n", line);
  if (!arguments.camera_file.empty())
    loaded.scene.camera = load_camera_file(arguments.camera_file, loaded.scene.camera);
  choose_view(arguments, loaded.scene);
  if (!arguments.environment.empty())
    loaded.scene.lights.push_back({"environment", read_environment(arguments)});
  const std::vector<std::string> without_effect = options_without_effect(loaded.scene, arguments);
  refuse_if_strict(without_effect, arguments);
  for (const std::string& warning : without_effect) console::warn(warning);
  for (const std::string& warning : scene_warnings(loaded.scene, arguments)) console::warn(warning);
  return loaded;
}

/// The other engine of --accel=check, and what is found.
class Check {
 public:
  Check(const RenderArguments& arguments, const Scene& scene, const Accelerator& accelerator)
      : other_(build_accelerator(arguments.check_with->backend, scene.geometry, arguments.check_with->build)),
        names_{backend_name(arguments.backend), arguments.check_with->name},
        account_(scene.geometry, {.name = names_[0], .accelerator = &accelerator},
                 {.name = names_[1],
                  .accelerator = other_.get(),
                  .is_canonical = arguments.plant_difference || arguments.check_with->is_canonical()},
                 arguments.render) {}

  /// The options of a render whose rays come here.
  RenderOptions observed(RenderOptions options) {
    options.observe = [this](const PixelSample& sample, std::span<const RecordedRay> rays) {
      account_.observe(sample, rays);
    };
    return options;
  }
  Image picture(const Image& rendered) const { return account_.picture(rendered); }
  SceneCrosscheck found(double seconds) const { return {names_, account_.report(), seconds}; }
  /// "camera ray of pixel 3 4, sample 5"
  std::string label(const Finding& finding) const {
    const PixelSample sample = account_.sample_of(finding);
    return fmt::format("{} ray of pixel {} {}, sample {}", ray_class_name(finding.ray_class), sample.x,
                       sample.y, sample.index);
  }

 private:
  std::unique_ptr<const Accelerator> other_;
  std::vector<std::string> names_;
  RenderCheck account_;
};

std::string check_json(const RenderArguments& arguments, const SceneCrosscheck& found) {
  return crosscheck_json(found, arguments.scene, replay_command(arguments.scene, arguments.load),
                         Ceilings::remark);
}

/// Prints the table, and what is wrong; the exit code.
int report(const Check& check, const SceneCrosscheck& found, const RenderArguments& arguments,
           const std::string& differences) {
  const bool is_good = is_passed(found.report, Ceilings::remark);
  if (!arguments.quiet && !differences.empty()) console::print("Differences    {}\n\n", differences);
  if (!arguments.quiet || !is_good)
    console::write(crosscheck_text(found, replay_command(arguments.scene, arguments.load), Ceilings::remark,
                                   [&](const Finding& finding) { return check.label(finding); }));
  return is_good ? 0 : 1;
}

}  // namespace

int render_command(const RenderArguments& asked, const std::vector<std::string>& words) {
  RenderArguments arguments = asked;
  for (const std::string& warning : arguments.without_effect) console::warn(warning);
  check_memory(memory_needs(arguments.render));
  const RenderOutputs outputs = render_outputs(arguments);
  const InterruptGuard guard(outputs.names());
  prepare_outputs(outputs.names());
  if (const std::string fewer = thread_warning(arguments.render.threads); !fewer.empty())
    console::warn(fewer);
  const LoadedScene loaded = load(arguments);
  choose_engine(*loaded.scene.geometry, arguments);
  const ImageMetadata metadata = picture_metadata(arguments, words);
  const auto accelerator = build_accelerator(arguments.backend, loaded.scene.geometry, arguments.build);
  const auto integrator = make_integrator(arguments, loaded.scene);
  std::optional<Check> check;
  if (arguments.check_with) check.emplace(arguments, loaded.scene, *accelerator);

  ProgressLine line = progress_line(!arguments.quiet);
  const RenderResult result = render(loaded.scene, *accelerator, *integrator,
                                     check ? check->observed(arguments.render) : arguments.render,
                                     [&](const RenderProgress& progress) {
                                       if (line.is_due())
                                         line.show(progress_text(progress, line.elapsed_seconds()));
                                     });
  line.finish();
  if (const std::string rejected = rejection_text(result.film); !rejected.empty()) console::warn(rejected);
  std::optional<SceneCrosscheck> found;
  if (check) found = check->found(result.seconds);
  write_pictures(outputs, arguments, result.film, metadata);
  if (!outputs.differences.empty())
    write_image(outputs.differences, check->picture(mean_image(result.film)), metadata);
  if (!outputs.statistics.empty())
    write_file(outputs.statistics, statistics_json(arguments, accelerator->stats(), result,
                                                   found ? check_json(arguments, *found) : ""));
  if (!arguments.quiet)
    console::print("{}Picture        {}\n", statistics_text(arguments, accelerator->stats(), result),
                   arguments.output);
  return check ? report(*check, *found, arguments, outputs.differences) : 0;
}

}  // namespace twinray
