// SPDX-License-Identifier: Apache-2.0
#include "cli/film/render_identity.h"

#include <algorithm>
#include <iterator>
#include <string_view>

#include "cli/version.h"

namespace twinray {
namespace {

/// They say what is made of the samples, how many there are, or who makes them.
constexpr std::string_view free_options[] = {
    "--output", "--samples", "--of", "--sample-range", "--tile-range", "--seconds", "--until",
    "--noise-target", "--denoise", "--denoise-light-groups", "--exposure", "--white-balance", "--tone",
    "--ocio-view", "--ocio-display", "--exr-compression", "--texture-memory", "--threads", "--count",
    "--stats", "--tev", "--serve", "--progress", "--metrics-file", "--sandbox", "--memory", "--time-limit",
    "--strict", "--quiet", "--checkpoint", "--checkpoint-seconds", "--resume",
    // Their files count, and not their names.
    "--environment", "--camera"};
/// All canonical engines make the same samples.
constexpr std::string_view engine_options[] = {
    "--accel",       "--simd",       "--bvh-width",     "--bvh-quality",    "--bvh-split",
    "--bvh-builder", "--bvh-bins",   "--max-leaf-size", "--traversal-cost", "--intersection-cost",
    "--embree-mode", "--embree-isa", "--memory-mode",   "--triangle-test"};

template <std::size_t count>
bool is_among(const std::string_view (&options)[count], const std::string& name) {
  return std::find(std::begin(options), std::end(options), name) != std::end(options);
}

/// Whether the option's word says what holds without it, too, or makes the same samples: path-reference is
/// path. A scene file may have another number of bounces.
bool is_default(const RenderArguments& arguments, const std::string& name) {
  if (name == "--integrator" && arguments.integrator == IntegratorKind::path_reference) return true;
  if (name == "--max-depth" && has_defaults(arguments.scene)) return false;
  return std::find(arguments.given_defaults.begin(), arguments.given_defaults.end(), name) !=
         arguments.given_defaults.end();
}

}  // namespace

RenderIdentity render_identity(const RenderArguments& arguments, const InputFiles& inputs) {
  RenderIdentity identity{.program = version_name(),
                          .files = inputs,
                          .options = {},
                          .width = arguments.render.width,
                          .height = arguments.render.height,
                          .window = window_of(arguments.render)};
  for (const auto& [name, words] : arguments.given_words)
    if (is_among(engine_options, name) ? depends_on_engine(arguments)
                                       : !is_among(free_options, name) && !is_default(arguments, name))
      identity.options.emplace(name, words);
  return identity;
}

}  // namespace twinray
