// SPDX-License-Identifier: Apache-2.0
#include "io/scene_writer.h"

#include <fmt/format.h>

#include <array>
#include <string_view>

#include "core/error.h"
#include "io/exchange/writer.h"
#include "io/gltf/writer.h"
#include "io/pbrt/writer.h"

namespace twinray {
namespace {

struct WrittenFormat {
  std::string_view ending;
  WrittenScene (*written)(const SceneToWrite&, const std::string& path);
};
constexpr std::array<WrittenFormat, 4> written_formats{
    {{".json", written_exchange}, {".pbrt", written_pbrt}, {".gltf", written_gltf}, {".glb", written_gltf}}};

const WrittenFormat& format_of(const std::string& path) {
  const std::string name = name_of_file(path);
  for (const WrittenFormat& format : written_formats)
    if (name.size() > format.ending.size() && name.ends_with(format.ending)) return format;
  throw Error(
      fmt::format("{}: a scene is written to a file whose name ends in .json, .pbrt, .gltf or .glb; other "
                  "files of it are put beside it",
                  path));
}

}  // namespace

void check_scene_output(const std::string& path) { format_of(path); }

WrittenScene written_scene(const SceneToWrite& input, const std::string& path) {
  return format_of(path).written(input, path);
}

void write_files(const WrittenScene& written) {
  for (const auto& [path, write] : written.files) write(path);
}

}  // namespace twinray
