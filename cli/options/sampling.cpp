// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "cli/options/render.h"

namespace twinray {
namespace {

constexpr Range<std::uint32_t> batches{2, Film::max_samples};
constexpr Range<double> tolerances{0, 1e6};
constexpr Range<double> noise_targets{1e-6, 1e3};
}  // namespace

void add_sampling_options(CLI::App& app, RenderRequest& request) {
  OptionGroup group(app, option_groups::picture);
  group.add_number({"-s,--samples", "N", "Samples per pixel"}, request.arguments.render.samples,
                   sample_counts);
  group.add_number({"--seconds", "T", "As many samples as this time allows; at most N if given"},
                   request.arguments.render.seconds, time_limits);
  group.add_words({"--until", "TIME", "As many as there can be by then: 07:30 or 2026-11-24T07:30"}, 1,
                  [&request](const Words& words) {
                    try {
                      request.arguments.until = parse_clock_time(words[0]);
                    } catch (const Error& error) {
                      throw UsageError(fmt::format("--until: {}", error.what()));
                    }
                  });
  group.add_number({"--noise-target", "E", "As many as this relative error needs; at most N if given"},
                   request.arguments.render.noise_target, noise_targets);
  add_sampler_options(app, request);
}

void add_sampler_options(CLI::App& app, RenderRequest& request) {
  OptionGroup group(app, option_groups::picture);
  const AdaptiveSampling usual;
  group.add_words(
      {"-a,--adaptive", "N T",
       fmt::format("Stop a pixel early: batch size, tolerance; as {} {}", usual.batch, usual.tolerance)},
      2, [&request](const Words& words) { request.adaptive = words; });
  group.add_choice<Allocation>("--allocation", request.arguments.render.allocation,
                               {{"even", Allocation::even}, {"error", Allocation::error}},
                               "N in each pixel, or on average: more where noise is");
  add_sampling_words(app, request);
}

void add_sampling_words(CLI::App& app, RenderRequest& request) {
  OptionGroup group(app, option_groups::picture);
  RenderOptions& render = request.arguments.render;
  group.add_choice<std::optional<AdaptiveRule>>(
      "--adaptive-rule", request.adaptive_rule,
      {{"careful", AdaptiveRule::careful}, {"cs184", AdaptiveRule::cs184}},
      "When it stops; cs184 loses rare light (careful)");
  group.add_choice<SamplerKind>("--sampler", render.sampler,
                                {{"sobol", SamplerKind::sobol}, {"independent", SamplerKind::independent}},
                                "Random numbers");
  group.add_number({"--seed", "N", "Another seed, another noise"}, render.seed, seeds);
}

void heed_the_clock(RenderArguments& arguments) {
  if (!arguments.until) return;
  const std::chrono::duration<double> left = *arguments.until - std::chrono::system_clock::now();
  double& seconds = arguments.render.seconds ? *arguments.render.seconds
                                             : arguments.render.seconds.emplace(time_limits.most);
  seconds = std::clamp(left.count(), time_limits.least, seconds);
}

std::string clock_warning(const RenderArguments& arguments) {
  if (!arguments.until || *arguments.until > std::chrono::system_clock::now()) return {};
  return fmt::format("--until: {} is over: as few samples are rendered as can be",
                     clock_text(*arguments.until));
}

void resolve_sampling(const RenderRequest& request, RenderArguments& arguments) {
  heed_the_clock(arguments);
  if (is_open_ended(arguments.render) && !is_given("--samples", arguments))
    arguments.render.samples = Film::max_samples;
  if (arguments.render.noise_target) arguments.render.half_layers.emplace();
  if (!request.adaptive.empty() && arguments.render.allocation == Allocation::error)
    throw UsageError("--allocation=error spreads as many samples, --adaptive takes fewer: give one of them");
  if (request.adaptive.empty()) {
    if (request.adaptive_rule) throw UsageError("--adaptive-rule goes with --adaptive");
    return;
  }
  AdaptiveSampling& adaptive = arguments.render.adaptive.emplace();
  adaptive.batch = parse_number("--adaptive", request.adaptive[0], batches);
  adaptive.rule = request.adaptive_rule.value_or(adaptive.rule);
  adaptive.tolerance = parse_number("--adaptive", request.adaptive[1], tolerances);
}

}  // namespace twinray
