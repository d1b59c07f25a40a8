// SPDX-License-Identifier: Apache-2.0
#include "io/stl/scene.h"

#include "io/input_file.h"
#include "io/obj/scene.h"
#include "io/stl/reader.h"

namespace twinray {

LoadedScene load_stl(const std::string& path, const LoadOptions& options) {
  options.add_file(path);
  WarningList warnings(options.strict);
  return make_scene(read_stl(read_input_file(path, "scene file"), path, warnings), options, warnings);
}

}  // namespace twinray
