// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <map>
#include <string>

#include "core/error.h"
#include "io/obj/scene.h"
#include "tests/support/error_text.h"

namespace twinray::test {

/// Reads an OBJ file, "scene.obj", that exists in memory alone, as its material files do. Pictures of
/// surfaces are not read.
inline LoadedScene load_obj_text(const std::string& text,
                                 const std::map<std::string, std::string>& files = {}, bool strict = false) {
  WarningList warnings(strict);
  LoadOptions options;
  options.pictures = std::make_shared<std::vector<PictureUse>>();
  const auto read = [&](const std::string& path) {
    if (path == "scene.obj") return text;
    const auto found = files.find(path);
    return found != files.end() ? found->second : throw Error(path + ": there is no such file");
  };
  return make_scene(read_obj("scene.obj", read, warnings), options, warnings);
}

/// What is said of a file that is not read.
inline std::string obj_error(const std::string& text) {
  return error_text([&] { load_obj_text(text); });
}

inline const Mesh& mesh_of(const LoadedScene& loaded, std::uint32_t shape = 0) {
  return *loaded.scene.geometry->mesh(shape);
}

/// Four vertices, around a square.
inline const std::string obj_square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

}  // namespace twinray::test
