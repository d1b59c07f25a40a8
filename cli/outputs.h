// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

namespace twinray {

/// To be called before the work: throws Error unless all these outputs could be written, and leaves standard
/// output to them alone where one of them is standard output.
void prepare_outputs(const std::vector<std::string>& names);

}  // namespace twinray
