// SPDX-License-Identifier: Apache-2.0
// What a render writes, and under which names.
#pragma once
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "cli/crosscheck/report.h"
#include "cli/denoising.h"
#include "cli/picture_metadata.h"
#include "cli/render_arguments.h"
#include "io/picture/image_file.h"

namespace twinray {

/// The names of a render's outputs; empty for what it does not write.
struct RenderOutputs {
  std::string picture;
  std::string film;         ///< In place of a picture, for those who merge and resume.
  std::string rates;        ///< Of adaptive sampling.
  std::string legend;       ///< Of a picture of costs.
  std::string differences;  ///< Of --accel=check.
  std::string noisy;        ///< Of a denoised picture that cannot keep it as a layer.
  std::string statistics;
  std::string metrics;     ///< Written again and again.
  std::string checkpoint;  ///< Of a render that goes on.

  /// All that are not empty.
  std::vector<std::string> names() const;
};

/// What an output of this name is called in what is printed: "Picture", "Film".
const char* output_word(const std::string& output);

/// Whether what has this name keeps layers, and pixels beside the frame: an OpenEXR picture, or a film.
bool keeps_layers(const std::string& output);

/// The outputs that the command line names, whether they can be written or not.
RenderOutputs named_outputs(const RenderArguments& arguments);

/// The outputs that the command line asks for. What stands beside the picture is left out where the picture
/// is no file. Throws Error for a name that cannot be written.
RenderOutputs render_outputs(const RenderArguments& arguments);

/// The names of all these outputs.
std::vector<std::string> all_names(std::initializer_list<RenderOutputs> all);

/// A film, and what was made of it.
struct RenderedPicture {
  const Film& film;
  const DenoisedPicture* denoised = nullptr;  ///< Null: it is as it is.
};

/// Writes the picture, its rates and its legend; of one that is denoised the noisy one as well.
void write_pictures(const RenderOutputs& outputs, const RenderArguments& arguments,
                    const RenderedPicture& rendered, const PictureNotes& notes);

}  // namespace twinray
