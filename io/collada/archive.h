// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "io/load_options.h"
#include "io/loaded_scene.h"

namespace twinray {

/// Reads a .zae archive (Khronos, "COLLADA - Digital Asset Schema Release 1.5.0", 2008): a zip archive whose
/// manifest.xml names the document to start with in its <dae_root>; documents may refer to each other within
/// the archive, and to nothing outside. Without a manifest an archive's only document is read, with a
/// warning. Messages name a file in it "archive.zae/folder/file.dae". Throws Error as read_collada() does,
/// and for an archive that is damaged, or whose files would be too large (io/zip_archive.h).
LoadedScene read_zae(const std::string& path, const LoadOptions& options);

}  // namespace twinray
