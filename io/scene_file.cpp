// SPDX-License-Identifier: Apache-2.0
#include "io/scene_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <map>
#include <string_view>

#include "io/assimp/scene_importer.h"
#include "io/collada/archive.h"
#include "io/collada/collada.h"
#include "io/collada/xml_reader.h"
#include "io/exchange/reader.h"
#include "io/generated/generated.h"
#include "io/gltf/gltf.h"
#include "io/gzip.h"
#include "io/obj/scene.h"
#include "io/pbrt/scene.h"
#include "io/ply/scene.h"

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

LoadedScene load_dae(const std::string& path, const LoadOptions& options) {
  return read_collada(*XmlDocument::load(path), options);
}

/// A format by its extension.
struct Format {
  std::string_view extension;
  const char* name;
  LoadedScene (*load)(const std::string& path, const LoadOptions& options);
};
constexpr std::array formats{Format{".dae", "COLLADA", load_dae},
                             Format{".zae", "COLLADA", read_zae},
                             Format{".pbrt", "pbrt-v4", load_pbrt},
                             Format{".pbrt.gz", "pbrt-v4", load_pbrt},
                             Format{".gltf", "glTF 2.0", load_gltf},
                             Format{".glb", "glTF 2.0", load_gltf},
                             Format{".json", "twinray's exchange form", load_exchange},
                             Format{".obj", "Wavefront", load_obj},
                             Format{".ply", "a mesh", load_ply},
                             Format{".ply.gz", "a mesh", load_ply},
                             Format{".stl", "by Assimp", import_scene},
                             Format{".fbx", "by Assimp", import_scene},
                             Format{".3ds", "by Assimp", import_scene},
                             Format{".off", "by Assimp", import_scene},
                             Format{".x", "by Assimp", import_scene},
                             Format{".lwo", "by Assimp", import_scene},
                             Format{".ase", "by Assimp", import_scene},
                             Format{".ac", "by Assimp", import_scene},
                             Format{".dxf", "by Assimp", import_scene},
                             Format{".3mf", "by Assimp", import_scene},
                             Format{".amf", "by Assimp", import_scene},
                             Format{".x3d", "by Assimp", import_scene}};

/// Null for no known extension.
const Format* find_format(const std::string& extension) {
  const auto found = std::find_if(formats.begin(), formats.end(),
                                  [&](const Format& format) { return format.extension == extension; });
  return found == formats.end() ? nullptr : &*found;
}

[[noreturn]] void refuse(const std::string& path, const std::string& extension) {
  std::map<std::string_view, std::string> known;
  for (const Format& format : formats)
    known[format.name] += fmt::format("{}{}", known[format.name].empty() ? "" : " ", format.extension);
  std::string list;
  for (const auto& [name, extensions] : known)
    list += fmt::format("{}{} ({})", list.empty() ? "" : ", ", extensions, name);
  const bool is_usd = extension.starts_with(".usd");
  throw Error(fmt::format("{}: \"{}\" is not the extension of a scene file{}; valid are {}", path, extension,
                          is_usd ? ", for USD is not read yet" : "", list));
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
  const Format* const format = find_format(extension);
  std::error_code error;
  const bool is_file = std::filesystem::exists(path, error) && !std::filesystem::is_directory(path, error);
  if (is_file && !format) refuse(path, extension);
  return (format ? format->load : load_dae)(path, options);
}

bool has_defaults(const std::string& path) {
  const std::string extension = scene_extension(path);
  return extension == ".pbrt" || extension == ".pbrt.gz" || extension == ".json";
}

bool is_scene_file(const std::string& path) {
  const std::string extension = scene_extension(path);
  if (!find_format(extension) || extension.starts_with(".ply")) return false;
  if (!has_defaults(path)) return true;
  try {
    // Other files, such as statistics and parts of scenes, end alike.
    const char* const sign = extension == ".json" ? "\"twinray scene\"" : "WorldBegin";
    return read_unpacked(path).find(sign) != std::string::npos;
  } catch (const Error&) {
    return true;  // whoever reads it says what is wrong
  }
}

}  // namespace twinray
