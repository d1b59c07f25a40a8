// SPDX-License-Identifier: Apache-2.0
#include "io/generated/generated.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <string>

#include "core/error.h"

namespace twinray::generated {
namespace {

constexpr std::string_view prefix = "generated:";

std::string valid_names() {
  std::string names;
  for (const GeneratedScene& scene : generated_scenes()) names += fmt::format("{}{}, ", prefix, scene.name);
  return names + "each with :N behind it for N triangles";
}

}  // namespace

std::span<const GeneratedScene> generated_scenes() {
  static constexpr std::array<GeneratedScene, 3> all{
      {{"room", 600'000, make_room}, {"ball", 900'000, make_ball}, {"forest", 2'000'000, make_forest}}};
  return all;
}

bool is_generated(std::string_view name) { return name.starts_with(prefix); }

Scene make_generated(std::string_view name) {
  const std::string_view rest = name.substr(std::min(prefix.size(), name.size()));
  const std::size_t colon = std::min(rest.find(':'), rest.size());
  for (const GeneratedScene& scene : generated_scenes()) {
    if (rest.substr(0, colon) != scene.name) continue;
    if (colon == rest.size()) return scene.make(scene.triangles);
    const std::string_view size = rest.substr(colon + 1);
    std::size_t triangles = 0;
    const auto [end, error] = std::from_chars(size.data(), size.data() + size.size(), triangles);
    if (error != std::errc() || end != size.data() + size.size())
      throw Error(
          fmt::format("{}: \"{}\" is not a number of triangles, such as {}", name, size, scene.triangles));
    return scene.make(triangles);
  }
  throw Error(fmt::format("{}: there is no such scene; valid are {}", name, valid_names()));
}

}  // namespace twinray::generated
