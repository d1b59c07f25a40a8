// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "core/error.h"

namespace twinray::test {

/// What it fails with; empty where it does not.
template <typename Action>
std::string error_text(const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace twinray::test
