// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

namespace twinray {

/// "twinray 0.1.0".
std::string version_name();
/// The version, the libraries it was built with and the instruction sets of the machine it runs on; a few
/// lines.
std::string version_text();

}  // namespace twinray
