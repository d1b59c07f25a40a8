// SPDX-License-Identifier: Apache-2.0
#include "cli/render_arguments.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <functional>
#include <limits>
#include <utility>

#include "cli/console.h"
#include "cli/options.h"
#include "cli/version.h"
#include "core/error.h"

namespace twinray {
namespace {

constexpr int max_frame = 65536;

template <typename T>
using Choices = std::vector<std::pair<std::string, T>>;

template <typename T>
std::vector<std::string> names_of(const Choices<T>& choices) {
  std::vector<std::string> names;
  for (const auto& [name, value] : choices) names.push_back(name);
  return names;
}

/// An option whose value is one of a few words.
template <typename T>
CLI::Option* add_choice(CLI::App& app, const std::string& name, T& target, const Choices<T>& choices,
                        const std::string& description) {
  const std::function<void(const std::string&)> choose = [&target, choices, name](const std::string& word) {
    for (const auto& [valid, value] : choices)
      if (valid == word) {
        target = value;
        return;
      }
    throw CLI::ValidationError(
        fmt::format("{}: there is no \"{}\"; valid are {}", name, word, fmt::join(names_of(choices), ", ")));
  };
  return app.add_option_function<std::string>(name, choose, description)
      ->type_name(fmt::format("{}", fmt::join(names_of(choices), "|")));
}

/// No backend: check.
Choices<std::optional<Backend>> engine_choices() {
  Choices<std::optional<Backend>> choices;
  for (const Backend backend : available_backends()) choices.emplace_back(backend_name(backend), backend);
  choices.emplace_back("check", std::nullopt);
  return choices;
}

/// What the bvh can be checked with, the usual one first.
Choices<std::string> check_choices() {
  Choices<std::string> choices;
  for (const std::string& name : engine_names())
    if (name != backend_name(Backend::bvh)) choices.emplace_back(name, name);
  return choices;
}

Choices<BvhBuilder> builder_choices() {
  Choices<BvhBuilder> choices;
  for (const BvhBuilder builder : available_builders()) choices.emplace_back(builder_name(builder), builder);
  return choices;
}

Choices<std::string> simd_choices() {
  Choices<std::string> choices;
  for (const std::string& name : available_instruction_sets()) choices.emplace_back(name, name);
  return choices;
}

/// Options whose values are only understood together with others, or after all have been read.
struct RawArguments {
  std::vector<int> resolution{480, 360};
  std::vector<int> crop;
  std::vector<double> adaptive;
  std::string roulette = "throughput";
  bool hemisphere = false;
  std::optional<CostKind> cost;
  std::optional<int> bvh_width;
  std::optional<Backend> backend = default_backend();  ///< None: check.
  std::string check_with;                              ///< Empty: the usual one.
  enum class Bounces { all, direct, indirect, last } bounces = Bounces::all;
};

void add_picture_options(CLI::App& app, RenderArguments& arguments, RawArguments& raw) {
  app.add_option("-o,--output,-f", arguments.output, "The picture: .png, or .exr for linear floats")
      ->type_name("FILE")
      ->group("Picture");
  add_numbers(app, "-r,--resolution", raw.resolution, 2)
      ->description("Width and height in pixels (480 360)")
      ->type_name("W H")
      ->group("Picture");
  add_numbers(app, "-p,--crop", raw.crop, 4)
      ->description("Only this part of the frame, from its top left")
      ->type_name("X Y W H")
      ->group("Picture");
  add_choice<View>(app, "--view", arguments.view, {{"file", View::file}, {"whole", View::whole}},
                   "As the file's camera sees it, or all of it (file)")
      ->group("Picture");
  app.add_option("-c,--camera", arguments.camera_file, "Camera settings file of CS184's program")
      ->type_name("FILE")
      ->group("Picture");
}

void add_light_options(CLI::App& app, RenderArguments& arguments, RawArguments& raw) {
  const char* group = "Light";
  add_choice<IntegratorKind>(app, "--integrator", arguments.integrator,
                             {{"path", IntegratorKind::path},
                              {"direct", IntegratorKind::direct},
                              {"normals", IntegratorKind::normals},
                              {"cost", IntegratorKind::cost}},
                             "What is computed (path)")
      ->group(group);
  add_choice<std::optional<CostKind>>(app, "--cost", raw.cost,
                                      {{"nodes", CostKind::nodes}, {"primitives", CostKind::primitives}},
                                      "Of a camera ray, for cost (nodes if counted)")
      ->group(group);
  app.add_option("-m,--max-depth", arguments.path.max_depth,
                 "Bounces of light: 0 emission, 1 direct, ... (5)")
      ->type_name("N")
      ->check(CLI::Range(0, 100))
      ->group(group);
  add_choice<DirectMethod>(app, "--direct", arguments.path.direct,
                           {{"lights", DirectMethod::lights}, {"hemisphere", DirectMethod::hemisphere}},
                           "How direct light is sampled (lights)")
      ->group(group);
  app.add_flag("-H,--hemisphere", raw.hemisphere, "The same as --direct=hemisphere")->group(group);
  app.add_option("-l,--light-samples", arguments.path.samples_per_light,
                 "Samples of each area light at a hit (1)")
      ->type_name("N")
      ->check(CLI::Range(1, 65536))
      ->group(group);
  add_choice<RawArguments::Bounces>(app, "--bounces", raw.bounces,
                                    {{"all", RawArguments::Bounces::all},
                                     {"direct", RawArguments::Bounces::direct},
                                     {"indirect", RawArguments::Bounces::indirect},
                                     {"last", RawArguments::Bounces::last}},
                                    "Which light is shown (all)")
      ->group(group);
  app.add_option("--roulette", raw.roulette, "Going on: a probability, or by throughput")
      ->type_name("throughput|P")
      ->group(group);
  app.add_option("-e,--environment", arguments.environment, "Light from a latitude-longitude .exr or .hdr")
      ->type_name("FILE")
      ->group(group);
  app.add_flag("--keep-both-lamps", arguments.load.keep_both_lamps, "Keep a lamp's rectangle beside its mesh")
      ->group(group);
}

void add_sampling_options(CLI::App& app, RenderArguments& arguments, RawArguments& raw) {
  const char* group = "Sampling";
  app.add_option("-s,--samples", arguments.render.samples, "Samples per pixel (32)")
      ->type_name("N")
      ->check(CLI::Range(1u, Film::max_samples))
      ->group(group);
  add_numbers(app, "-a,--adaptive", raw.adaptive, 2)
      ->description("Stop a pixel early: batch size, tolerance (32 0.05)")
      ->type_name("N T")
      ->group(group);
  add_choice<SamplerKind>(app, "--sampler", arguments.render.sampler,
                          {{"sobol", SamplerKind::sobol}, {"independent", SamplerKind::independent}},
                          "Random numbers (sobol)")
      ->group(group);
  app.add_option("--seed", arguments.render.seed, "Another seed, another noise (0)")
      ->type_name("N")
      ->group(group);
}

void add_engine_options(CLI::App& app, RenderArguments& arguments, RawArguments& raw) {
  const char* group = "Ray engine";
  BuildOptions& build = arguments.build;
  add_choice<std::optional<Backend>>(
      app, "--accel", raw.backend, engine_choices(),
      fmt::format("The engine ({}); check: bvh and another", backend_name(default_backend())))
      ->group(group);
  add_choice<std::string>(
      app, "--check-with", raw.check_with, check_choices(),
      fmt::format("The other ({}); NAME_differences.png shows\nthe pixels of rays that differ",
                  check_choices().front().first))
      ->group(group);
  app.add_flag("--plant-difference", arguments.plant_difference,
               "check: with another triangle test; it must be found")
      ->group(group);
  add_choice<std::optional<int>>(app, "--bvh-width", raw.bvh_width, {{"2", 2}, {"8", 8}},
                                 "bvh: children of a node (8; 2 to count)")
      ->group(group);
  add_choice<std::string>(app, "--simd", build.simd, simd_choices(),
                          "bvh of width 8, leaves of embree (best)")
      ->group(group);
  add_choice<BvhQuality>(
      app, "--bvh-quality", build.bvh_quality,
      {{"fast", BvhQuality::fast}, {"medium", BvhQuality::medium}, {"high", BvhQuality::high}},
      "Build time against speed (medium)")
      ->group(group);
  add_choice<BvhSplit>(app, "--bvh-split", build.bvh_split,
                       {{"sah", BvhSplit::sah},
                        {"median", BvhSplit::median},
                        {"midpoint", BvhSplit::midpoint},
                        {"mean", BvhSplit::mean}},
                       "How nodes are split (sah)")
      ->group(group);
  add_choice<BvhBuilder>(app, "--bvh-builder", build.bvh_builder, builder_choices(),
                         "Who builds the bvh (own)")
      ->group(group);
  app.add_option("--bvh-bins", build.bvh_bins, "Bins of each axis, for sah (32)")
      ->type_name("N")
      ->check(CLI::Range(2, 256))
      ->group(group);
  app.add_option("--max-leaf-size", build.max_leaf_size, "Primitives of a leaf (4)")
      ->type_name("N")
      ->check(CLI::Range(1, 255))
      ->group(group);
  app.add_option("--traversal-cost", build.traversal_cost, "Cost of a node, for sah (1)")
      ->type_name("C")
      ->check(CLI::Range(1e-6, 1e6))
      ->group(group);
  app.add_option("--intersection-cost", build.intersection_cost, "Cost of a primitive, for sah (1)")
      ->type_name("C")
      ->check(CLI::Range(1e-6, 1e6))
      ->group(group);
  add_choice<TriangleTest>(app, "--triangle-test", build.triangle_test,
                           {{"woop", TriangleTest::woop}, {"moller-trumbore", TriangleTest::moller_trumbore}},
                           "bvh, brute-force (woop)")
      ->group(group);
#ifdef TWINRAY_WITH_EMBREE
  add_choice<EmbreeMode>(app, "--embree-mode", build.embree_mode,
                         {{"robust", EmbreeMode::robust}, {"fast", EmbreeMode::fast}},
                         "embree-native (robust)")
      ->group(group);
  app.add_option("--embree-isa", build.embree_isa, "embree*: sse2, sse4.2, avx, avx2, avx512, default")
      ->type_name("ISA")
      ->group(group);
#endif
}

void add_run_options(CLI::App& app, RenderArguments& arguments) {
  const char* group = "Run";
  app.add_option("-t,--threads", arguments.render.threads, "Threads (all of the machine)")
      ->type_name("N")
      ->check(CLI::Range(1, 1024))
      ->group(group);
  app.add_flag("--count", arguments.render.counting, "Count nodes and primitives per ray (slower)")
      ->group(group);
  app.add_option("--stats", arguments.stats_file, "Write all figures as JSON")
      ->type_name("FILE")
      ->group(group);
  app.add_flag("--strict", arguments.load.strict, "What a scene file says must all be understood")
      ->group(group);
  app.add_flag("-q,--quiet", arguments.quiet, "Print errors and warnings only")->group(group);
}

PixelRect window_of(const std::vector<int>& crop, int width, int height) {
  const PixelRect window{crop[0], crop[1], crop[0] + crop[2], crop[1] + crop[3]};
  if (crop[0] < 0 || crop[1] < 0 || crop[2] < 1 || crop[3] < 1 || crop[2] > width - crop[0] ||
      crop[3] > height - crop[1])
    throw UsageError(fmt::format("--crop: {} {} {} {} (X Y W H) is not a part of {} x {} pixels", crop[0],
                                 crop[1], crop[2], crop[3], width, height));
  return window;
}

Roulette parse_roulette(const std::string& word) {
  if (word == "throughput") return {};
  float probability = 0;
  if (!CLI::detail::lexical_cast(word, probability) || !(probability > 0 && probability <= 1))
    throw UsageError(
        fmt::format("--roulette: \"{}\"; valid are throughput and a probability in (0, 1]", word));
  return {probability};
}

AdaptiveSampling parse_adaptive(const std::vector<double>& words) {
  if (!(words[0] >= 2 && words[0] <= Film::max_samples && words[0] == double(std::uint32_t(words[0]))))
    throw UsageError(fmt::format("--adaptive: a batch of {}; it must be a whole number from 2 to {}",
                                 words[0], Film::max_samples));
  if (!(words[1] >= 0 && words[1] <= std::numeric_limits<float>::max()))
    throw UsageError(
        fmt::format("--adaptive: a tolerance of {}; it must be finite and not negative", words[1]));
  return {std::uint32_t(words[0]), words[1]};
}

void choose_bounces(RawArguments::Bounces bounces, PathOptions& path) {
  if (bounces == RawArguments::Bounces::direct) path.last_depth = 1;
  if (bounces == RawArguments::Bounces::indirect) path.first_depth = 2;
  if (bounces == RawArguments::Bounces::last) path.first_depth = path.last_depth = path.max_depth;
}

/// Chooses what the integrator cost shows, which only counting queries tell.
void choose_cost(const std::optional<CostKind>& chosen, RenderArguments& arguments) {
  if (arguments.integrator != IntegratorKind::cost) {
    if (chosen) throw UsageError("--cost goes with --integrator=cost");
    return;
  }
  const bool has_nodes = arguments.backend == Backend::bvh;
  if (arguments.backend == Backend::embree_native)
    throw UsageError("--integrator=cost: embree-native counts nothing");
  if (chosen == CostKind::nodes && !has_nodes)
    throw UsageError(
        fmt::format("--cost=nodes: {} has no nodes that could be counted; valid are "
                    "--cost=primitives, or --accel=bvh",
                    backend_name(arguments.backend)));
  arguments.cost = chosen.value_or(has_nodes ? CostKind::nodes : CostKind::primitives);
  arguments.render.counting = true;
}

/// Counts are those of the binary tree, which compare among all trees, unless another is asked for.
void choose_width(const std::optional<int>& chosen, RenderArguments& arguments) {
  BuildOptions& build = arguments.build;
  if (arguments.render.counting) build.bvh_width = 2;
  build.bvh_width = chosen.value_or(build.bvh_width);
  if (arguments.backend == Backend::bvh && build.bvh_width == 8 && build.max_leaf_size > 4)
    throw UsageError("--max-leaf-size: a BVH of width 8 has leaves of up to 4; --bvh-width=2 takes more");
}

void check_builder(const RenderArguments& arguments) {
  const BuildOptions& build = arguments.build;
  if (build.bvh_builder == BvhBuilder::own) return;
  if (arguments.backend != Backend::bvh) throw UsageError("--bvh-builder goes with --accel=bvh");
  if (build.bvh_split != BvhSplit::sah || build.bvh_bins != BuildOptions{}.bvh_bins)
    throw UsageError("--bvh-split and --bvh-bins go with --bvh-builder=own");
  if (build.max_leaf_size > 32)
    throw UsageError("--max-leaf-size: Embree's builders make leaves of up to 32 primitives");
}

void choose_backend(const RawArguments& raw, RenderArguments& arguments) {
  const bool is_check = !raw.backend;
  if (!is_check && (!raw.check_with.empty() || arguments.plant_difference))
    throw UsageError("--check-with and --plant-difference go with --accel=check");
  if (!raw.check_with.empty() && arguments.plant_difference)
    throw UsageError("--plant-difference is an engine of its own; it does not go with --check-with");
  arguments.backend = raw.backend.value_or(Backend::bvh);
}

/// Chooses what the bvh is checked with, once its own options are known.
void choose_check(const RawArguments& raw, RenderArguments& arguments) {
  if (raw.backend) return;
  if (arguments.build.triangle_test != TriangleTest::woop)
    throw UsageError("--triangle-test=moller-trumbore does not go with --accel=check");
  if (arguments.plant_difference) {
    arguments.check_with = {"bvh moller-trumbore", Backend::bvh, arguments.build};
    arguments.check_with->build.triangle_test = TriangleTest::moller_trumbore;
    return;
  }
  const std::string name = raw.check_with.empty() ? check_choices().front().first : raw.check_with;
  arguments.check_with = named_engine(name, arguments.build);
  if (arguments.check_with->backend == Backend::bvh &&
      arguments.check_with->build.bvh_width == arguments.build.bvh_width)
    throw UsageError(
        fmt::format("--check-with={}: that is the engine which is checked; render with --bvh-width=8", name));
}

/// Options of the wide tree and of the leaves that Embree shares with it.
void check_wide_options(const RenderArguments& arguments) {
  const BuildOptions& build = arguments.build;
  const bool is_wide = arguments.backend == Backend::bvh && build.bvh_width == 8;
  if (build.simd != "best" && !is_wide && arguments.backend != Backend::embree)
    throw UsageError("--simd goes with --accel=embree, and with --accel=bvh of --bvh-width=8");
  if (build.bvh_quality != BuildOptions{}.bvh_quality && !is_wide)
    throw UsageError("--bvh-quality goes with --accel=bvh and --bvh-width=8");
}

void resolve(const RawArguments& raw, RenderArguments& arguments) {
  RenderOptions& render = arguments.render;
  render.width = raw.resolution[0];
  render.height = raw.resolution[1];
  if (render.width < 1 || render.width > max_frame || render.height < 1 || render.height > max_frame)
    throw UsageError(fmt::format("--resolution: {} x {}; each side must have 1 to {} pixels", render.width,
                                 render.height, max_frame));
  if (!raw.crop.empty()) render.window = window_of(raw.crop, render.width, render.height);
  if (!raw.adaptive.empty()) render.adaptive = parse_adaptive(raw.adaptive);
  if (raw.hemisphere) arguments.path.direct = DirectMethod::hemisphere;
  if (arguments.integrator == IntegratorKind::direct)
    arguments.path.max_depth = std::min(arguments.path.max_depth, 1);
  arguments.path.roulette = parse_roulette(raw.roulette);
  choose_bounces(raw.bounces, arguments.path);
  arguments.build.threads = render.threads;
  choose_backend(raw, arguments);
  check_builder(arguments);
  choose_cost(raw.cost, arguments);
  choose_width(raw.bvh_width, arguments);
  check_wide_options(arguments);
  choose_check(raw, arguments);
  if (arguments.build.triangle_test == TriangleTest::moller_trumbore && arguments.backend != Backend::bvh &&
      arguments.backend != Backend::brute_force)
    throw UsageError("--triangle-test=moller-trumbore goes with --accel=bvh and --accel=brute-force");
}

}  // namespace

std::string usage_line() {
  return "usage: twinray [render] SCENE.dae [options]; all options: twinray --help";
}

std::optional<RenderArguments> parse_render_arguments(const std::vector<std::string>& words) {
  RenderArguments arguments;
  arguments.render.samples = 32;
  RawArguments raw;
  CLI::App app("Renders a COLLADA scene by path tracing.", "twinray");
  app.formatter(std::make_shared<BriefFormatter>());
  app.footer("Other commands: twinray agreement, crosscheck and stats; each has its --help.");
  app.option_defaults()->take_last()->always_capture_default(false);
  app.add_option("SCENE", arguments.scene, "The scene, a COLLADA file (.dae)")->required()->type_name("");
  add_picture_options(app, arguments, raw);
  add_light_options(app, arguments, raw);
  add_sampling_options(app, arguments, raw);
  add_engine_options(app, arguments, raw);
  add_run_options(app, arguments);
  app.set_version_flag("--version", version_text(), "Print versions, engines, instruction sets")
      ->group("Run");
  app.set_help_flag("-h,--help", "Print this help")->group("Run");
  try {
    app.parse(
        std::vector<std::string>(words.rbegin(), words.rend()));  // CLI11 takes the words last one first
  } catch (const CLI::CallForHelp&) {
    console::write(app.help());
    return std::nullopt;
  } catch (const CLI::CallForVersion&) {
    console::write(version_text());
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    throw UsageError(error.what());
  }
  resolve(raw, arguments);
  return arguments;
}

}  // namespace twinray
