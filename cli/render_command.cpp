// SPDX-License-Identifier: Apache-2.0
#include "cli/render_command.h"

#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "cli/interrupt.h"
#include "cli/progress.h"
#include "cli/render_arguments.h"
#include "cli/report.h"
#include "cli/scene_warnings.h"
#include "cli/version.h"
#include "core/color_scale.h"
#include "core/error.h"
#include "integrators/normals.h"
#include "integrators/path.h"
#include "io/camera_file.h"
#include "io/image_file.h"
#include "io/output_file.h"

namespace twinray {
namespace {

std::unique_ptr<Integrator> make_integrator(const RenderArguments& arguments, const Scene& scene) {
  if (arguments.integrator == IntegratorKind::cost) return std::make_unique<CostIntegrator>(arguments.cost);
  if (arguments.integrator == IntegratorKind::normals) return std::make_unique<NormalsIntegrator>(scene);
  return std::make_unique<PathIntegrator>(scene, arguments.path);
}

void warn(const std::string& text) { fmt::print(stderr, "warning: {}\n", text); }

/// Moves the camera as asked for, or says that another view would show more.
void choose_view(const RenderArguments& arguments, Scene& scene) {
  const Camera fitted = fit_frame(scene.camera, arguments.render.width, arguments.render.height);
  const Aabb& bounds = scene.geometry->bounds();
  if (arguments.view == View::whole)
    scene.camera = view_whole(fitted, bounds);
  else if (!arguments.quiet && !bounds.is_empty() && !sees_whole(fitted, bounds))
    fmt::print("note: part of the scene lies outside of the frame; --view=whole shows all of it\n");
}

LoadedScene load(const RenderArguments& arguments) {
  LoadedScene loaded = load_scene(arguments.scene, arguments.load);
  for (const Diagnostic& warning : loaded.warnings) warn(warning.text());
  if (!arguments.quiet)
    for (const std::string& line : summary_lines(loaded.summary)) fmt::print("{}\n", line);
  if (!arguments.camera_file.empty())
    loaded.scene.camera = load_camera_file(arguments.camera_file, loaded.scene.camera);
  choose_view(arguments, loaded.scene);
  if (!arguments.environment.empty()) {
    auto map = std::make_shared<const Image>(read_image(arguments.environment));
    loaded.scene.lights.push_back({"environment", EnvironmentLight{std::move(map)}});
  }
  for (const std::string& warning : scene_warnings(loaded.scene, arguments)) warn(warning);
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

/// All files that this render writes: the picture first.
std::vector<std::string> output_files(const RenderArguments& arguments) {
  std::vector<std::string> files{arguments.output};
  if (arguments.render.adaptive) files.push_back(rate_path(arguments.output));
  if (arguments.integrator == IntegratorKind::cost) files.push_back(legend_path(arguments.output));
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

void write_outputs(const RenderArguments& arguments, const AccelStats& accel, const RenderResult& result,
                   const ImageMetadata& metadata) {
  if (arguments.integrator == IntegratorKind::cost)
    write_costs(arguments, mean_image(result.film), metadata);
  else
    write_image(arguments.output, mean_image(result.film), arguments.tone_curve, metadata);
  if (arguments.render.adaptive)
    write_png(rate_path(arguments.output), sample_rate_image(result.film, arguments.render.samples),
              metadata);
  if (!arguments.stats_file.empty())
    write_text_file(arguments.stats_file, figures_json(arguments, accel, result));
}

}  // namespace

void render_command(const std::vector<std::string>& words) {
  const std::optional<RenderArguments> parsed = parse_render_arguments(words);
  if (!parsed) return;
  const RenderArguments& arguments = *parsed;
  const InterruptGuard guard(output_files(arguments));
  check_outputs(arguments);
  const LoadedScene loaded = load(arguments);
  const auto accelerator = build_accelerator(arguments.backend, loaded.scene.geometry, arguments.build);
  const auto integrator = make_integrator(arguments, loaded.scene);

  ProgressLine line(!arguments.quiet);
  const RenderResult result = render(loaded.scene, *accelerator, *integrator, arguments.render,
                                     [&](const RenderProgress& progress) { line.show(progress); });
  line.finish();
  if (const std::string rejected = rejection_text(result.film); !rejected.empty()) warn(rejected);
  write_outputs(arguments, accelerator->stats(), result, metadata_of(arguments, words));
  if (!arguments.quiet)
    fmt::print("{}Picture        {}\n", figures_text(accelerator->stats(), result, arguments.render.counting),
               arguments.output);
}

}  // namespace twinray
