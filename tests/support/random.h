// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/random.h"

namespace twinray::test {

using twinray::Random;

}  // namespace twinray::test
