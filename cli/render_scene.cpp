// SPDX-License-Identifier: Apache-2.0
#include "cli/render_scene.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "cli/console.h"
#include "cli/default_light.h"
#include "cli/frame_note.h"
#include "cli/light_groups.h"
#include "cli/no_effect.h"
#include "cli/options/render.h"
#include "cli/render_command_line.h"
#include "cli/scene_warnings.h"
#include "cli/shutter.h"
#include "core/error.h"
#include "core/scene_textures.h"
#include "integrators/ambient_occlusion.h"
#include "integrators/furnace.h"
#include "integrators/normals.h"
#include "integrators/path.h"
#include "integrators/path_reference.h"
#include "io/camera_file.h"
#include "io/cs184/camera.h"
#include "io/picture/environment_file.h"
#include "io/picture/texture_store.h"

namespace twinray {
namespace {

constexpr const char* environment_name = "environment";

/// The camera of CS184's program: its frame is that of a camera settings file, or depends on the picture's
/// size.
Camera cs184_camera_of(const RenderArguments& arguments, const Camera& scene_camera) {
  if (!arguments.camera_file.empty()) return load_cs184_camera_file(arguments.camera_file, scene_camera);
  return cs184_frame(scene_camera, arguments.render.width, arguments.render.height);
}

/// The camera as asked for, with a scene of these bounds; says so if another view would show more.
Camera standard_camera_of(const RenderArguments& arguments, const Scene& scene, const Aabb& bounds,
                          RenderTalk& talk) {
  const std::string& file = arguments.camera_file;
  Camera camera = file.empty() ? scene.camera : load_camera_file(file, scene.camera);
  if (!arguments.load.clip_as_file) camera = without_clip(camera);
  const auto [width, height] = std::pair(arguments.render.width, arguments.render.height);
  if (arguments.changes.projection)
    camera = with_projection(camera, *arguments.changes.projection, bounds, double(width) / height);
  const Camera fitted = fit_frame(camera, width, height);
  if (arguments.view == View::whole) {
    const Camera whole = view_whole(fitted, bounds);
    return changed(whole, arguments.changes, whole);
  }
  const std::string note =
      arguments.quiet ? "" : frame_note(changed(fitted, arguments.changes, fitted), *scene.geometry);
  if (!note.empty()) talk.note(note);
  return changed(camera, arguments.changes, fitted);
}

Camera camera_of(const RenderArguments& arguments, const Scene& scene, RenderTalk& talk) {
  if (!is_cs184(arguments)) return standard_camera_of(arguments, scene, scene.geometry->bounds(), talk);
  const Camera camera = cs184_camera_of(arguments, scene.camera);
  return changed(camera, arguments.changes, camera);
}

EnvironmentLight read_environment(const RenderArguments& arguments) {
  LoadedEnvironment loaded = load_environment(arguments.environment);
  if (!loaded.warning.empty()) console::warn(loaded.warning);
  if (!loaded.fault.empty() && !arguments.lenient_environment)
    throw Error(loaded.fault + "; with --lenient-environment such pixels are black");
  if (!loaded.fault.empty()) console::warn(loaded.fault + "; such pixels are black");
  return placed_environment(std::move(loaded.map), arguments.placement, arguments.environment);
}

}  // namespace

namespace {

/// For a scene that asks for light, or is to have it; most have their own.
std::vector<Light> lights_to_add(const RenderArguments& arguments, const LoadedScene& loaded) {
  const bool is_wanted = arguments.default_light != DefaultLight::none || loaded.wants_light;
  if (!is_wanted || (arguments.default_light != DefaultLight::always && is_lit(loaded.scene))) return {};
  return default_lights(loaded.scene.camera);
}

/// The given options that change nothing in the scene, each with the reason.
std::vector<std::string> useless_options(const RenderArguments& arguments, const LoadedScene& loaded,
                                         const std::vector<Light>& added) {
  std::vector<std::string> found = options_without_effect(loaded.scene, arguments, added);
  for (std::string& each : options_without_effect(loaded.summary, arguments))
    found.push_back(std::move(each));
  return found;
}

void add_lights(std::vector<Light> added, const RenderArguments& arguments, LoadedScene& loaded,
                RenderTalk& talk) {
  if (!added.empty() && arguments.default_light == DefaultLight::none && traces_paths(arguments.integrator))
    talk.note("the file has no light: a soft sky, and a light at the camera");
  for (Light& light : added) loaded.scene.lights.push_back(std::move(light));
}

/// The light that load_for_render has added for --environment, the last one of its kind but for a default
/// sky.
const Light& environment_light(const Scene& scene) {
  const auto is_environment = [](const Light& light) {
    return light.name == environment_name && std::holds_alternative<EnvironmentLight>(light.source);
  };
  return *std::find_if(scene.lights.rbegin(), scene.lights.rend(), is_environment);
}

/// Whether the camera stands where the file has it, and not where all of the scene is seen.
bool sees_by_file(const RenderArguments& arguments, const SceneSummary& summary) {
  return !summary.camera.empty() && arguments.view == View::file && arguments.camera_file.empty();
}

}  // namespace

LoadedScene load_for_render(RenderArguments& arguments, RenderTalk& talk) {
  talk.loading();
  if (arguments.texture_bytes)
    arguments.load.textures = std::make_shared<TextureStore>(*arguments.texture_bytes);
  LoadedScene loaded = load_with_warnings(arguments.scene, arguments.load);
  take_defaults(loaded.defaults, arguments);
  arguments.shutter = shutter_of(arguments, loaded);
  if (loaded.summary.animation) loaded.summary.animation->shutter = arguments.shutter;
  if (arguments.samples_per_moment == 0)
    arguments.samples_per_moment = usual_samples_per_moment(*loaded.scene.geometry);
  talk.loaded(loaded.summary);
  if (arguments.shutter && arguments.render.samples <= arguments.samples_per_moment)
    talk.note(
        "all samples of a pixel see the same moment; --time=T,END:N has more moments with fewer samples N");
  loaded.scene.camera = camera_of(arguments, loaded.scene, talk);
  if (arguments.texture_filter) set_filter(loaded.scene.textures, *arguments.texture_filter);
  if (!arguments.environment.empty())
    loaded.scene.lights.push_back({environment_name, read_environment(arguments)});
  std::vector<Light> added = lights_to_add(arguments, loaded);
  const std::vector<std::string> without_effect = useless_options(arguments, loaded, added);
  refuse_if_strict(without_effect, arguments);
  for (const std::string& warning : without_effect) console::warn(warning);
  add_lights(std::move(added), arguments, loaded, talk);
  if (arguments.render.light_groups) group_lights(loaded.scene, arguments.light_groups);
  for (const std::string& warning : scene_warnings(loaded.scene, arguments)) console::warn(warning);
  talk.ready();
  return loaded;
}

LoadedScene load_for_moment(const RenderArguments& arguments, const LoadedScene& first, double time) {
  LoadOptions options = arguments.load;
  options.time = time;
  options.strict = false;  // The first one has been strict.
  options.files = nullptr;
  LoadedScene loaded = load_scene(arguments.scene, options);
  RenderTalk silence;
  loaded.scene.camera =
      sees_by_file(arguments, loaded.summary)
          ? standard_camera_of(arguments, loaded.scene, first.scene.geometry->bounds(), silence)
          : first.scene.camera;
  if (arguments.texture_filter) set_filter(loaded.scene.textures, *arguments.texture_filter);
  if (!arguments.environment.empty()) loaded.scene.lights.push_back(environment_light(first.scene));
  for (Light& light : lights_to_add(arguments, loaded)) loaded.scene.lights.push_back(std::move(light));
  if (arguments.render.light_groups) group_lights(loaded.scene, arguments.light_groups);
  return loaded;
}

std::unique_ptr<Integrator> make_integrator(const RenderArguments& arguments, const Scene& scene) {
  if (arguments.integrator == IntegratorKind::cost) return std::make_unique<CostIntegrator>(arguments.cost);
  if (arguments.integrator == IntegratorKind::normals)
    return std::make_unique<NormalsIntegrator>(
        scene, is_cs184(arguments) ? NormalsIntegrator::Mixture::as_it_is : NormalsIntegrator::Mixture::unit);
  if (arguments.integrator == IntegratorKind::ambient_occlusion)
    return std::make_unique<AmbientOcclusionIntegrator>(scene, float(arguments.occlusion_distance));
  if (arguments.integrator == IntegratorKind::furnace)
    return std::make_unique<FurnaceIntegrator>(scene, arguments.path.max_depth);
  if (arguments.integrator == IntegratorKind::path_reference)
    return std::make_unique<PathReference>(scene, arguments.path);
  return std::make_unique<PathIntegrator>(scene, arguments.path, arguments.render.simd);
}

}  // namespace twinray
