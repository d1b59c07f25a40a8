// SPDX-License-Identifier: Apache-2.0
#include "cli/render_command.h"

#include <fmt/format.h>

#include <memory>

#include "check/render_check.h"
#include "cli/console.h"
#include "cli/crosscheck_report.h"
#include "cli/interrupt.h"
#include "cli/progress.h"
#include "cli/report.h"
#include "cli/scene_warnings.h"
#include "cli/version.h"
#include "core/error.h"
#include "integrators/normals.h"
#include "integrators/path.h"
#include "io/camera_file.h"
#include "io/color_scale.h"
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
  const Aabb& bounds = scene.geometry->bounds();
  if (arguments.view == View::whole)
    scene.camera = view_whole(fitted, bounds);
  else if (!arguments.quiet && !bounds.is_empty() && !sees_whole(fitted, bounds))
    console::print("note: part of the scene lies outside of the frame; --view=whole shows all of it\n");
}

LoadedScene load(const RenderArguments& arguments) {
  LoadedScene loaded = load_with_warnings(arguments.scene, arguments.load);
  if (!arguments.quiet)
    for (const std::string& line : summary_lines(loaded.summary)) console::print("{}\n", line);
  if (!arguments.camera_file.empty())
    loaded.scene.camera = load_camera_file(arguments.camera_file, loaded.scene.camera);
  choose_view(arguments, loaded.scene);
  if (!arguments.environment.empty()) {
    auto map = std::make_shared<const Image>(read_image(arguments.environment));
    loaded.scene.lights.push_back({"environment", EnvironmentLight{std::move(map)}});
  }
  for (const std::string& warning : scene_warnings(loaded.scene, arguments)) console::warn(warning);
  return loaded;
}

ImageMetadata metadata_of(const RenderArguments& arguments, const std::vector<std::string>& words) {
  std::string options;
  for (const std::string& word : words) options += (options.empty() ? "" : " ") + word;
  return {{"Software", version_name()},
          {"twinray:scene", arguments.scene},
          {"twinray:options", options},
          {"twinray:seed", fmt::format("{}", arguments.render.seed)},
          {"twinray:engine", backend_name(arguments.backend)},
          {"twinray:samples", fmt::format("{}", arguments.render.samples)}};
}

/// "a/b.exr" -> "a/b_rate.png".
std::string rate_path(const std::string& output) {
  return output.substr(0, output.find_last_of('.')) + "_rate.png";
}
std::string legend_path(const std::string& output) {
  return output.substr(0, output.find_last_of('.')) + "_legend.png";
}

std::string differences_path(const std::string& output) {
  return output.substr(0, output.find_last_of('.')) + "_differences.png";
}

/// All files that this render writes: the picture first.
std::vector<std::string> output_files(const RenderArguments& arguments) {
  std::vector<std::string> files{arguments.output};
  if (arguments.render.adaptive) files.push_back(rate_path(arguments.output));
  if (arguments.integrator == IntegratorKind::cost) files.push_back(legend_path(arguments.output));
  if (arguments.check_with) files.push_back(differences_path(arguments.output));
  if (!arguments.stats_file.empty()) files.push_back(arguments.stats_file);
  return files;
}

void check_outputs(const RenderArguments& arguments) {
  check_image_output(arguments.output);
  for (const std::string& file : output_files(arguments)) check_output(file);
}

/// Costs as colours with their legend; EXR keeps the numbers.
void write_costs(const RenderArguments& arguments, const Image& costs, const ImageMetadata& metadata) {
  const std::uint32_t end = scale_end(costs);
  if (is_linear_output(arguments.output))
    write_exr(arguments.output, costs, metadata);
  else
    write_png(arguments.output, scaled_image(costs, end), metadata);
  write_png(legend_path(arguments.output), legend_image(end), metadata);
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
  return crosscheck_json(found, arguments.scene, replay_command(arguments.scene, arguments.load));
}

void write_outputs(const RenderArguments& arguments, const AccelStats& accel, const RenderResult& result,
                   const std::optional<SceneCrosscheck>& found, const ImageMetadata& metadata) {
  if (arguments.integrator == IntegratorKind::cost)
    write_costs(arguments, mean_image(result.film), metadata);
  else
    write_image(arguments.output, mean_image(result.film), metadata);
  if (arguments.render.adaptive)
    write_png(rate_path(arguments.output), sample_rate_image(result.film, arguments.render.samples),
              metadata);
  if (!arguments.stats_file.empty())
    write_text_file(arguments.stats_file,
                    figures_json(arguments, accel, result, found ? check_json(arguments, *found) : ""));
}

/// Prints the table, and what is wrong; the exit code.
int report(const Check& check, const SceneCrosscheck& found, const RenderArguments& arguments) {
  const bool is_good = is_passed(found.report);
  if (!arguments.quiet) console::print("Differences    {}\n\n", differences_path(arguments.output));
  if (!arguments.quiet || !is_good)
    console::write(crosscheck_text(found, replay_command(arguments.scene, arguments.load),
                                   [&](const Finding& finding) { return check.label(finding); }));
  return is_good ? 0 : 1;
}

}  // namespace

int render_command(const RenderArguments& arguments, const std::vector<std::string>& words) {
  const InterruptGuard guard(output_files(arguments));
  check_outputs(arguments);
  const LoadedScene loaded = load(arguments);
  const auto accelerator = build_accelerator(arguments.backend, loaded.scene.geometry, arguments.build);
  const auto integrator = make_integrator(arguments, loaded.scene);
  std::optional<Check> check;
  if (arguments.check_with) check.emplace(arguments, loaded.scene, *accelerator);

  ProgressLine line(!arguments.quiet);
  const RenderResult result = render(loaded.scene, *accelerator, *integrator,
                                     check ? check->observed(arguments.render) : arguments.render,
                                     [&](const RenderProgress& progress) { line.show(progress); });
  line.finish();
  if (const std::string rejected = rejection_text(result.film); !rejected.empty()) console::warn(rejected);
  std::optional<SceneCrosscheck> found;
  const ImageMetadata metadata = metadata_of(arguments, words);
  if (check) {
    found = check->found(result.seconds);
    write_image(differences_path(arguments.output), check->picture(mean_image(result.film)), metadata);
  }
  write_outputs(arguments, accelerator->stats(), result, found, metadata);
  if (!arguments.quiet)
    console::print("{}Picture        {}\n",
                   figures_text(accelerator->stats(), result, arguments.render.counting), arguments.output);
  return check ? report(*check, *found, arguments) : 0;
}

}  // namespace twinray
