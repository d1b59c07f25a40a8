// SPDX-License-Identifier: Apache-2.0
// Which calls of the kernel a process may still make: the one door to libseccomp.
#pragma once

namespace twinray {

enum class Network { closed, open };

/// Takes from the process, for good, all calls by which it could start or watch others, change the system, or
/// reach the network, unless that stays open: they fail as if it had no right to (EPERM). False where the
/// kernel cannot filter calls. Throws Error where it refuses.
bool close_system_calls(Network network);

}  // namespace twinray
