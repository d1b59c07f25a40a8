// SPDX-License-Identifier: Apache-2.0
#include "io/scene_writer.h"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <string_view>

#include "core/error.h"
#include "io/exchange/writer.h"
#include "io/gltf/writer.h"
#include "io/pbrt/writer.h"
#include "io/utf8.h"

namespace twinray {
namespace {

struct WrittenFormat {
  std::string_view ending;
  WrittenScene (*written)(const SceneToWrite&, const std::string& path);
};
constexpr std::array<WrittenFormat, 4> written_formats{
    {{".json", written_exchange}, {".pbrt", written_pbrt}, {".gltf", written_gltf}, {".glb", written_gltf}}};

/// The exchange form names the files beside it, after itself, in JSON.
void check_name(const std::string& name, const WrittenFormat& format) {
  if (format.written == written_exchange && !is_utf8(name))
    throw Error(
        fmt::format("{}: this name is not UTF-8, as all names in JSON are, which names the files beside it "
                    "after it; give it another one",
                    name));
}

const WrittenFormat& format_of(const std::string& path) {
  const std::string name = name_of_file(path);
  for (const WrittenFormat& format : written_formats)
    if (name.size() > format.ending.size() && name.ends_with(format.ending)) {
      check_name(name, format);
      return format;
    }
  throw Error(
      fmt::format("{}: a scene is written to a file whose name ends in .json, .pbrt, .gltf or .glb; other "
                  "files of it are put beside it",
                  path));
}

/// Files that were not there before: unless they are kept, they go.
class NewFiles {
 public:
  NewFiles() = default;
  ~NewFiles() {
    std::error_code ignored;
    for (const std::string& path : paths_) std::filesystem::remove(path, ignored);
  }
  NewFiles(const NewFiles&) = delete;
  NewFiles& operator=(const NewFiles&) = delete;

  /// Before a file is written.
  void note(const std::string& path) {
    std::error_code ignored;
    const std::filesystem::file_type type = std::filesystem::symlink_status(path, ignored).type();
    if (type == std::filesystem::file_type::not_found) paths_.push_back(path);
  }
  void keep() { paths_.clear(); }

 private:
  std::vector<std::string> paths_;
};

}  // namespace

void check_scene_output(const std::string& path) { format_of(path); }

WrittenScene written_scene(const SceneToWrite& input, const std::string& path) {
  return format_of(path).written(input, path);
}

void write_files(const WrittenScene& written) {
  NewFiles added;
  for (const auto& [path, write] : written.files) {
    added.note(path);
    write(path);
  }
  added.keep();
}

}  // namespace twinray
