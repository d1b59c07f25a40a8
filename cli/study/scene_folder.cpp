// SPDX-License-Identifier: Apache-2.0
#include "cli/study/scene_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "core/error.h"
#include "io/scene_file.h"

namespace twinray::study {
namespace {

namespace fs = std::filesystem;

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return text;
}

/// Throws Error with the reason where its list of files cannot be read. Folders below it may be closed.
void check_folder(const std::string& folder) {
  std::error_code error;
  const fs::file_type type = fs::status(folder, error).type();
  if (type != fs::file_type::none && type != fs::file_type::directory)
    throw Error(fmt::format("{}: there is no such folder", folder));
  if (type == fs::file_type::directory) fs::directory_iterator(folder, error);
  if (error) throw Error(fmt::format("{}: this folder cannot be read: {}", folder, error.message()));
}

std::vector<fs::path> scene_files(const std::string& folder) {
  std::vector<fs::path> files;
  const auto options = fs::directory_options::skip_permission_denied;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder, options))
    if (entry.is_regular_file() && lower(entry.path().extension().string()) == ".dae")
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

/// "sky/CBbunny.dae" of a folder -> "CBbunny", or "sky_CBbunny" where that is taken, or "sky_CBbunny_2", ...
std::string scene_name(const fs::path& file, const SceneFolder& folder) {
  const std::string name = file.stem().string();
  if (!folder.find(name)) return name;
  std::string whole = file.lexically_relative(folder.path).replace_extension().string();
  std::replace(whole.begin(), whole.end(), '/', '_');
  std::string free = whole;
  for (int number = 2; folder.find(free); ++number) free = fmt::format("{}_{}", whole, number);
  return free;
}

bool has_only_point_lights(const Scene& scene) {
  return !scene.lights.empty() &&
         std::all_of(scene.lights.begin(), scene.lights.end(),
                     [](const Light& light) { return std::holds_alternative<PointLight>(light.source); });
}

}  // namespace

const FoundScene* SceneFolder::find(const std::string& name) const {
  for (const FoundScene& scene : scenes)
    if (lower(scene.name) == lower(name)) return &scene;
  return nullptr;
}

SceneFolder read_scene_folder(const std::string& path) {
  check_folder(path);
  SceneFolder folder{path, {}, {}};
  for (const fs::path& file : scene_files(path)) try {
      const LoadedScene loaded = load_scene(file.string());
      folder.scenes.push_back({scene_name(file, folder), file.string(),
                               loaded.summary.triangles + loaded.summary.spheres,
                               has_only_point_lights(loaded.scene)});
    } catch (const Error& error) {  // One broken file must not end a study of many; it is named in the page.
      folder.unreadable.push_back({file.string(), error.what()});
    }
  if (!folder.scenes.empty()) return folder;
  if (!folder.unreadable.empty()) throw Error(folder.unreadable.front().reason);
  throw Error(fmt::format("{}: no COLLADA scene (.dae) is in this folder or below it", path));
}

}  // namespace twinray::study
