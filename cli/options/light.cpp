// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "cli/options/render.h"
#include "core/radiance.h"

namespace twinray {
namespace {

using Bounces = RenderRequest::Bounces;

const Choices<IntegratorKind> integrators{
    {"path", IntegratorKind::path},       {"path-reference", IntegratorKind::path_reference},
    {"direct", IntegratorKind::direct},   {"ambient-occlusion", IntegratorKind::ambient_occlusion},
    {"furnace", IntegratorKind::furnace}, {"normals", IntegratorKind::normals},
    {"cost", IntegratorKind::cost}};
constexpr Range<double> distances{1e-12, std::numeric_limits<double>::infinity()};

/// What has a letter, too.
void add_light_letters(OptionGroup& group, RenderRequest& request) {
  RenderArguments& arguments = request.arguments;
  group.add_number({"-m,--max-depth", "N", "Bounces of light: 0 emission, 1 direct, ..."},
                   arguments.path.max_depth, {0, 100});
  group.add_number({"-l,--light-samples", "N", "Samples of each area light at a hit"},
                   arguments.path.samples_per_light, light_sample_counts);
  group.add_word({"-e,--environment", "FILE", "Light from a latitude-longitude .exr or .hdr"},
                 arguments.environment);
}

void add_path_words(OptionGroup& group, RenderRequest& request) {
  group.add_choice<Bounces>("--bounces", request.bounces,
                            {{"all", Bounces::all},
                             {"direct", Bounces::direct},
                             {"indirect", Bounces::indirect},
                             {"last", Bounces::last}},
                            "Which light is shown");
  BounceLimits& limits = request.arguments.path.limits;
  constexpr Range<int> bounces{0, BounceLimits::most};
  group.add_number({"--diffuse-bounces", "N", "Indirect bounces by diffuse reflection, at most"},
                   limits.diffuse, bounces);
  group.add_number({"--glossy-bounces", "N", "By mirrors and glossy reflection"}, limits.glossy, bounces);
  group.add_number({"--transmission-bounces", "N", "By light that goes through surfaces"},
                   limits.transmission, bounces);
  group.add_word({"--roulette", "throughput|P",
                  fmt::format("By throughput from bounce 4, or a probability ({})", request.roulette)},
                 request.roulette);
  group.add_word({"--clamp", "off|X",
                  fmt::format("Greatest term of light of two or more bounces; biased ({})", request.clamp)},
                 request.clamp);
  group.add_flag("--regularize", request.arguments.path.regularize,
                 "Rougher surfaces behind the first wide bounce; biased");
  group.add_choice<DirectMethod>("--direct", request.arguments.path.direct,
                                 {{"mis", DirectMethod::mis},
                                  {"lights", DirectMethod::lights},
                                  {"hemisphere", DirectMethod::hemisphere}},
                                 "How direct light is sampled; -H is hemisphere");
  group.add_choice<ManyLights>(
      "--many-lights", request.arguments.path.many_lights,
      {{"tree", ManyLights::tree}, {"power", ManyLights::power}, {"all", ManyLights::all}},
      "Of more than 8, one is chosen so; or all are sampled");
}

/// A whole word as a number.
std::optional<float> number_of(const std::string& word) {
  float number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return number;
}

Roulette parse_roulette(const std::string& word) {
  if (word == "throughput") return {};
  const std::optional<float> probability = number_of(word);
  if (!probability || !(*probability > 0 && *probability <= 1))
    throw UsageError(
        fmt::format("--roulette: \"{}\"; valid are throughput and a probability in (0, 1]", word));
  return {*probability};
}

float parse_clamp(const std::string& word) {
  if (word == "off") return std::numeric_limits<float>::infinity();
  const std::optional<float> clamp = number_of(word);
  if (!clamp || !(*clamp > 0 && *clamp <= max_radiance))
    throw UsageError(fmt::format("--clamp: \"{}\"; valid are off and a radiance in (0, 10^9]", word));
  return *clamp;
}

void check_indirect(int max_depth) {
  if (max_depth < 2)
    throw UsageError(fmt::format("--bounces=indirect: indirect light takes two bounces, and {} is made",
                                 max_depth == 0 ? "none" : "only one"));
}

void choose_bounces(Bounces bounces, PathOptions& path) {
  if (bounces == Bounces::indirect) check_indirect(path.max_depth);
  if (bounces == Bounces::direct) path.last_depth = 1;
  if (bounces == Bounces::indirect) path.first_depth = 2;
  if (bounces == Bounces::last) path.first_depth = path.last_depth = path.max_depth;
}

}  // namespace

std::string integrator_name(IntegratorKind kind) {
  for (const auto& [name, value] : integrators)
    if (value == kind) return name;
  return "unknown";
}

void add_light_options(CLI::App& app, RenderRequest& request) {
  OptionGroup group(app, option_groups::light);
  OptionGroup(app, "").add_flag("-H,--hemisphere", request.hemisphere, "");  // Help has it at --direct.
  add_light_letters(group, request);
  add_light_words(app, request);
}

namespace {

constexpr const char* default_light_if_dark = "if-dark";

/// Of the option's word, which is empty where it was not given.
DefaultLight parse_default_light(const std::string& word) {
  if (word.empty()) return DefaultLight::none;
  if (word == "always") return DefaultLight::always;
  if (word == default_light_if_dark) return DefaultLight::if_dark;
  throw UsageError(fmt::format(
      "--default-light: \"{}\" is not valid; it stands alone or is --default-light=always", word));
}

}  // namespace

void add_light_words(CLI::App& app, RenderRequest& request) {
  OptionGroup group(app, option_groups::light);
  RenderArguments& arguments = request.arguments;
  group.add_choice<IntegratorKind>("--integrator", arguments.integrator, integrators, "What is computed");
  group.add_number({"--ao-distance", "X", "How far ambient occlusion looks for obstacles"},
                   arguments.occlusion_distance, distances);
  group.add_choice<std::optional<CostKind>>(
      "--cost", request.cost, {{"nodes", CostKind::nodes}, {"primitives", CostKind::primitives}},
      "Of a camera ray, for cost (nodes if counted)");
  add_path_words(group, request);
  add_environment_placement(group, arguments.placement);
  group.add_flag("--lenient-environment", arguments.lenient_environment,
                 "Its pixels that are not radiance are black");
  group.add_choice<bool>("--attenuation", arguments.load.attenuation_as_file,
                         {{"physical", false}, {"file", true}},
                         "Of a point light of which the file says nothing");
  group.add_optional_word({"--default-light", "[=always]", "Light a scene without light by a soft sky"},
                          default_light_if_dark, request.default_light);
  group.add_flag("--keep-both-lamps", arguments.load.keep_both_lamps,
                 "Keep a lamp's rectangle beside its mesh");
}

void resolve_light(const RenderRequest& request, RenderArguments& arguments) {
  arguments.default_light = parse_default_light(request.default_light);
  PathOptions& path = arguments.path;
  if (request.hemisphere && is_given("--direct", arguments) && path.direct != DirectMethod::hemisphere)
    throw UsageError("-H is --direct=hemisphere, and --direct says another thing");
  if (request.hemisphere) path.direct = DirectMethod::hemisphere;
  if (arguments.integrator == IntegratorKind::direct) path.max_depth = std::min(path.max_depth, 1);
  path.roulette = parse_roulette(request.roulette);
  path.clamp = parse_clamp(request.clamp);
  choose_bounces(request.bounces, path);
}

void take_depth(int max_depth, RenderArguments& arguments) {
  PathOptions& path = arguments.path;
  const bool is_last_alone = path.first_depth > 0 && path.first_depth == path.last_depth;
  path.max_depth = arguments.integrator == IntegratorKind::direct ? std::min(max_depth, 1) : max_depth;
  if (is_last_alone)
    path.first_depth = path.last_depth = path.max_depth;
  else if (path.first_depth == 2)
    check_indirect(path.max_depth);
}

}  // namespace twinray
