// SPDX-License-Identifier: Apache-2.0
// Part 5: where adaptive sampling spends its samples, and what it costs.
#include <fmt/format.h>

#include <algorithm>

#include "cli/study/plan.h"

namespace twinray::study {
namespace {

/// With fewer, no pixel could save much: the rule is asked every 64 samples.
constexpr std::uint32_t least_samples = 512;

}  // namespace

Part plan_adaptive(const Setting& setting) {
  Part part{5, "Adaptive sampling", {}, {}};
  const std::uint32_t most = std::max(least_samples, setting.scale.samples(2048));
  const Words light{"-l", "1", "-m", "5"};
  Section section{
      "Samples where they are needed",
      "A pixel is done when the confidence interval of its mean lies within the tolerance, tested "
      "every 64 samples: by the course's rule, and by the default one, which stops later and loses "
      "less. Below each picture its sample rates: blue few, red all.",
      {},
      Comparison::adaptive,
      ""};
  for (const FoundScene* scene :
       choose_scenes(setting, {{"CBspheres_lambertian", "CBspheres"}, {"CBbunny"}, {"wall-e"}}, part)) {
    Picture converged = picture_of(*scene, "converged_m5_l1", 2 * most, light);
    converged.options.insert(converged.options.end(), {"--seed", "1"});
    const auto add = [&](const std::string& rule, const std::string& label) {
      Picture picture = picture_of(*scene, fmt::format("m5_l1_s{}", most), most, light);
      if (!rule.empty()) {
        picture.name += "_adaptive_" + rule;
        picture.adaptive = {"-a", "64", "0.05", "--adaptive-rule=" + rule};
      }
      section.figures.push_back({std::move(picture), scene->name, label, converged});
    };
    add("", "all samples");
    add("cs184", "the course's rule");
    add("careful", "the default rule");
    section.figures.push_back({converged, scene->name, "converged", {}});
  }
  part.sections.push_back(std::move(section));
  return part;
}

}  // namespace twinray::study
