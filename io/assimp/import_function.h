// SPDX-License-Identifier: Apache-2.0
// Private: what the library that has Assimp offers to io/assimp/scene_importer.cpp.
#pragma once
#include <string>
#include <string_view>

#include "io/obj/reader.h"

namespace twinray {

/// What is to be imported: the bytes of a file, and its path, which tells the format and where its pictures
/// are.
struct ImportedFile {
  std::string path;
  std::string_view bytes;
};

/// Sets the model, or throws Error, without the path. Its name has a digest of the headers of these types.
using ImportFunction = void (*)(const ImportedFile& file, ObjModel& model);

}  // namespace twinray
