// SPDX-License-Identifier: Apache-2.0
#include "cli/shutter.h"

#include <fmt/format.h>

#include "cli/console.h"

namespace twinray {
namespace {

/// An option that needs a scene that stands still; null: there is none.
const char* still_option(const RenderArguments& arguments) {
  if (arguments.render.adaptive) return "--adaptive";
  if (arguments.render.allocation == Allocation::error) return "--allocation=error";
  return arguments.check_with ? "--accel=check" : nullptr;
}

}  // namespace

void check_shutter(const RenderArguments& arguments) {
  if (const char* const option = still_option(arguments); option && arguments.shutter)
    throw UsageError(
        fmt::format("--time: {} needs a scene that stands still, at one moment in place of two", option));
}

std::optional<Shutter> shutter_of(const RenderArguments& arguments, const LoadedScene& loaded) {
  if (!loaded.summary.animation) return {};
  if (arguments.load.time) return arguments.shutter;
  const char* const option = still_option(arguments);
  if (!option || !loaded.defaults.shutter) return loaded.defaults.shutter;
  console::warn(
      fmt::format("{}: nothing moves, all stands as when the shutter opens; --time=T says so", option));
  return {};
}

std::uint32_t usual_samples_per_moment(const Geometry& geometry) {
  constexpr std::size_t few_primitives = 20'000;
  return geometry.primitive_count() + geometry.instances().size() <= few_primitives ? 1 : 4;
}

}  // namespace twinray
