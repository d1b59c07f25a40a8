// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "cli/render_arguments.h"
#include "cli/scene_names.h"
#include "io/image_metadata.h"

namespace twinray {

/// What is stored in every picture of a render: the program, the words of its command line, the hashes of the
/// files that it depends on, if the scene was loaded with a list of them, and the time that the environment's
/// SOURCE_DATE_EPOCH states, if it does, so that the same command gives the same bytes.
/// Throws Error where that is not a time.
ImageMetadata picture_metadata(const RenderArguments& arguments, const std::vector<std::string>& words);

/// What is said of a render's picture: metadata, and the frame with the camera that sees it.
struct PictureNotes {
  ImageMetadata metadata;
  ImageFrame frame;
  SceneNames names;  ///< What the layers' numbers stand for; none without layers.
};
PictureNotes picture_notes(const RenderArguments& arguments, const std::vector<std::string>& words,
                           const Scene& scene);

/// "1700000000" -> "2023:11:14 22:13:20": seconds since 1970, in UTC, as EXIF writes a time. Throws Error.
std::string time_stamp(const std::string& seconds_since_1970);

}  // namespace twinray
