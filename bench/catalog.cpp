// SPDX-License-Identifier: Apache-2.0
#include "bench/catalog.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "bench/pattern.h"
#include "core/error.h"
#include "io/generated/generated.h"
#include "io/input_file.h"
#include "io/scene_file.h"

namespace twinray::bench {
namespace {

namespace fs = std::filesystem;

constexpr std::array<const char*, 6> well_known{
    "cow", "CBspheres_lambertian", "CBgems", "CBbunny", "CBlucy", "CBdragon"};

SceneSource from_file(const std::string& name, const std::string& path) {
  return {name, "",
          [path] {
            Scene scene = load_scene(path).scene;
            scene.camera = view_whole(fit_frame(scene.camera, 4, 3), scene.geometry->bounds());
            return scene;
          },
          path};
}

SceneSource from_maker(const generated::GeneratedScene& maker, std::size_t triangles,
                       const std::string& name) {
  return {name, maker.name, [maker, triangles] { return maker.make(triangles); }};
}

/// The scene files of a folder by name, in the order of their paths.
std::vector<std::pair<std::string, std::string>> files_of(const std::string& folder) {
  if (!fs::is_directory(folder)) throw Error(fmt::format("{} is not a folder of scenes", folder));
  std::vector<std::pair<std::string, std::string>> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && is_scene_file(entry.path().string()))
      files.push_back({entry.path().stem().string(), entry.path().string()});
  std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  return files;
}

void add_folder(std::vector<SceneSource>& all, const SceneChoice& choice) {
  if (choice.folder.empty()) return;
  const auto files = files_of(choice.folder);
  const auto add = [&](const auto& file) { all.push_back(from_file(file.first, file.second)); };
  const auto is_known = [](const std::string& name) {
    return std::find(well_known.begin(), well_known.end(), name) != well_known.end();
  };
  for (const char* name : well_known)
    for (const auto& file : files)
      if (file.first == name) add(file);
  if (!choice.is_full && choice.only.empty()) return;
  for (const auto& file : files)
    if (!is_known(file.first)) add(file);
}

void add_generated(std::vector<SceneSource>& all, const SceneChoice& choice) {
  for (const generated::GeneratedScene& maker : generated::generated_scenes())
    all.push_back(from_maker(maker, maker.size / choice.size_divisor, maker.name));
  if (choice.is_full || !choice.only.empty())
    for (const generated::GeneratedScene& maker : generated::instanced_scenes())
      all.push_back(from_maker(maker, maker.size / choice.size_divisor, maker.name));
  for (const generated::GeneratedScene& maker : generated::generated_scenes())
    for (const std::size_t size : choice.sizes) {
      const bool is_growth =
          maker.make == generated::make_forest || (choice.is_full && maker.make == generated::make_ball);
      if (size < maker.least && is_growth && choice.only.empty())
        throw UsageError(fmt::format("--sizes: the scene {} can have {} triangles and more, but not {}",
                                     maker.name, maker.least, size));
      if (size >= maker.least && (is_growth || !choice.only.empty()))
        all.push_back(from_maker(maker, size, fmt::format("{}-{}", maker.name, size)));
    }
}

bool matches(const std::string& name, const std::vector<Pattern>& patterns) {
  return patterns.empty() || std::any_of(patterns.begin(), patterns.end(),
                                         [&](const Pattern& pattern) { return pattern.matches(name); });
}

}  // namespace

std::vector<SceneSource> choose_scenes(const SceneChoice& choice) {
  const std::vector<Pattern> patterns(choice.only.begin(), choice.only.end());
  std::vector<SceneSource> all;
  all.push_back(from_file("box", choice.own_scenes + "/cornell-bunny.dae"));
  all.push_back(from_file("spheres", choice.own_scenes + "/spheres.dae"));
  add_folder(all, choice);
  add_generated(all, choice);
  std::vector<SceneSource> chosen;
  for (const SceneSource& source : all)
    if (matches(source.name, patterns)) chosen.push_back(source);
  for (const std::string& file : choice.files) {
    check_regular_file(file, "scene");  // Its turn comes last, after hours.
    chosen.push_back(from_file(fs::path(file).stem().string(), file));
  }
  if (chosen.empty()) throw UsageError("no scene has such a name");
  return chosen;
}

}  // namespace twinray::bench
