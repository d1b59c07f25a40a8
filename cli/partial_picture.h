// SPDX-License-Identifier: Apache-2.0
// What stays of a render that was interrupted.
#pragma once
#include <string>
#include <vector>

#include "cli/render_outputs.h"

namespace twinray {

/// The same pictures with "_partial" before their endings ("a/b.exr" -> "a/b_partial.exr"), and no
/// statistics; nothing at all where the picture is no regular file.
RenderOutputs partial_outputs(const RenderOutputs& outputs);

/// Writes the picture as far as it got, with its rates and its legend, and returns a sentence that says so.
/// In place of the number of samples the metadata state what the pixels got, as "3 to 5 of 16". Without any
/// sample nothing is written.
std::string write_partial(const RenderOutputs& partial, const RenderArguments& arguments, const Film& film,
                          PictureNotes notes);

/// "3 to 5 of 16", "4 of 16": samples of a pixel, the fewest and the most; where as many were wanted as a
/// film takes, time was to decide, and "of" is left out.
std::string sample_range_text(const Film& film, std::uint32_t wanted);

}  // namespace twinray
