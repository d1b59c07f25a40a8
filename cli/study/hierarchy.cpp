// SPDX-License-Identifier: Apache-2.0
// Part 2: what a bounding volume hierarchy gives, and what the way of splitting it takes and gives.
#include <fmt/format.h>

#include "cli/study/plan.h"

namespace twinray::study {
namespace {

Section large_models(const Setting& setting, Part& part) {
  Section section{"Models of many triangles",
                  "Without a hierarchy each of these would take minutes to hours.",
                  {},
                  Comparison::none,
                  ""};
  for (const FoundScene* scene : choose_scenes(
           setting, {{"maxplanck"}, {"CBlucy"}, {"dragon", "CBdragon"}, {"wall-e"}, {"building"}, {"peter"}},
           part))
    section.figures.push_back(
        {normals_of(*scene), scene->name, fmt::format("{} primitives", scene->primitives), {}});
  return section;
}

Section with_and_without(const Setting& setting, Part& part) {
  Section section{"Without and with a hierarchy",
                  "Without one, every ray is tested against every primitive. Normal shading, one sample per "
                  "pixel, the same picture either way.",
                  {},
                  Comparison::hierarchy,
                  ""};
  for (const FoundScene* scene :
       choose_scenes(setting, {{"cow"}, {"teapot"}, {"banana"}, {"CBcoil"}, {"CBbunny"}}, part)) {
    const Words normals{"--integrator=normals"};
    const auto add = [&](const char* tag, const char* label, const std::string& engine, bool is_pictured) {
      Picture picture = picture_of(*scene, tag, 1, normals);
      picture.options.push_back(engine);
      section.figures.push_back({std::move(picture), scene->name, label, {}, 0, is_pictured});
    };
    add("brute_force", "without", "--accel=brute-force", true);
    add("bvh", "with", "--accel=bvh", false);
  }
  return section;
}

Section splits(const Setting& setting, Part& part) {
  Section section{
      "Split methods",
      "Binary trees, leaves of up to 4 primitives: by the surface area heuristic (sah, the "
      "default), by half of the primitives (median), by the middle of the box of their centroids "
      "(midpoint), by the mean of their centroids (mean). All make the same picture; that of sah is shown. "
      "In brackets the ratio to sah.",
      {},
      Comparison::splits,
      ""};
  for (const FoundScene* scene : choose_scenes(
           setting, {{"cow"}, {"maxplanck"}, {"CBbunny"}, {"CBlucy"}, {"dragon", "CBdragon"}}, part))
    for (const std::string split : {"sah", "median", "midpoint", "mean"}) {
      Picture picture = normals_of(*scene);
      picture.name += "_" + split;
      picture.options.insert(picture.options.end(), {"--accel=bvh", "--bvh-width=2", "--bvh-split=" + split});
      section.figures.push_back({std::move(picture), scene->name, split, {}, 0, split == "sah"});
    }
  return section;
}

}  // namespace

Part plan_hierarchy(const Setting& setting) {
  Part part{2, "Bounding volume hierarchy", {}, {}};
  part.sections.push_back(large_models(setting, part));
  part.sections.push_back(with_and_without(setting, part));
  part.sections.push_back(splits(setting, part));
  return part;
}

}  // namespace twinray::study
