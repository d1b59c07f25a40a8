// SPDX-License-Identifier: Apache-2.0
#include "cli/scene_names.h"

#include <fmt/format.h>

namespace twinray {
namespace {

std::string or_number(const std::string& name, const char* kind, std::size_t index) {
  return name.empty() ? fmt::format("{} {}", kind, index + 1) : name;
}

}  // namespace

SceneNames scene_names(const Scene& scene, const FilmContents& contents) {
  if (!contents.are_any()) return {};
  SceneNames names{{}, {}, {}, scene.light_groups};
  for (const Shape& shape : scene.geometry->shapes()) {
    const std::string& name = std::visit([](const auto& s) -> const std::string& { return s.name; }, shape);
    names.objects.push_back(or_number(name, "object", names.objects.size()));
  }
  names.assets = scene.assets;
  names.assets.insert(names.assets.end(), names.objects.begin(), names.objects.end());
  for (const Material& material : scene.materials)
    names.materials.push_back(or_number(material.name, "material", names.materials.size()));
  return names;
}

}  // namespace twinray
