// SPDX-License-Identifier: Apache-2.0
// Integers in which a test computes exactly what it asks exact numbers for.
#pragma once

namespace twinray::test {

using Wide = __int128;

/// -1, 0 or 1.
inline int sign(Wide a) { return (a > 0) - (a < 0); }

}  // namespace twinray::test
