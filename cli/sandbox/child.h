// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>

namespace twinray {

/// Goes on in a process of its own, where nothing is returned; it ends with this one. This one waits for it,
/// and gets its exit code, 128 + N where signal N ended it. Throws Error where there is none to be had. The
/// process must have one thread.
std::optional<int> go_on_in_child();

}  // namespace twinray
