// SPDX-License-Identifier: Apache-2.0
#include "io/generated/generated.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string>

#include "core/error.h"

namespace twinray::generated {
namespace {

constexpr std::string_view prefix = "generated:";

std::string valid_names() {
  std::string names;
  for (const auto& table : {generated_scenes(), instanced_scenes()})
    for (const GeneratedScene& scene : table) names += fmt::format("{}{}, ", prefix, scene.name);
  return names + "each with :N behind it for N triangles or, of the last two, instances";
}

}  // namespace

std::span<const GeneratedScene> generated_scenes() {
  static constexpr std::array<GeneratedScene, 3> all{{{"room", 600'000, least_room, make_room},
                                                      {"ball", 900'000, least_ball, make_ball},
                                                      {"forest", 2'000'000, least_forest, make_forest}}};
  return all;
}

std::span<const GeneratedScene> instanced_scenes() {
  static constexpr std::array<GeneratedScene, 2> all{
      {{"woods", 10'000, 1, make_woods}, {"stadium", 30'000, 1, make_stadium}}};
  return all;
}

bool is_generated(std::string_view name) { return name.starts_with(prefix); }

namespace {

/// The size behind a scene's name, if there is one.
std::size_t size_in(std::string_view name, std::string_view size, const char* unit,
                    const GeneratedScene& scene) {
  if (size.empty()) return scene.size;
  size.remove_prefix(1);
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(size.data(), size.data() + size.size(), number);
  if (error != std::errc() || end != size.data() + size.size())
    throw Error(fmt::format("{}: \"{}\" is not a number of {}, such as {}", name, size, unit, scene.size));
  return number;
}

}  // namespace

Scene make_generated(std::string_view name) {
  const std::string_view rest = name.substr(std::min(prefix.size(), name.size()));
  const std::size_t colon = std::min(rest.find(':'), rest.size());
  const auto try_table = [&](std::span<const GeneratedScene> table,
                             const char* unit) -> std::optional<Scene> {
    for (const GeneratedScene& scene : table)
      if (rest.substr(0, colon) == scene.name)
        return scene.make(size_in(name, rest.substr(colon), unit, scene));
    return std::nullopt;
  };
  if (auto scene = try_table(generated_scenes(), "triangles")) return *std::move(scene);
  if (auto scene = try_table(instanced_scenes(), "instances")) return *std::move(scene);
  throw Error(fmt::format("{}: there is no such scene; valid are {}", name, valid_names()));
}

}  // namespace twinray::generated
