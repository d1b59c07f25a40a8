// SPDX-License-Identifier: Apache-2.0
#include "cli/error/reference_file.h"

#include <fmt/format.h>

#include <filesystem>
#include <optional>

#include "cli/finite_picture.h"
#include "cli/outputs.h"
#include "core/error.h"
#include "io/picture/image_file.h"

namespace twinray::error {
namespace {

Image read(const std::string& path, const FramePart& part) {
  Image image = read_finite_image(path);
  const PixelRect& window = part.window;
  if (image.width != window.width() || image.height != window.height())
    throw Error(
        fmt::format("{}: it has {} x {} pixels, but the pictures to compare have {} x {}; -r sets their "
                    "size",
                    path, image.width, image.height, window.width(), window.height()));
  if (const auto shown = part_shown(path, image); shown && *shown != part)
    throw Error(fmt::format("{}: it shows {}, but the pictures to compare show {}", path,
                            frame_part_text(*shown), frame_part_text(part)));
  return image;
}

}  // namespace

std::string noise_name(const std::string& reference) { return name_beside(reference, "_noise.exr"); }

void check_reference_name(const std::string& path) {
  if (output_format(path) != OutputFormat::exr)
    throw Error(
        fmt::format("{}: a reference is a picture of linear floats; its name must end in .exr", path));
}

ConvergedPicture read_reference(const std::string& path, const FramePart& part) {
  check_reference_name(path);
  ConvergedPicture converged{read(path, part), {}};
  if (const std::string noise = noise_name(path); std::filesystem::exists(noise))
    converged.noise = read(noise, part);
  return converged;
}

void write_reference(const std::string& path, const ConvergedPicture& converged,
                     const ImageMetadata& metadata, const ImageFrame& frame) {
  write_exr(path, converged.mean, metadata, frame);
  if (converged.noise) write_exr(noise_name(path), *converged.noise, metadata, frame);
}

}  // namespace twinray::error
