// SPDX-License-Identifier: Apache-2.0
#include "cli/outputs.h"

#include <algorithm>

#include "cli/console.h"
#include "io/destination.h"
#include "io/output_file.h"

namespace twinray {

void prepare_outputs(const std::vector<std::string>& names) {
  check_outputs(names);
  if (std::any_of(names.begin(), names.end(), is_standard_output)) console::keep_output_for_data();
}

}  // namespace twinray
