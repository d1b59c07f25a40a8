// SPDX-License-Identifier: Apache-2.0
// Private: what OpenEXR throws, in our words.
#pragma once
#include <fmt/format.h>

#include <exception>
#include <new>
#include <string>

#include "core/error.h"

namespace twinray {

/// The result of `read`. Throws Error with the file's name in the place of OpenEXR's exceptions.
template <typename Read>
auto read_or_fail(const std::string& path, const Read& read) {
  try {
    return read();
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& fault) {
    throw Error(fmt::format("{}: cannot be read: {}", path, fault.what()));
  }
}

}  // namespace twinray
