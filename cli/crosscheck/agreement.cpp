// SPDX-License-Identifier: Apache-2.0
#include "cli/crosscheck/agreement.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "check/difference.h"
#include "integrators/ambient_occlusion.h"
#include "integrators/furnace.h"
#include "integrators/normals.h"
#include "integrators/path.h"
#include "integrators/render.h"

namespace twinray {
namespace {

constexpr std::array<std::pair<const char*, SamplerKind>, 2> samplers{
    {{"sobol", SamplerKind::sobol}, {"independent", SamplerKind::independent}}};

/// Rays of one sample by all integrators together, roughly.
constexpr double rays_per_sample = 22;

using NamedIntegrators = std::vector<std::pair<std::string, std::unique_ptr<Integrator>>>;

NamedIntegrators integrators_of(const Scene& scene) {
  const PathOptions by_lights{.max_depth = 1, .direct = DirectMethod::lights};
  const PathOptions by_hemisphere{.max_depth = 1, .direct = DirectMethod::hemisphere};
  NamedIntegrators all;
  all.emplace_back("normals", std::make_unique<NormalsIntegrator>(scene));
  all.emplace_back("ambient occlusion", std::make_unique<AmbientOcclusionIntegrator>(scene));
  all.emplace_back("furnace", std::make_unique<FurnaceIntegrator>(scene, PathOptions{}.max_depth));
  all.emplace_back("direct by lights", std::make_unique<PathIntegrator>(scene, by_lights));
  all.emplace_back("direct by hemisphere", std::make_unique<PathIntegrator>(scene, by_hemisphere));
  all.emplace_back("path", std::make_unique<PathIntegrator>(scene, PathOptions{}));
  return all;
}

/// The middle of the frame, as large as brute force can afford; at least one pixel.
PixelRect affordable_window(const Scene& scene, const AgreementOptions& options) {
  const double primitives = double(scene.geometry->seen_primitives());
  const double renders_of_each = double(samplers.size() * AgreementEngine{}.threads.size());
  const double tests_per_pixel = primitives * options.samples * rays_per_sample * renders_of_each;
  const double affordable = options.brute_force_tests / std::max(1.0, tests_per_pixel);
  const double all = double(options.width) * options.height,
               side = std::sqrt(std::min(1.0, affordable / all));
  const int width = std::max(1, int(side * options.width)), height = std::max(1, int(side * options.height));
  const int x = (options.width - width) / 2, y = (options.height - height) / 2;
  return {x, y, x + width, y + height};
}

class SceneComparison {
 public:
  SceneComparison(const Scene& scene, const AgreementOptions& options,
                  const std::function<void(std::size_t, std::size_t)>& progress)
      : scene_(scene), options_(options), progress_(progress), crop_(affordable_window(scene, options)) {
    result_.brute_force_pixels = crop_.width() * crop_.height();
    for (const AgreementEngine& engine : options.engines)
      accelerators_.push_back(build_accelerator(engine.backend, scene.geometry, engine.build));
  }

  SceneAgreement run() {
    const NamedIntegrators integrators = integrators_of(scene_);
    std::size_t renders_of_a_kind = 0;
    for (const AgreementEngine& engine : options_.engines) renders_of_a_kind += engine.threads.size();
    renders_in_all_ = integrators.size() * samplers.size() * renders_of_a_kind;
    for (const auto& [integrator_name, integrator] : integrators)
      for (const auto& [sampler_name, sampler] : samplers)
        compare_all(*integrator, sampler, fmt::format("{}, {}", integrator_name, sampler_name));
    return std::move(result_);
  }

 private:
  void compare_all(const Integrator& integrator, SamplerKind sampler, const std::string& kind) {
    std::optional<RenderResult> first;
    for (std::size_t engine = 0; engine < options_.engines.size(); ++engine)
      for (const int threads : options_.engines[engine].threads) {
        RenderResult found = render_once(engine, integrator, sampler, threads);
        if (first)
          compare(*first, found, integrator, sampler,
                  fmt::format("{}, {}, threads {}", kind, options_.engines[engine].name, threads));
        else
          first = std::move(found);
      }
  }

