// SPDX-License-Identifier: Apache-2.0
// Part 1: the normals of every scene.
#include <fmt/format.h>

#include "cli/study/plan.h"

namespace twinray::study {

Part plan_rays(const Setting& setting) {
  Part part{1, "Ray generation and scene intersection", {}, {}};
  choose_scenes(setting,
                {{"CBspheres_lambertian", "CBspheres"},
                 {"CBgems"},
                 {"CBcoil"},
                 {"banana"},
                 {"cow"},
                 {"teapot"},
                 {"bunny", "CBbunny"},
                 {"dragon", "CBdragon"},
                 {"building"}},
                part);
  Section section{"Normal shading of every scene",
                  "The colour of a pixel is the shading normal at its first hit: 0.5 n + 0.5.",
                  {},
                  Comparison::none,
                  ""};
  for (const FoundScene& scene : setting.folder.scenes)
    section.figures.push_back(
        {normals_of(scene), scene.name, fmt::format("{} primitives", scene.primitives), {}});
  part.sections.push_back(std::move(section));
  return part;
}

}  // namespace twinray::study
