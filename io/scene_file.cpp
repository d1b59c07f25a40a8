// SPDX-License-Identifier: Apache-2.0
#include "io/scene_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <string_view>

#include "core/interiors.h"
#include "io/assimp/scene_importer.h"
#include "io/collada/archive.h"
#include "io/collada/collada.h"
#include "io/exchange/reader.h"
#include "io/generated/generated.h"
#include "io/gltf/gltf.h"
#include "io/gzip.h"
#include "io/lower_case.h"
#include "io/obj/scene.h"
#include "io/pbrt/scene.h"
#include "io/ply/scene.h"
#include "io/stl/scene.h"
#include "io/three_mf/scene.h"
#include "io/xml/reader.h"

namespace twinray {

namespace {

/// In lower case; "scene.pbrt.gz" has both.
std::string scene_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  if (extension.size() == 3) extension = path.stem().extension().string() + extension;
  return lower_case(extension);
}

LoadedScene load_dae(const std::string& path, const LoadOptions& options) {
  return read_collada(*XmlDocument::load(path), options);
}

/// A format by its extension.
struct Format {
  std::string_view extension;
  const char* name;
  LoadedScene (*load)(const std::string& path, const LoadOptions& options);
  bool chooses_camera = false;  ///< Whether files have several, of which LoadOptions::camera_name is one.
};
constexpr std::array formats{Format{".dae", "COLLADA", load_dae, true},
                             Format{".zae", "COLLADA", read_zae, true},
                             Format{".pbrt", "pbrt-v4", load_pbrt},
                             Format{".pbrt.gz", "pbrt-v4", load_pbrt},
                             Format{".gltf", "glTF 2.0", load_gltf, true},
                             Format{".glb", "glTF 2.0", load_gltf, true},
                             Format{".json", "twinray's exchange form", load_exchange},
                             Format{".obj", "Wavefront", load_obj},
                             Format{".ply", "a mesh", load_ply},
                             Format{".ply.gz", "a mesh", load_ply},
                             Format{".stl", "STL", load_stl},
                             Format{".3mf", "3MF", load_three_mf},
                             Format{".fbx", "by Assimp", import_scene},
                             Format{".3ds", "by Assimp", import_scene},
                             Format{".off", "by Assimp", import_scene},
                             Format{".x", "by Assimp", import_scene},
                             Format{".lwo", "by Assimp", import_scene},
                             Format{".ase", "by Assimp", import_scene},
                             Format{".ac", "by Assimp", import_scene},
                             Format{".dxf", "by Assimp", import_scene},
                             Format{".amf", "by Assimp", import_scene},
                             Format{".x3d", "by Assimp", import_scene}};

/// Null for no known extension.
const Format* find_format(const std::string& extension) {
  const auto found = std::find_if(formats.begin(), formats.end(),
                                  [&](const Format& format) { return format.extension == extension; });
  return found == formats.end() ? nullptr : &*found;
}

[[noreturn]] void refuse_format(const std::string& path, const std::string& extension) {
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
  loaded.summary.cameras = {name};
  count_scene(loaded.scene, loaded.summary);
  return loaded;
}

/// Of a file whose camera is the only one.
LoadedScene with_camera_named(const std::string& name, LoadedScene loaded, const std::string& path) {
  const std::vector<std::string>& cameras = loaded.summary.cameras;
  if (name.empty() || std::find(cameras.begin(), cameras.end(), name) != cameras.end()) return loaded;
  throw Error(fmt::format(
      "{}: no camera has the name \"{}\"; {}", path, name,
      cameras.empty() ? "the scene has no camera" : fmt::format("the scene has \"{}\"", cameras[0])));
}

LoadedScene load_by_name(const std::string& path, const LoadOptions& options) {
  if (generated::is_generated(path))
    return with_camera_named(options.camera_name, load_generated(path), path);
  const std::string extension = scene_extension(path);
  const Format* const format = find_format(extension);
  std::error_code error;
  const bool is_file = std::filesystem::exists(path, error) && !std::filesystem::is_directory(path, error);
  if (is_file && !format) refuse_format(path, extension);
  if (!format || format->chooses_camera) return (format ? format->load : load_dae)(path, options);
  return with_camera_named(options.camera_name, format->load(path, options), path);
}

/// What shows nothing is a picture of the background. Readers that know where the shapes would stand say so
/// themselves.
void warn_of_nothing(const std::string& path, bool is_strict, LoadedScene& loaded) {
  constexpr const char* message = "the scene has no shapes";
  const auto is_said = [](const Diagnostic& warning) { return warning.message == message; };
  if (loaded.scene.geometry->primitive_count() > 0 ||
      std::any_of(loaded.warnings.begin(), loaded.warnings.end(), is_said))
    return;
  if (is_strict) throw Error(fmt::format("{}: {}", path, message));
  loaded.warnings.push_back({{path}, message});
}

}  // namespace

LoadedScene load_scene(const std::string& path, const LoadOptions& options) {
  LoadedScene loaded = load_by_name(path, options);
  warn_of_nothing(path, options.strict, loaded);
  forget_clear_interiors(loaded.scene.materials);
  return loaded;
}

bool is_collada(const std::string& path) {
  if (generated::is_generated(path)) return false;
  const Format* const format = find_format(scene_extension(path));
  return !format || format->name == std::string_view("COLLADA");
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
