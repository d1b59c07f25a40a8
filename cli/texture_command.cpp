// SPDX-License-Identifier: Apache-2.0
#include "cli/texture_command.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "cli/console.h"
#include "cli/options/common.h"
#include "core/error.h"
#include "io/picture/texture_file.h"
#include "io/picture/tiled_texture.h"

namespace twinray {
namespace {

/// Those that the conversion knows.
constexpr const char* conversion_options[] = {"--convert-textures", "--strict", "--memory", "--time-limit",
                                              "--quiet"};

std::vector<PictureUse> pictures_of(const RenderArguments& arguments) {
  LoadOptions options = arguments.load;
  options.pictures = std::make_shared<std::vector<PictureUse>>();
  load_with_warnings(arguments.scene, options);
  return *options.pictures;
}

/// False where it cannot be done, which is said.
bool convert(const PictureUse& picture, bool is_quiet) {
  try {
    const ConvertedTexture made = convert_texture(picture);
    if (!made.warning.empty()) console::warn(made.warning);
    if (!is_quiet)
      console::print("{}: {} x {} pixels, {} levels{}\n", made.path, made.width, made.height, made.levels,
                     made.is_new ? "" : "; it is there already");
    return true;
  } catch (const Error& error) {
    console::print_error("{}: {}\n", console::speaker(), error.what());
    return false;
  }
}

}  // namespace

std::vector<std::string> options_without_effect_on_conversion(const RenderArguments& arguments) {
  std::vector<std::string> found;
  for (const std::string& option : arguments.given)
    if (std::find(std::begin(conversion_options), std::end(conversion_options), option) ==
        std::end(conversion_options))
      found.push_back(option + ": no effect, for --convert-textures renders nothing");
  return found;
}

int convert_textures(const RenderArguments& arguments) {
  const std::vector<PictureUse> pictures = pictures_of(arguments);
  if (pictures.empty())
    console::warn("the scene has no picture on its surfaces: there is nothing to convert");
  std::set<std::string> names;
  bool is_all_done = true;
  for (const PictureUse& picture : pictures)
    if (names.insert(tiled_name(picture.path, picture.meaning)).second)
      is_all_done = convert(picture, arguments.quiet) && is_all_done;
  return is_all_done ? 0 : 1;
}

}  // namespace twinray
