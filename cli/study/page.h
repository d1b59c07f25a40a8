// SPDX-License-Identifier: Apache-2.0
// The page of a study.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "cli/study/notes.h"
#include "cli/study/picture_folder.h"
#include "cli/study/plan.h"
#include "core/image_error.h"

namespace twinray::study {

/// A figure with what is known of its picture.
struct Result {
  const Figure* figure = nullptr;
  std::optional<Record> record;     ///< None: it is not made yet.
  std::optional<ImageError> error;  ///< Where both pictures are there.
};

/// The table below a section's pictures, and the plot of its errors; empty where it has none.
std::string comparison_table(const Section& section, const std::vector<Result>& results);
std::string error_plot(const Section& section, const std::vector<Result>& results);

/// The error of what a picture shows: radiance beyond 1, which is white, counts as 1, or the edges of lamps
/// would count for more than all noise. Its brightness is that of the whole radiance.
ImageError shown_error(const Image& image, const Image& converged);

std::string command_html(const std::string& command);

// Numbers as the page shows them.

std::string seconds_text(double seconds);                        ///< "12.3 ms", "12.3 s".
std::string count_text(double count);                            ///< "1.23 M".
std::string tests_text(double tests);                            ///< "1.23", "5856".
std::string error_text(const std::optional<ImageError>& error);  ///< "3.21 %", or a dash.

struct Study {
  const SceneFolder& folder;
  const Scale& scale;
  const std::vector<Part>& parts;
  const Notes& notes;
  const PictureFolder& pictures;
};

/// The page as it stands: what is not made yet says so.
std::string study_page(const Study& study);

}  // namespace twinray::study
