// SPDX-License-Identifier: Apache-2.0
#include "io/picture/openimageio_view.h"

#include <OpenImageIO/color.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "core/error.h"

namespace twinray {
namespace {

/// The configuration's name of linear colours by sRGB's primaries; else the scene's own space stands for it.
std::string linear_srgb(const OIIO::ColorConfig& config) {
  const std::vector<std::string> names = config.getColorSpaceNames();
  for (const char* name : {"lin_srgb", "lin_rec709", "Linear Rec.709 (sRGB)", "Linear Rec.709", "Linear",
                           "Utility - Linear - sRGB", "Utility - Linear - Rec.709"})
    if (std::find(names.begin(), names.end(), name) != names.end()) return name;
  return "scene_linear";
}

/// The display of a view that the configuration has. Throws Error, with what it has.
std::string display_of_view(const OIIO::ColorConfig& config, const std::string& asked,
                            const std::string& view) {
  const std::vector<std::string> displays = config.getDisplayNames();
  const std::string display = asked.empty() && !displays.empty() ? displays.front() : asked;
  if (std::find(displays.begin(), displays.end(), display) == displays.end())
    throw Error(fmt::format("the configuration of $OCIO has no display \"{}\"; valid are {}", display,
                            fmt::join(displays, ", ")));
  const std::vector<std::string> views = config.getViewNames(display);
  if (std::find(views.begin(), views.end(), view) == views.end())
    throw Error(
        fmt::format("the configuration of $OCIO has no view \"{}\" of the display \"{}\"; valid are {}", view,
                    display, fmt::join(views, ", ")));
  return display;
}

}  // namespace

Image opencolorio_view(const Image& image, const std::string& display, const std::string& view) {
  const char* const name = std::getenv("OCIO");
  if (!name || !*name) throw Error("$OCIO names no configuration of OpenColorIO");
  OIIO::ColorConfig config(name);
  if (config.error()) throw Error(fmt::format("$OCIO: {}: {}", name, config.geterror()));
  const std::string shown_on = display_of_view(config, display, view);
  Image result = image;
  const OIIO::ImageSpec spec(image.width, image.height, 3, OIIO::TypeDesc::FLOAT);
  OIIO::ImageBuf pixels(spec, result.pixels.data());
  if (!OIIO::ImageBufAlgo::ociodisplay(pixels, pixels, shown_on, view, linear_srgb(config), "", false, "", "",
                                       &config, {}, 1))
    throw Error(fmt::format("$OCIO: {}: {}", name, pixels.geterror()));
  return result;
}

}  // namespace twinray
