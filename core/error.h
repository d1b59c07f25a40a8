// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <stdexcept>
#include <string>
#include <utility>

namespace twinray {

/// What a library of ours throws when its input is wrong: what() says what is wrong, where, and what would be
/// valid.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A wrong command line: reported with the usage line, exit code 2.
class UsageError : public Error {
 public:
  using Error::Error;
};

}  // namespace twinray