  RenderResult render_once(std::size_t engine, const Integrator& integrator, SamplerKind sampler,
                           int threads) {
    RenderOptions render_options = options_for(sampler, threads);
    if (options_.engines[engine].backend == Backend::brute_force) render_options.window = crop_;
    RenderResult result = render(scene_, *accelerators_[engine], integrator, render_options);
    const PixelRect& window = result.film.window();
    result_.pixels += std::uint64_t(window.width()) * std::uint64_t(window.height());
    result_.rays += result.rays.total();
    ++result_.renders;
    if (progress_) progress_(result_.renders, renders_in_all_);
    return result;
  }

  void compare(const RenderResult& first, const RenderResult& found, const Integrator& integrator,
               SamplerKind sampler, const std::string& name) {
    auto difference = first_difference(first.film, found.film);
    if (!difference)
      difference = first_difference(expected_rays(first, found, integrator, sampler), found.rays);
    if (difference) result_.differences.push_back(name + ": " + *difference);
  }

  /// The first engine's rays for the window of another render.
  RayCounts expected_rays(const RenderResult& first, const RenderResult& found, const Integrator& integrator,
                          SamplerKind sampler) const {
    if (first.film.window() == found.film.window()) return first.rays;
    RenderOptions render_options = options_for(sampler, 1);
    render_options.window = found.film.window();
    return render(scene_, *accelerators_.front(), integrator, render_options).rays;
  }

  RenderOptions options_for(SamplerKind sampler, int threads) const {
    return {.width = options_.width,
            .height = options_.height,
            .samples = options_.samples,
            .sampler = sampler,
            .seed = options_.seed,
            .threads = threads};
  }

  const Scene& scene_;
  const AgreementOptions& options_;
  const std::function<void(std::size_t, std::size_t)>& progress_;
  PixelRect crop_;
  std::vector<std::unique_ptr<Accelerator>> accelerators_;
  std::size_t renders_in_all_ = 0;
  SceneAgreement result_;
};

/// Of these names, those that this build has.
std::vector<AgreementEngine> engines_named(const std::vector<std::string>& names,
                                           const std::vector<int>& threads) {
  std::vector<AgreementEngine> engines;
  for (const std::string& name : names)
    if (const auto engine = find_engine(name)) engines.push_back({*engine, threads});
  return engines;
}

/// The wide tree and embree with the instruction sets that are not their default.
std::vector<AgreementEngine> masked_engines() {
  std::vector<std::string> names;
  for (const std::string& simd : available_instruction_sets()) names.push_back("bvh-" + simd);
  for (const char* isa : {"sse2", "sse4.2", "avx", "avx512", "default"})
    names.push_back(fmt::format("embree-{}", isa));
  for (const std::string& simd : available_instruction_sets()) names.push_back("embree-leaf-" + simd);
  return engines_named(names, {2});
}

}  // namespace

std::vector<AgreementEngine> canonical_engines() {
  return engines_named({"bvh-2", "bvh-2-median", "bvh-2-midpoint", "bvh-2-mean", "bvh-2-embree-low",
                        "bvh-2-embree-medium", "bvh-2-embree-high", "bvh", "embree", "brute-force"},
                       AgreementEngine{}.threads);
}

std::vector<AgreementEngine> agreement_engines() {
  std::vector<AgreementEngine> engines = canonical_engines();
  const std::vector<AgreementEngine> masked = masked_engines();
  engines.insert(engines.end() - 1, masked.begin(), masked.end());
  return engines;
}

AgreementEngine differing_engine() { return {named_engine("bvh-moller-trumbore")}; }

SceneAgreement compare_engines(const Scene& scene, const AgreementOptions& options,
                               const std::function<void(std::size_t, std::size_t)>& progress) {
  return SceneComparison(scene, options, progress).run();
}

}  // namespace twinray
