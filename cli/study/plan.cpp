// SPDX-License-Identifier: Apache-2.0
#include "cli/study/plan.h"

#include <fmt/format.h>

#include <set>

namespace twinray::study {
namespace {

/// Samples of a picture that is only looked at.
constexpr std::uint32_t smooth = 16;

void add_missing(const std::string& words, Part& part) {
  if (std::find(part.missing.begin(), part.missing.end(), words) == part.missing.end())
    part.missing.push_back(words);
}

}  // namespace

std::vector<Part> plan_study(const Setting& setting) {
  return {plan_rays(setting), plan_hierarchy(setting), plan_direct_light(setting), plan_global_light(setting),
          plan_adaptive(setting)};
}

std::vector<Picture> pictures_of(const Part& part) {
  std::vector<Picture> all;
  std::set<std::string> names;
  const auto add = [&](const Picture& picture) {
    if (names.insert(picture.name).second) all.push_back(picture);
  };
  for (const Section& section : part.sections)
    for (const Figure& figure : section.figures) {
      add(figure.picture);
      if (figure.converged) add(*figure.converged);
    }
  return all;
}

std::vector<const FoundScene*> choose_scenes(const Setting& setting, const std::vector<Wanted>& wanted,
                                             Part& part) {
  std::vector<const FoundScene*> chosen;
  for (const Wanted& one : wanted) {
    const FoundScene* scene = setting.folder.find(one.name);
    if (!scene && one.stand_in) scene = setting.folder.find(one.stand_in);
    if (!scene)
      add_missing(fmt::format("{}.dae", one.name), part);
    else if (scene != setting.folder.find(one.name))
      add_missing(fmt::format("{}.dae ({}.dae stands in for it)", one.name, scene->name), part);
    if (scene) chosen.push_back(scene);
  }
  return chosen;
}

Picture picture_of(const FoundScene& scene, const std::string& tag, std::uint32_t samples, Words options) {
  return {
      fmt::format("{}_{}", scene.name, tag), scene.path, scene.primitives, samples, std::move(options), {}};
}

Picture normals_of(const FoundScene& scene) {
  return picture_of(scene, "normals", smooth, {"--integrator=normals"});
}

}  // namespace twinray::study
