// SPDX-License-Identifier: Apache-2.0
#include "cli/verify/scratch_folder.h"

#include <stdlib.h>

#include "core/error.h"

namespace twinray {

ScratchFolder::ScratchFolder() {
  std::error_code error;
  std::string name = (std::filesystem::temp_directory_path(error) / "twinray-verify-XXXXXX").string();
  if (error || !mkdtemp(name.data()))
    throw Error(name + ": no folder for temporary files can be made; TMPDIR names another place");
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace twinray
