// SPDX-License-Identifier: Apache-2.0
// Part 4: light of several bounces, roulette, and samples per pixel.
#include <fmt/format.h>

#include "cli/study/plan.h"

namespace twinray::study {
namespace {

using Scenes = std::vector<const FoundScene*>;

/// The write-ups' samples of a picture without visible noise.
std::uint32_t many(const Setting& setting) { return setting.scale.samples(1024); }

Picture light(const Setting& setting, const FoundScene& scene, const std::string& tag, Words options) {
  return picture_of(scene, fmt::format("{}_s{}", tag, many(setting)), many(setting), std::move(options));
}

/// So many samples that it stands for the truth; of another seed than what it judges.
Picture converged_light(const FoundScene& scene, const Scale& scale) {
  return picture_of(scene, "converged_m5", scale.samples(4096), {"-l", "4", "-m", "5", "--seed", "1"});
}

Section direct_and_indirect(const Setting& setting, const Scenes& scenes) {
  Section section{
      "Direct and indirect light",
      "All light of up to 5 bounces, and its two parts: emission and the first bounce, and what is "
      "scattered twice or more. They add up.",
      {},
      Comparison::none,
      ""};
  for (const FoundScene* scene : scenes) {
    const auto add = [&](const std::string& tag, const char* label, const Words& options) {
      section.figures.push_back({light(setting, *scene, tag, options), scene->name, label, {}});
    };
    add("m5", "all light", {"-m", "5"});
    add("m5_direct", "direct light only", {"--bounces=direct"});
    add("m5_indirect", "indirect light only", {"-m", "5", "--bounces=indirect"});
  }
  return section;
}

Section depths(const Setting& setting, const Scenes& scenes) {
  Section section{
      "Bounces of light",
      "Up to <i>m</i> bounces, accumulated (the course's <code>-o 1</code>), and the light of the "
      "last bounce alone (<code>-o 0</code>, here <code>--bounces=last</code>).",
      {},
      Comparison::none,
      ""};
  for (const FoundScene* scene : scenes) {
    for (const bool is_last : {false, true})
      for (int depth = 0; depth <= 5; ++depth) {
        Words options{"-m", fmt::format("{}", depth)};
        if (is_last) options.push_back("--bounces=last");
        section.figures.push_back(
            {light(setting, *scene, fmt::format("m{}{}", depth, is_last ? "_last" : ""), options),
             scene->name,
             fmt::format("-m {}, {}", depth, is_last ? "the last bounce" : "accumulated"),
             {}});
      }
    section.figures.push_back({light(setting, *scene, "m100_roulette0.7", {"-m", "100", "--roulette=0.7"}),
                               scene->name,
                               "-m 100, roulette",
                               {}});
  }
  return section;
}

Section roulette(const Setting& setting, const Scenes& scenes) {
  Section section{
      "Russian roulette",
      "Up to 100 bounces: a path goes on with a fixed probability from its second bounce on, or by "
      "what it can still carry (throughput, the default) from its fourth. The mean is the same; "
      "time and noise differ.",
      {},
      Comparison::errors,
      ""};
  for (const FoundScene* scene : scenes) {
    const Picture converged = picture_of(*scene, "converged_m100", setting.scale.samples(4096),
                                         {"-l", "4", "-m", "100", "--seed", "1"});
    for (const std::string rule : {"0.3", "0.5", "0.7", "throughput"})
      section.figures.push_back(
          {light(setting, *scene, "m100_roulette" + rule, {"-m", "100", "--roulette=" + rule}), scene->name,
           "--roulette=" + rule, converged});
    section.figures.push_back({converged, scene->name, "converged", {}});
  }
  return section;
}

Section samples(const Setting& setting, const Scenes& scenes) {
  Section section{"Samples per pixel",
                  "Five bounces, 4 light samples at each hit. A single sample goes through the pixel's "
                  "centre, several through random points of it.",
                  {},
                  Comparison::errors,
                  "samples per pixel"};
  for (const FoundScene* scene : scenes) {
    const Picture converged = converged_light(*scene, setting.scale);
    for (const std::uint32_t count : {1u, 2u, 4u, 8u, 16u, 64u, 1024u}) {
      const std::uint32_t used = count > 64 ? std::max(128u, setting.scale.samples(count)) : count;
      section.figures.push_back(
          {picture_of(*scene, fmt::format("m5_l4_s{}", used), used, {"-l", "4", "-m", "5"}), scene->name,
           fmt::format("-s {}", used), converged, double(used)});
    }
    section.figures.push_back({converged, scene->name, "converged", {}});
  }
  return section;
}

}  // namespace

Part plan_global_light(const Setting& setting) {
  Part part{4, "Global illumination", {}, {}};
  const Scenes scenes = choose_scenes(setting, {{"CBbunny"}, {"CBspheres_lambertian", "CBspheres"}}, part);
  for (const auto& plan : {direct_and_indirect, depths, roulette, samples})
    part.sections.push_back(plan(setting, scenes));
  return part;
}

}  // namespace twinray::study
