// SPDX-License-Identifier: Apache-2.0
// A table: for each option the circumstances in which it changes nothing.
#include "cli/no_effect.h"

#include <algorithm>
#include <cmath>

#include "cli/default_light.h"
#include "cli/film/saved_film.h"
#include "cli/render_outputs.h"
#include "cli/texture_command.h"
#include "core/light_set.h"
#include "core/scene_textures.h"
#include "integrators/layer_records.h"
#include "io/picture/output_format.h"
#include "io/scene_file.h"

namespace twinray {
namespace {

/// A command line as it was given, and what is made of it.
struct Asked {
  const RenderRequest& request;
  const RenderArguments& arguments;

  bool is_lit() const { return traces_paths(arguments.integrator); }
  bool is_check() const { return arguments.check_with.has_value(); }
  bool has(Backend backend) const {
    return (!arguments.is_auto && arguments.backend == backend) ||
           (is_check() && arguments.check_with->backend == backend);
  }
  /// "the engine is embree"
  std::string engine() const {
    return arguments.is_auto ? "--accel=auto chooses the engine and its options"
                             : "the engine is " + backend_name(arguments.backend);
  }
  bool is_wide() const { return has(Backend::bvh) && arguments.build.bvh_width == 8; }
  /// That of Möller and Trumbore's test is binary.
  bool is_of_its_own() const { return arguments.build.triangle_test == TriangleTest::moller_trumbore; }
  const BuildOptions& build() const { return arguments.build; }
};

/// Why the option changes nothing; empty where it may change something.
using Reason = std::string (*)(const Asked&);

struct Rule {
  const char* option;
  Reason reason;
};

std::string needs_light(const Asked& asked) {
  return asked.is_lit() ? ""
                        : fmt::format("for --integrator={} does not ask for the scene's light",
                                      integrator_name(asked.arguments.integrator));
}

std::string needs_materials(const Asked& asked) {
  const IntegratorKind kind = asked.arguments.integrator;
  return kind == IntegratorKind::normals || kind == IntegratorKind::cost
             ? fmt::format("for --integrator={} does not ask for the scene's materials",
                           integrator_name(kind))
             : "";
}

std::string needs_environment(const Asked& asked) {
  return asked.arguments.environment.empty() ? "for there is no --environment" : needs_light(asked);
}

std::string needs_collada(const Asked& asked) {
  return is_collada(asked.arguments.scene) ? "" : "for the scene is no COLLADA file";
}

std::string needs_fall_off(const Asked& asked) {
  if (asked.arguments.load.interpretation == Interpretation::cs184)
    return "for point lights do not fall off in CS184's program";
  const std::string reason = needs_collada(asked);
  return reason.empty() ? needs_light(asked) : reason;
}

std::string needs_light_layers(const Asked& asked) {
  return asked.arguments.render.light_groups ? "" : "for --layers does not name light-groups";
}

std::string needs_denoised_groups(const Asked& asked) {
  if (asked.arguments.replay) return "for --replay renders no picture";
  if (!asked.arguments.denoiser) return "for nothing is denoised; --denoise does it";
  return needs_light_layers(asked);
}

std::string needs_exr(const Asked& asked) {
  return keeps_layers(asked.arguments.output) ? "" : "for the picture's name does not end in .exr";
}

std::string needs_direct_light(const Asked& asked) {
  if (!asked.is_lit()) return needs_light(asked);
  return asked.arguments.path.max_depth > 0 ? "" : "for --max-depth=0 leaves the light of emitters alone";
}

std::string needs_more_bounces(const Asked& asked) {
  if (asked.arguments.integrator == IntegratorKind::furnace) return "";
  if (!asked.is_lit()) return needs_light(asked);
  if (asked.request.arguments.path.max_depth <= 1) return "";
  if (asked.arguments.integrator == IntegratorKind::direct)
    return "for --integrator=direct ends paths after one bounce";
  return asked.request.bounces == RenderRequest::Bounces::direct
             ? "for --bounces=direct shows light of one bounce"
             : "";
}

std::string needs_indirect_light(const Asked& asked) {
  if (!asked.is_lit()) return needs_light(asked);
  const bool has_any = asked.arguments.path.depth_limit() >= 2;
  return has_any ? "" : "for light of one bounce is left as it is";
}

/// Whether paths end after one bounce, whatever depth the scene states.
bool is_direct_alone(const Asked& asked) {
  return asked.arguments.integrator == IntegratorKind::direct ||
         asked.request.bounces == RenderRequest::Bounces::direct;
}

/// Of a number of bounces of one kind. A scene may state the depth, too.
std::string needs_longer_paths(const Asked& asked, int BounceLimits::*limit) {
  if (!asked.is_lit()) return needs_light(asked);
  const bool is_of_scene = has_defaults(asked.arguments.scene) && !is_given("--max-depth", asked.arguments);
  if (is_of_scene && !is_direct_alone(asked)) return "";
  const PathOptions& path = asked.arguments.path;
  return path.limits.*limit + 1 < path.depth_limit()
             ? ""
             : fmt::format("for paths of {} bounces make no more", path.depth_limit());
}

std::string needs_roulette(const Asked& asked) {
  if (!asked.is_lit()) return needs_light(asked);
  const PathOptions& path = asked.arguments.path;
  const int at_risk = path.roulette.continuation > 0 ? 2 : 4;
  const int depth = std::min(path.max_depth, path.last_depth);
  return depth > at_risk ? "" : fmt::format("for paths of {} bounces end before it decides", depth);
}

std::string needs_bounces(const Asked& asked) {
  if (!asked.is_lit()) return needs_light(asked);
  const PathOptions& path = asked.arguments.path;
  if (asked.request.bounces == RenderRequest::Bounces::direct && path.max_depth < 2)
    return "for no other light than direct light is computed";
  return "";
}

std::string needs_batches(const Asked& asked) {
  if (asked.arguments.replay) return "for --replay renders no picture";
  const RenderOptions& render = asked.arguments.render;
  return render.samples > render.adaptive->batch ? ""
                                                 : fmt::format("for a batch of {} is all of the {} samples",
                                                               render.adaptive->batch, render.samples);
}

std::string needs_scene_camera(const Asked& asked) {
  const RenderArguments& arguments = asked.arguments;
  const bool is_list = arguments.load.camera_name == "?";
  return arguments.camera_file.empty() || is_list ? "" : "for --camera's file is the camera";
}

std::string needs_clipped_view(const Asked& asked) {
  const bool is_of_file = !asked.arguments.changes.clip;
  return is_of_file && asked.arguments.view == View::whole ? "for --view=whole leaves no clip distances" : "";
}

std::string needs_occlusion(const Asked& asked) {
  return asked.arguments.integrator == IntegratorKind::ambient_occlusion
             ? ""
             : "for --integrator=ambient-occlusion alone looks around";
}

std::string needs_cost(const Asked& asked) {
  return asked.arguments.integrator == IntegratorKind::cost ? "" : "for --integrator=cost alone shows costs";
}

std::string needs_check(const Asked& asked) {
  return asked.is_check() ? "" : "for nothing is checked; --accel=check takes it";
}

std::string needs_bvh(const Asked& asked) {
  return asked.has(Backend::bvh) ? "" : fmt::format("for {}; --accel=bvh takes it", asked.engine());
}

std::string needs_wide(const Asked& asked) {
  if (!asked.has(Backend::bvh)) return needs_bvh(asked);
  return asked.is_wide() ? "" : "for the bvh is binary; --bvh-width=8 takes it";
}

std::string needs_choice_of_width(const Asked& asked) {
  if (const std::string reason = needs_bvh(asked); !reason.empty()) return reason;
  return asked.is_of_its_own() ? "for the tree of --triangle-test=moller-trumbore is binary" : "";
}

std::string needs_own_builder(const Asked& asked) {
  if (!asked.has(Backend::bvh)) return needs_bvh(asked);
  return asked.build().bvh_builder == BvhBuilder::own
             ? ""
             : fmt::format("for the builder is {}", builder_name(asked.build().bvh_builder));
}

std::string needs_sah(const Asked& asked) {
  if (const std::string reason = needs_own_builder(asked); !reason.empty()) return reason;
  return asked.build().bvh_split == BvhSplit::sah ? "" : "for --bvh-split=sah alone has bins";
}

std::string needs_replay(const Asked& asked) {
  return asked.arguments.replay ? "" : "for there is no --replay";
}

std::string needs_picture(const Asked& asked) {
  return asked.arguments.replay ? "for --replay renders no picture" : "";
}

std::string needs_samples_for_target(const Asked& asked) {
  const RenderOptions& render = asked.arguments.render;
  if (render.samples > least_samples_of_target) return needs_picture(asked);
  return fmt::format("for it ends a render after {} samples or more, and {} are asked for",
                     least_samples_of_target, render.samples);
}

std::string needs_more_than_pilot(const Asked& asked) {
  const RenderOptions& render = asked.arguments.render;
  if (render.allocation == Allocation::even || render.samples > SampleAllocation::pilot) return "";
  return fmt::format("for the first {} samples are even, and {} are asked for", SampleAllocation::pilot,
                     render.samples);
}

std::string needs_checkpoint(const Asked& asked) {
  return asked.arguments.checkpoint.empty() ? "for there is no --checkpoint" : "";
}

std::string needs_display(const Asked& asked) {
  const RenderArguments& arguments = asked.arguments;
  if (arguments.replay) return "for --replay renders no picture";
  if (!is_film_name(arguments.output) && is_linear(output_format(arguments.output)))
    return fmt::format("for {} keeps the scene's light", arguments.output);
  return arguments.integrator == IntegratorKind::cost ? "for --integrator=cost shows no light" : "";
}

/// Whether camera rays or paths are made in lanes. A scene may have another number of samples.
bool makes_samples_in_lanes(const Asked& asked) {
  const RenderArguments& arguments = asked.arguments;
  if (arguments.replay) return false;
  const bool is_wave =
      arguments.integrator == IntegratorKind::path || arguments.integrator == IntegratorKind::direct;
  return is_wave || arguments.render.samples > 1 || has_defaults(arguments.scene);
}

std::string needs_lanes(const Asked& asked) {
  if (asked.arguments.is_auto || asked.is_wide() || asked.has(Backend::embree)) return "";
  if (makes_samples_in_lanes(asked)) return "";
  return asked.arguments.replay
             ? "for neither --replay nor the engine has code for it; embree, and bvh of width 8, have"
             : fmt::format("for neither the engine nor one sample a pixel of --integrator={} has code for it",
                           integrator_name(asked.arguments.integrator));
}

std::string needs_native(const Asked& asked) {
  return asked.has(Backend::embree_native) ? "" : "for --accel=embree-native alone has modes";
}

std::string needs_embree(const Asked& asked) {
  return asked.has(Backend::embree) || asked.has(Backend::embree_native)
             ? ""
             : fmt::format("for {}", asked.engine());
}

std::string needs_counts(const Asked& asked) {
  if (asked.arguments.replay) return "for --replay renders no picture";
  return asked.arguments.backend == Backend::embree_native ? "for embree-native does not count" : "";
}

constexpr Rule rules[]{
    {"--cost", needs_cost},
    {"--ao-distance", needs_occlusion},
    {"--max-depth", needs_more_bounces},
    {"--bounces", needs_bounces},
    {"--diffuse-bounces",
     [](const Asked& asked) { return needs_longer_paths(asked, &BounceLimits::diffuse); }},
    {"--glossy-bounces", [](const Asked& asked) { return needs_longer_paths(asked, &BounceLimits::glossy); }},
    {"--transmission-bounces",
     [](const Asked& asked) { return needs_longer_paths(asked, &BounceLimits::transmission); }},
    {"--roulette", needs_roulette},
    {"--clamp", needs_indirect_light},
    {"--regularize", needs_indirect_light},
    {"--direct", needs_direct_light},
    {"--hemisphere", needs_direct_light},
    {"--light-samples", needs_direct_light},
    {"--many-lights", needs_direct_light},
    {"--environment", needs_light},
    {"--environment-layout", needs_environment},
    {"--environment-rotation", needs_environment},
    {"--environment-scale", needs_environment},
    {"--attenuation", needs_fall_off},
    {"--default-light", needs_light},
    {"--keep-both-lamps", needs_collada},
    {"--texture-filter", needs_materials},
    {"--clip", needs_clipped_view},
    {"--camera-name", needs_scene_camera},
    {"--output", needs_picture},
    {"--crop", needs_picture},
    {"--overscan", needs_picture},
    {"--layers", needs_picture},
    {"--exposure", needs_display},
    {"--white-balance", needs_display},
    {"--tone", needs_display},
    {"--ocio-view", needs_display},
    {"--light-group", needs_light_layers},
    {"--exr-compression", needs_exr},
    {"--stats", needs_picture},
    {"--tev", needs_picture},
    {"--serve", needs_picture},
    {"--progress", needs_picture},
    {"--metrics-file", needs_picture},
    {"--time-limit", needs_picture},
    {"--threads", needs_picture},
    {"--seconds", needs_picture},
    {"--until", needs_picture},
    {"--noise-target", needs_samples_for_target},
    {"--denoise", needs_picture},
    {"--denoise-light-groups", needs_denoised_groups},
    {"--replay-json", needs_replay},
    {"--replay-obj", needs_replay},
    {"--adaptive", needs_batches},
    {"--allocation", needs_more_than_pilot},
    {"--sample-range", needs_picture},
    {"--tile-range", needs_picture},
    {"--of", needs_picture},
    {"--checkpoint", needs_picture},
    {"--checkpoint-seconds", needs_checkpoint},
    {"--check-with", needs_check},
    {"--plant-difference", needs_check},
    {"--bvh-width", needs_choice_of_width},
    {"--simd", needs_lanes},
    {"--bvh-quality", needs_wide},
    {"--memory-mode", needs_wide},
    {"--bvh-split", needs_own_builder},
    {"--bvh-builder", needs_bvh},
    {"--bvh-bins", needs_sah},
    {"--max-leaf-size", needs_bvh},
    {"--traversal-cost", needs_bvh},
    {"--intersection-cost", needs_bvh},
    {"--triangle-test", needs_bvh},
    {"--embree-mode", needs_native},
    {"--embree-isa", needs_embree},
    {"--count", needs_counts},
};

bool has_area_light(const std::vector<Light>& lights) {
  return std::any_of(lights.begin(), lights.end(),
                     [](const Light& light) { return !is_delta(light.source); });
}

bool has_point_light(const Scene& scene) {
  return std::any_of(scene.lights.begin(), scene.lights.end(), [](const Light& light) {
    return std::holds_alternative<PointLight>(light.source) ||
           std::holds_alternative<SpotLight>(light.source);
  });
}

/// Whether there are more lights of a kind than are sampled each.
bool has_many_lights(const std::vector<Light>& lights) {
  std::size_t points = 0, surfaces = 0;
  for (const Light& light : lights) {
    if (is_distant(light.source) || std::holds_alternative<DirectionalLight>(light.source)) continue;
    ++(is_delta(light.source) ? points : surfaces);
  }
  return std::max(points, surfaces) > LightSet::most_alone;
}

bool is_diffuse(const Scene& scene) {
  return std::all_of(scene.materials.begin(), scene.materials.end(), [](const Material& material) {
    return std::holds_alternative<Lambert>(material.model);
  });
}

}  // namespace

std::vector<std::string> options_without_effect(const RenderRequest& request,
                                                const RenderArguments& arguments) {
  if (arguments.convert_textures && arguments.load.camera_name != "?")
    return options_without_effect_on_conversion(arguments);
  const Asked asked{request, arguments};
  std::vector<std::string> found;
  for (const Rule& rule : rules) {
    if (!is_given(rule.option, arguments)) continue;
    if (const std::string reason = rule.reason(asked); !reason.empty())
      found.push_back(fmt::format("{}: no effect, {}", rule.option, reason));
  }
  return found;
}

std::vector<std::string> options_without_effect(const Scene& scene, const RenderArguments& arguments,
                                                const std::vector<Light>& added) {
  std::vector<std::string> found;
  std::vector<Light> lights = scene.lights;
  lights.insert(lights.end(), added.begin(), added.end());
  if (arguments.default_light == DefaultLight::if_dark && is_lit(scene))
    found.push_back("--default-light: no effect, for the scene has light; --default-light=always adds to it");
  if (is_given("--light-samples", arguments) && arguments.path.direct != DirectMethod::hemisphere &&
      !has_area_light(lights))
    found.push_back("--light-samples: no effect, for no light of the scene has an area");
  if (is_given("--many-lights", arguments) && !has_many_lights(lights))
    found.push_back(fmt::format("--many-lights: no effect, for up to {} lights of a kind are all sampled",
                                LightSet::most_alone));
  if (arguments.lenient_environment && !has_environment(scene))
    found.push_back("--lenient-environment: no effect, for the scene has no environment");
  if (is_given("--attenuation", arguments) && is_collada(arguments.scene) && !has_point_light(scene))
    found.push_back("--attenuation: no effect, for the scene has no point light");
  for (const char* option : {"--glossy-bounces", "--transmission-bounces", "--regularize"})
    if (is_given(option, arguments) && is_diffuse(scene))
      found.push_back(fmt::format("{}: no effect, for all surfaces of the scene are diffuse", option));
  const Camera& camera = scene.camera;
  if (is_given("--aperture-blades", arguments) && camera.lens_radius == 0)
    found.push_back(
        is_panorama(camera.projection) ? "--aperture-blades: no effect, for panoramas have no lens"
        : camera.lenses ? "--aperture-blades: no effect, for the camera's lens has a stop of its own"
                        : "--aperture-blades: no effect, for the camera has no lens; --lens gives it one");
  if (arguments.load.clip_as_file && is_given("--clip", arguments) && arguments.view == View::file &&
      camera.clip_near == 0 && std::isinf(camera.clip_far))
    found.push_back("--clip: no effect, for the file's camera has no clip distances");
  if (is_given("--filter", arguments) && arguments.render.samples == 1)
    found.push_back("--filter: no effect, for the one sample of a pixel lies in its middle");
  for (const char* option : {"--texture-filter", "--texture-memory"})
    if (is_given(option, arguments) && !has_picture(scene.textures))
      found.push_back(fmt::format("{}: no effect, for the scene has no picture on its surfaces", option));
  return found;
}

std::vector<std::string> options_without_effect(const SceneSummary& summary,
                                                const RenderArguments& arguments) {
  std::vector<std::string> found;
  if (arguments.load.time && !summary.animation)
    found.push_back("--time: no effect, for nothing in the scene moves");
  const InstanceUse use = arguments.load.instances;
  if (summary.instances == 0 &&
      (use == InstanceUse::keep || (use == InstanceUse::copy && summary.repeated == 0)))
    found.push_back("--instances: no effect, for the scene's file shows nothing by instances");
  if (use == InstanceUse::copy && summary.instances > 0)
    found.push_back(
        "--instances: no effect, for generated scenes and the exchange form keep their instances");
  if (arguments.load.keep_both_lamps && is_collada(arguments.scene) && !summary.has_double_lamps)
    found.push_back("--keep-both-lamps: no effect, for the scene has no lamp that is given twice");
  return found;
}

}  // namespace twinray
