// SPDX-License-Identifier: Apache-2.0
#include "io/scene_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

#include "io/collada.h"
#include "io/collada_archive.h"
#include "io/generated/generated.h"
#include "io/gltf.h"
#include "io/pbrt_scene.h"
#include "io/xml_reader.h"

namespace twinray {

namespace {

/// In lower case; "scene.pbrt.gz" has both.
std::string scene_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  if (extension.size() == 3) extension = path.stem().extension().string() + extension;
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return char(std::tolower(static_cast<unsigned char>(c))); });
  return extension;
}

bool is_known(const std::string& extension) {
  constexpr std::array known{".dae", ".zae", ".pbrt", ".pbrt.gz", ".gltf", ".glb"};
  return std::find(known.begin(), known.end(), extension) != known.end();
}

LoadedScene load_generated(const std::string& name) {
  LoadedScene loaded{.scene = generated::make_generated(name)};
  loaded.summary.camera = name;
  count_scene(loaded.scene, loaded.summary);
  return loaded;
}

}  // namespace

LoadedScene load_scene(const std::string& path, const LoadOptions& options) {
  if (generated::is_generated(path)) return load_generated(path);
  const std::string extension = scene_extension(path);
  std::error_code error;
  const bool is_file = std::filesystem::exists(path, error) && !std::filesystem::is_directory(path, error);
  if (is_file && !is_known(extension))
    throw Error(
        fmt::format("{}: \"{}\" is not the extension of a scene file; valid are .dae and .zae (COLLADA), "
                    ".pbrt and .pbrt.gz, .gltf and .glb (glTF)",
                    path, extension));
  if (has_defaults(path)) return load_pbrt(path, options);
  if (extension == ".gltf" || extension == ".glb") return load_gltf(path, options);
  if (is_file && extension == ".zae") return read_zae(path, options);
  return read_collada(*XmlDocument::load(path), options);
}

bool has_defaults(const std::string& path) {
  const std::string extension = scene_extension(path);
  return extension == ".pbrt" || extension == ".pbrt.gz";
}

bool is_scene_file(const std::string& path) {
  const std::string extension = scene_extension(path);
  if (!is_known(extension)) return false;
  if (!has_defaults(path)) return true;
  try {
    return read_unpacked(path).find("WorldBegin") != std::string::npos;
  } catch (const Error&) {
    return true;  // whoever reads it says what is wrong
  }
}

}  // namespace twinray
