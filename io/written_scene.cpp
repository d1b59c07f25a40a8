// SPDX-License-Identifier: Apache-2.0
#include "io/written_scene.h"

#include <fmt/format.h>

#include <filesystem>
#include <utility>
#include <variant>

#include "io/output_file.h"

namespace twinray {

bool is_textured(const Scene& scene, const ShapeBinding& binding) {
  const Material& material = scene.materials[binding.material];
  const bool has_holes = binding.alpha != no_texture &&
                         !std::holds_alternative<ConstantTexture>(scene.textures[binding.alpha].model);
  return has_holes || !material.textures.empty() || material.normal_map != no_texture ||
         material.bump_map != no_texture;
}

std::string name_of_file(const std::string& path) { return std::filesystem::path(path).filename().string(); }

std::string SceneOutput::add(const std::string& suffix, std::function<void(const std::string& path)> write) {
  const std::string path = path_.substr(0, path_.rfind('.')) + suffix;
  files_.push_back({path, std::move(write)});
  return name_of_file(path);
}

WrittenScene SceneOutput::finish(std::string bytes) {
  files_.push_back({path_, [bytes = std::move(bytes)](const std::string& path) { write_file(path, bytes); }});
  return {std::move(files_), losses.lines(path_)};
}

std::string UniqueNames::unique(const std::string& name, const std::string& otherwise) {
  const std::string wanted = name.empty() ? otherwise : name;
  std::string found = wanted;
  while (used_.count(found) > 0) found = fmt::format("{} {}", wanted, ++used_[wanted]);
  used_[found] = 1;
  return found;
}

}  // namespace twinray
