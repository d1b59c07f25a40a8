// SPDX-License-Identifier: Apache-2.0
// Part 3: two estimators of direct light, and how many light samples they take.
#include <fmt/format.h>

#include "cli/study/plan.h"

namespace twinray::study {
namespace {

/// Direct light alone; `options` are further ones.
Picture direct(const FoundScene& scene, const std::string& tag, std::uint32_t samples, Words options) {
  options.insert(options.begin(), {"-m", "1"});
  return picture_of(scene, "direct_" + tag, samples, std::move(options));
}

Picture converged_direct(const FoundScene& scene, const Scale& scale) {
  // Few samples of the pixel need more of the lights, so that the best picture below is far from it.
  const std::string light_samples = scale.divisor > 1 ? "64" : "16";
  return direct(scene, "converged", scale.samples(2048), {"-l", light_samples, "--seed", "1"});
}

Section estimators(const Setting& setting, Part& part) {
  Section section{"Hemisphere and light sampling",
                  "The same number of directions at each hit: uniform over the hemisphere, or towards points "
                  "on the lights.",
                  {},
                  Comparison::errors,
                  ""};
  for (const FoundScene* scene :
       choose_scenes(setting, {{"CBbunny"}, {"CBspheres_lambertian", "CBspheres"}}, part)) {
    const Picture converged = converged_direct(*scene, setting.scale);
    const auto add = [&](std::uint32_t samples, int light_samples, bool is_hemisphere) {
      Words options{"-l", fmt::format("{}", light_samples)};
      if (is_hemisphere) options.push_back("-H");
      const char* method = is_hemisphere ? "hemisphere" : "lights";
      section.figures.push_back(
          {direct(*scene, fmt::format("{}_s{}_l{}", method, samples, light_samples), samples, options),
           scene->name, fmt::format("{}, -s {} -l {}", method, samples, light_samples), converged});
    };
    for (const bool is_hemisphere : {true, false}) add(16, 8, is_hemisphere);
    for (const bool is_hemisphere : {true, false}) add(64, 32, is_hemisphere);
    section.figures.push_back({converged, scene->name, "converged", {}});
  }
  return section;
}

/// The scene of the write-ups, or any whose lights are points.
const FoundScene* point_light_scene(const SceneFolder& folder) {
  const FoundScene* const dragon = folder.find("dragon");
  if (dragon && dragon->has_only_point_lights) return dragon;
  for (const FoundScene& scene : folder.scenes)
    if (scene.has_only_point_lights) return &scene;
  return nullptr;
}

Section point_light(const Setting& setting, Part& part) {
  Section section{"A point light",
                  "A random direction never hits a point: hemisphere sampling finds no light at all.",
                  {},
                  Comparison::errors,
                  ""};
  const FoundScene* scene = point_light_scene(setting.folder);
  if (!scene) {
    part.missing.push_back("any scene that is lit by point lights alone");
    return section;
  }
  const Picture converged = direct(*scene, "point_converged", setting.scale.samples(2048), {"--seed", "1"});
  section.figures = {
      {direct(*scene, "point_hemisphere_s16", 16, {"-H"}), scene->name, "hemisphere, -s 16", converged},
      {direct(*scene, "point_lights_s16", 16, {}), scene->name, "lights, -s 16", converged},
      {converged, scene->name, "converged", {}}};
  return section;
}

Section light_samples(const Setting& setting, Part& part) {
  Section section{"Light samples",
                  "One sample per pixel, through its centre, and 1, 4, 16 and 64 samples of each area light: "
                  "noise in soft shadows. The converged picture has one sample per pixel as well.",
                  {},
                  Comparison::errors,
                  "samples of each area light"};
  for (const FoundScene* scene : choose_scenes(
           setting, {{"CBbunny"}, {"CBspheres_lambertian", "CBspheres"}, {"dragon", "CBdragon"}}, part)) {
    const auto with = [&](const std::string& tag, std::uint32_t count, Words more) {
      more.insert(more.begin(), {"-l", fmt::format("{}", count)});
      return direct(*scene, tag, 1, std::move(more));
    };
    const Picture converged = with("converged_centre", setting.scale.samples(4096), {"--seed", "1"});
    for (const std::uint32_t count : {1u, 4u, 16u, 64u})
      section.figures.push_back({with(fmt::format("lights_s1_l{}", count), count, {}), scene->name,
                                 fmt::format("-s 1 -l {}", count), converged, double(count)});
    section.figures.push_back({converged, scene->name, "converged", {}});
  }
  return section;
}

}  // namespace

Part plan_direct_light(const Setting& setting) {
  Part part{3, "Direct illumination", {}, {}};
  part.sections.push_back(estimators(setting, part));
  part.sections.push_back(point_light(setting, part));
  part.sections.push_back(light_samples(setting, part));
  return part;
}

}  // namespace twinray::study
