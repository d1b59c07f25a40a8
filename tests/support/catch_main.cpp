// SPDX-License-Identifier: Apache-2.0
// The test programs' main, in a file of its own because it is slow to compile.
#if !__has_include(<catch2/catch_all.hpp>)
#define CATCH_CONFIG_MAIN
#endif
#include "tests/support/catch.h"
