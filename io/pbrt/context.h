// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/material.h"
#include "io/diagnostic.h"
#include "io/load_options.h"
#include "io/pbrt/files.h"

namespace twinray {

/// What all parts of the reader share.
struct PbrtContext {
  PbrtFiles files;
  LoadOptions options;
  WarningList warnings{options.strict};
  std::map<std::string, std::shared_ptr<const MeasuredBrdf>> brdfs = {};  ///< Those that were read, by path.
  bool has_fibres = false;              ///< Of the current material: its curves are round.
  std::vector<std::string> notes = {};  ///< Of the summary: decisions that change the picture little.
};

}  // namespace twinray
