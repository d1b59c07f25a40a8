// SPDX-License-Identifier: Apache-2.0
#include "io/scene_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "io/collada.h"
#include "io/collada_archive.h"
#include "io/generated/generated.h"
#include "io/xml_reader.h"

namespace twinray {

namespace {

LoadedScene load_generated(const std::string& name) {
  LoadedScene loaded{.scene = generated::make_generated(name)};
  loaded.summary.camera = name;
  count_scene(loaded.scene, loaded.summary);
  return loaded;
}

}  // namespace

LoadedScene load_scene(const std::string& path, const LoadOptions& options) {
  if (generated::is_generated(path)) return load_generated(path);
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return char(std::tolower(static_cast<unsigned char>(c))); });
  std::error_code error;
  const bool is_file = std::filesystem::exists(path, error) && !std::filesystem::is_directory(path, error);
  if (is_file && extension != ".dae" && extension != ".zae")
    throw Error(
        fmt::format("{}: \"{}\" is not the extension of a scene file; valid are .dae and .zae (COLLADA)",
                    path, extension));
  if (is_file && extension == ".zae") return read_zae(path, options);
  return read_collada(*XmlDocument::load(path), options);
}

std::vector<std::string> scene_extensions() { return {".dae", ".zae"}; }

}  // namespace twinray
