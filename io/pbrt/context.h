// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "io/diagnostic.h"
#include "io/load_options.h"
#include "io/pbrt/files.h"

namespace twinray {

/// What all parts of the reader share.
struct PbrtContext {
  PbrtFiles files;
  LoadOptions options;
  WarningList warnings{options.strict};
  bool has_fibres = false;              ///< Of the current material: its curves are round.
  std::vector<std::string> notes = {};  ///< Of the summary: decisions that change the picture little.
};

}  // namespace twinray
