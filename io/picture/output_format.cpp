// SPDX-License-Identifier: Apache-2.0
#include "io/picture/output_format.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "core/error.h"
#include "io/destination.h"
#include "io/picture/picture_header.h"

namespace twinray {
namespace {

constexpr std::pair<const char*, OutputFormat> endings[] = {
    {".png", OutputFormat::png},   {".exr", OutputFormat::exr},  {".jpg", OutputFormat::jpeg},
    {".jpeg", OutputFormat::jpeg}, {".tif", OutputFormat::tiff}, {".tiff", OutputFormat::tiff},
    {".hdr", OutputFormat::hdr},   {".pfm", OutputFormat::pfm}};

std::optional<OutputFormat> format_of_name(const std::string& path) {
  const std::string ending = picture_ending(path);
  for (const auto& [known, format] : endings)
    if (ending == known) return format;
  return std::nullopt;
}

}  // namespace

OutputFormat output_format(const std::string& path) {
  return format_of_name(path).value_or(OutputFormat::png);
}

void check_image_name(const std::string& path) {
  if (!format_of_name(path) && destination_of(path).kind == Destination::Kind::file)
    throw Error(fmt::format(
        "{}: a picture's name must end in .png, .jpg, .jpeg, .exr, .tif, .tiff, .hdr or .pfm", path));
}

}  // namespace twinray
