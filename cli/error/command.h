// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "cli/error/measurement.h"
#include "cli/options/options.h"

namespace twinray {

/// What an error command line asks for.
struct ErrorArguments {
  error::OptionSet common;             ///< What all sets have; its name is "default".
  std::vector<error::OptionSet> sets;  ///< At least one.
  error::Rounds rounds{{4, 16, 64}, 4, 0};
  bool converges = false;               ///< Else the reference is read.
  std::string reference;                ///< Its file.
  std::uint32_t reference_samples = 0;  ///< Per pixel, in two halves: an even number.
  std::string save_reference;           ///< Empty: nowhere.
  bool leaves_out_emitters = true;
  std::vector<double> targets{0.005};  ///< Root mean squared errors.
  std::string csv_file, html_file;     ///< Empty: none.
  bool quiet = false;
};

/// Adds the command's options; the function that is returned gives what they ask for, once they are read. It
/// throws UsageError with the reason where they contradict each other.
std::function<ErrorArguments()> add_error_options(CLI::App& app);

/// twinray error SCENE --reference FILE | --converge [options]: the error of each set of options over samples
/// and CPU seconds, and whether it is biased. The page remembers the words that it was asked for with.
/// Returns the exit code: 0, or that of an interruption, after which everything is written that is complete.
/// Throws Error.
int error_command(const ErrorArguments& arguments, const Words& words);

}  // namespace twinray
