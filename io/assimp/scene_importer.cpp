// SPDX-License-Identifier: Apache-2.0
#include "io/assimp/scene_importer.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include "core/error.h"
#include "io/assimp/apart.h"
#include "io/assimp/import_function.h"
#include "io/assimp/model_bytes.h"
#include "io/input_file.h"
#include "io/obj/scene.h"
#include "io/picture/image_codec.h"

namespace twinray {
namespace {

/// Found beside the program as it was built or installed (its RPATH), or in LD_LIBRARY_PATH.
constexpr const char* library = TWINRAY_SCENE_IMPORTER;

/// Memory for a file: a model's lists are some times as large as the file, one that is packed many times.
constexpr std::uint64_t usual_bytes = std::uint64_t(1) << 30, most_growth = 64;

[[noreturn]] void fail(const std::string& reason) {
  throw Error(fmt::format("scenes of this format cannot be read: {}", reason));
}

/// All at once: a child loads nothing more.
ImportFunction load_importer() {
  void* const loaded = dlopen(library, RTLD_NOW | RTLD_LOCAL);
  if (!loaded) fail(dlerror());
  const auto import = reinterpret_cast<ImportFunction>(dlsym(loaded, TWINRAY_IMPORT_FUNCTION));
  if (!import) fail(fmt::format("{} is of another version of twinray", library));
  return import;
}

ImportFunction importer() {
  static const ImportFunction import = load_importer();
  return import;
}

}  // namespace

void load_scene_importer() { importer(); }

LoadedScene import_scene(const std::string& path, const LoadOptions& options) {
  options.add_file(path);
  const std::string bytes = read_input_file(path, "scene file");
  const ImportFunction import = importer();
  ApartResult result;
  {
    const std::lock_guard lock(library_loading());
    result = run_apart(usual_bytes + most_growth * bytes.size(), [&] {
      ObjModel model;
      import({path, bytes}, model);
      return model_bytes(model);
    });
  }
  if (!result.fault.empty()) throw Error(fmt::format("{}: {}", path, result.fault));
  WarningList warnings(options.strict);
  return make_scene(model_of_bytes(result.bytes), options, warnings);
}

}  // namespace twinray
