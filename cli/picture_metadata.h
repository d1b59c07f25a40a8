// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cli/input_files.h"
#include "cli/render_arguments.h"
#include "cli/scene_names.h"
#include "io/picture/image_metadata.h"

namespace twinray {

/// The program, the words of a command line, and what these ask for.
ImageMetadata option_metadata(const RenderArguments& arguments, const std::vector<std::string>& words);

/// The temperature of the daylight that displays show as white, as the scene's file said; nothing where it
/// did not.
std::optional<double> daylight_of(const ImageMetadata& metadata);

/// What is stored in every picture of a render: the above, the program's name where it is another, and the
/// time that the environment's SOURCE_DATE_EPOCH states, if it does, so that the same command gives the same
/// bytes. Throws Error where that is not a time.
ImageMetadata picture_metadata(const RenderArguments& arguments, const std::vector<std::string>& words);

/// What is said of a render's picture: metadata, and the frame with the camera that sees it.
struct PictureNotes {
  ImageMetadata metadata;
  ImageFrame frame;
  SceneNames names;  ///< What the layers' numbers stand for; none without layers.
};
/// With the hashes of the files that the render depends on.
PictureNotes picture_notes(const RenderArguments& arguments, const std::vector<std::string>& words,
                           const Scene& scene, const InputFiles& inputs);

/// The engines that made a picture, of its "twinray:engine": "bvh", or "bvh, embree" where it was merged, or
/// went on with another one.
std::set<std::string> engines_in(const std::string& names);
std::set<std::string> engines_of(const ImageMetadata& metadata);
void set_engines(ImageMetadata& metadata, const std::set<std::string>& engines);

/// The metadata of something that stands beside the picture and shows something else: "sample rates".
ImageMetadata metadata_showing(const char* what, const PictureNotes& notes);

/// "1700000000" -> "2023:11:14 22:13:20": seconds since 1970, in UTC, as EXIF writes a time. Throws Error.
std::string time_stamp(const std::string& seconds_since_1970);

}  // namespace twinray
