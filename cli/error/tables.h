// SPDX-License-Identifier: Apache-2.0
// A summary as text and as a table for other programs.
#pragma once
#include <string>

#include "cli/error/summary.h"

namespace twinray::error {

/// What the table and the page begin with.
struct Heading {
  std::string scene;
  int width = 0, height = 0;
  bool leaves_out_emitters = true;
  std::string reference;  ///< Where it is from.
};

/// "120 x 90 pixels, without 400 that see an emitter".
std::string pixels_text(const Heading& heading, const Summary& summary);
/// Where the reference is from, and its own noise.
std::string reference_text(const Heading& heading, const Summary& summary);
/// What is to be warned of: a reference that is too noisy, or of unknown noise. Empty: nothing.
std::string reference_warning(const Summary& summary);
/// In which sets bias was found, and with which numbers of samples: a sentence for each; or that there was
/// none.
std::vector<std::string> verdicts(const Summary& summary);

// Cells of a row, the same in all tables.
std::string samples_cell(const Row& row);  ///< Taken per pixel.
std::string seconds_cell(double seconds);
std::string bias_cell(const Row& row);     ///< "+0.12 ± 0.05 %" of the reference's mean, or "-".
std::string p_value_cell(const Row& row);  ///< Or "-".
std::string target_cell(const std::optional<CostToError>& cost);  ///< "~" before what is extrapolated.

/// The table on standard output.
std::string text_table(const Heading& heading, const Summary& summary);

/// One line for each set and number of samples, after a line of names; what is not known is left empty.
std::string csv_table(const Summary& summary);

}  // namespace twinray::error
