// SPDX-License-Identifier: Apache-2.0
#include "accel/fastest_engine.h"
#include "cli/options/render.h"

namespace twinray {
namespace {

constexpr Range<double> costs{1e-6, 1e6};

/// A render's engine, or that two are asked for each ray.
Choices<std::string> accel_choices() {
  Choices<std::string> choices = engine_choices();
  choices.emplace_back("check", "check");
  return choices;
}

bool is_check(const RenderRequest& request) { return request.accel == "check"; }

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

void add_engine_choice(OptionGroup& group, RenderRequest& request) {
  group.add_choice<std::string>("--accel", request.accel, accel_choices(), words_of(accel_choices(), ", "),
                                "NAME");
  group.add_choice<std::string>(
      "--check-with", request.check_with, check_choices(),
      fmt::format("The other ({}); NAME_differences.png shows both", check_choices().front().first),
      "ENGINE");
  group.add_flag("--plant-difference", request.arguments.plant_difference,
                 "check: with another triangle test; it must be found");
}

void add_bvh_options(OptionGroup& group, RenderRequest& request) {
  BuildOptions& build = request.arguments.build;
  group.add_choice<std::optional<int>>(
      "--bvh-width", request.bvh_width, {{"2", 2}, {"8", 8}},
      fmt::format("bvh: children of a node ({}; 2 to count)", build.bvh_width));
  group.add_choice<std::string>("--simd", build.simd, simd_choices(),
                                "Of paths, bvh of width 8, leaves of embree");
  group.add_choice<BvhQuality>(
      "--bvh-quality", build.bvh_quality,
      {{"fast", BvhQuality::fast}, {"medium", BvhQuality::medium}, {"high", BvhQuality::high}},
      "Build time against speed");
  group.add_choice<MemoryMode>("--memory-mode", build.memory_mode,
                               {{"ordinary", MemoryMode::ordinary}, {"compact", MemoryMode::compact}},
                               "compact: a bvh in half of the memory");
  group.add_choice<BvhSplit>("--bvh-split", build.bvh_split,
                             {{"sah", BvhSplit::sah},
                              {"median", BvhSplit::median},
                              {"midpoint", BvhSplit::midpoint},
                              {"mean", BvhSplit::mean}},
                             "How nodes are split");
  group.add_choice<BvhBuilder>("--bvh-builder", build.bvh_builder, builder_choices(),
                               words_of(builder_choices(), ", "), "NAME");
}

void add_cost_options(OptionGroup& group, BuildOptions& build) {
  group.add_number({"--bvh-bins", "N", "Bins of each axis, for sah"}, build.bvh_bins, {2, 256});
  group.add_number({"--max-leaf-size", "N", "Primitives of a leaf"}, build.max_leaf_size, {1, 255});
  group.add_number({"--traversal-cost", "C", "Cost of a node, for sah"}, build.traversal_cost, costs);
  group.add_number({"--intersection-cost", "C", "Cost of a primitive, for sah"}, build.intersection_cost,
                   costs);
}

void add_triangle_options(OptionGroup& group, BuildOptions& build) {
  group.add_choice<TriangleTest>(
      "--triangle-test", build.triangle_test,
      {{"woop", TriangleTest::woop}, {"moller-trumbore", TriangleTest::moller_trumbore}}, "bvh");
#ifdef TWINRAY_WITH_EMBREE
  group.add_choice<EmbreeMode>("--embree-mode", build.embree_mode,
                               {{"robust", EmbreeMode::robust}, {"fast", EmbreeMode::fast}}, "embree-native");
  Choices<std::string> isas;
  for (const char* isa : {"sse2", "sse4.2", "avx", "avx2", "avx512", "default"}) isas.emplace_back(isa, isa);
  group.add_choice<std::string>("--embree-isa", build.embree_isa, isas, words_of(isas, ", "), "ISA");
#endif
}

void choose_backend(const RenderRequest& request, RenderArguments& arguments) {
  if (is_check(request) && !request.check_with.empty() && arguments.plant_difference)
    throw UsageError("--plant-difference is an engine of its own; it does not go with --check-with");
  const bool counts = arguments.render.counting || arguments.integrator == IntegratorKind::cost;
  const bool is_compact = arguments.build.memory_mode == MemoryMode::compact;
  arguments.is_auto = request.accel == "auto" && !counts && !is_compact;
  arguments.engine_reason = request.accel != "auto" ? "named by --accel"
                            : counts                ? "its counts compare among all trees"
                                                    : "no other tree is compact";
  for (const Backend backend : available_backends())
    if (request.accel == backend_name(backend)) arguments.backend = backend;
}

void check_builder(const RenderArguments& arguments) {
  const BuildOptions& build = arguments.build;
  if (!arguments.is_auto && arguments.backend == Backend::bvh && build.bvh_builder != BvhBuilder::own &&
      build.max_leaf_size > 32)
    throw UsageError("--max-leaf-size: Embree's builders make leaves of up to 32 primitives");
}

/// Chooses what the integrator cost shows, which only counting queries tell.
void choose_cost(const std::optional<CostKind>& chosen, RenderArguments& arguments) {
  if (arguments.integrator != IntegratorKind::cost) {
    if (arguments.backend == Backend::embree_native) arguments.render.counting = false;
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
  if (build.triangle_test == TriangleTest::moller_trumbore) build.bvh_width = 2;  // It has no other tree.
  if (!arguments.is_auto && arguments.backend == Backend::bvh && build.bvh_width == 8 &&
      build.max_leaf_size > 4)
    throw UsageError("--max-leaf-size: a BVH of width 8 has leaves of up to 4; --bvh-width=2 takes more");
}

/// Chooses what the bvh is checked with, once its own options are known.
void choose_check(const RenderRequest& request, RenderArguments& arguments) {
  if (!is_check(request)) return;
  if (arguments.build.triangle_test != TriangleTest::woop)
    throw UsageError("--triangle-test=moller-trumbore does not go with --accel=check");
  if (arguments.plant_difference) {
    arguments.check_with = {"bvh-moller-trumbore", Backend::bvh, arguments.build, ""};
    arguments.check_with->build.triangle_test = TriangleTest::moller_trumbore;
    return;
  }
  const std::string name = request.check_with.empty() ? check_choices().front().first : request.check_with;
  arguments.check_with = named_engine(name, arguments.build);
  if (arguments.check_with->backend == Backend::bvh &&
      arguments.check_with->build.bvh_width == arguments.build.bvh_width)
    throw UsageError(
        fmt::format("--check-with={}: that is the engine which is checked; render with --bvh-width=8", name));
}

}  // namespace

void add_engine_options(CLI::App& app, RenderRequest& request) {
  OptionGroup group(app, "Ray engine");
  add_engine_choice(group, request);
  add_bvh_options(group, request);
  add_cost_options(group, request.arguments.build);
  add_triangle_options(group, request.arguments.build);
  add_instances(group, request.arguments.load);
}

void choose_engine(const Geometry& geometry, RenderArguments& arguments) {
  if (!arguments.is_auto) return;
  const EngineChoice choice =
      fastest_engine(geometry, {.threads = arguments.build.threads, .simd = arguments.build.simd});
  arguments.backend = choice.engine.backend;
  arguments.build = choice.engine.build;
  arguments.engine_reason = choice.reason;
}

std::string engine_name(const RenderArguments& arguments) {
  const bool is_binary = arguments.backend == Backend::bvh && arguments.build.bvh_width == 2;
  return is_binary ? "bvh-2" : backend_name(arguments.backend);
}

void resolve_engine(const RenderRequest& request, RenderArguments& arguments) {
  arguments.build.threads = arguments.render.threads;
  arguments.render.simd = arguments.build.simd;
  choose_backend(request, arguments);
  check_builder(arguments);
  choose_cost(request.cost, arguments);
  choose_width(request.bvh_width, arguments);
  choose_check(request, arguments);
}

}  // namespace twinray
