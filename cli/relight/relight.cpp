// SPDX-License-Identifier: Apache-2.0
#include "cli/relight/relight.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "cli/layered_picture.h"
#include "core/error.h"
#include "core/light_division.h"

namespace twinray {
namespace {

/// Where a colour's channels are among a pixel's.
using ColorPlace = std::array<std::size_t, 3>;

std::optional<std::size_t> place_of(const StoredLayers& picture, const std::string& name) {
  const auto found = std::find_if(picture.channels.begin(), picture.channels.end(),
                                  [&](const PictureChannel& channel) { return channel.name == name; });
  if (found == picture.channels.end()) return {};
  return std::size_t(found - picture.channels.begin());
}

/// Of "light_key" and the like; of the picture itself, "".
std::optional<ColorPlace> color_place(const StoredLayers& picture, const std::string& layer) {
  const std::string prefix = layer.empty() ? "" : layer + ".";
  const auto r = place_of(picture, prefix + "R"), g = place_of(picture, prefix + "G"),
             b = place_of(picture, prefix + "B");
  if (!r || !g || !b) return {};
  return ColorPlace{*r, *g, *b};
}

/// Whether a channel says something of all light together.
bool is_of_old_light(const std::string& channel) {
  if (channel == "variance.Y" || channel.starts_with("noisy.") ||
      channel.starts_with("noisy_" + light_group_layer("")))
    return true;
  for (std::size_t path = 0; path < light_path_count; ++path)
    if (channel.starts_with(std::string(light_path_name(LightPath(path))) + ".")) return true;
  return false;
}

void take_out_old_light(StoredLayers& picture) {
  StoredLayers kept = picture;
  kept.values.clear();
  std::erase_if(kept.channels, [](const PictureChannel& one) { return is_of_old_light(one.name); });
  for (std::size_t i = 0; i < picture.values.size(); ++i)
    if (!is_of_old_light(picture.channels[i % picture.channels.size()].name))
      kept.values.push_back(picture.values[i]);
  picture = std::move(kept);
}

Rgb factor_of(const std::string& group, std::span<const LightChange> changes) {
  Rgb factor{1, 1, 1};
  for (const LightChange& change : changes)
    if (change.group == group) factor = change.factor;
  return factor;
}

/// Throws Error where a group has not all three channels: its light would be left out.
void check_whole(const StoredLayers& picture, const std::string& path) {
  const std::string prefix = light_group_layer("");
  for (const auto& [name, is_half] : picture.channels) {
    const std::string layer = name.substr(0, name.rfind('.'));
    if (!name.starts_with(prefix) || color_place(picture, layer)) continue;
    throw Error(fmt::format("{}: the light group \"{}\" lacks one of its channels R, G and B", path,
                            layer.substr(prefix.size())));
  }
}

void check(const StoredLayers& picture, std::span<const LightChange> changes, const std::string& path) {
  const std::vector<std::string> groups = light_groups_of(picture);
  if (groups.empty() || !color_place(picture, ""))
    throw Error(path + ": it has no light groups; a render with --layers=light-groups writes them");
  check_whole(picture, path);
  for (const LightChange& change : changes)
    if (std::find(groups.begin(), groups.end(), change.group) == groups.end())
      throw Error(fmt::format("{}: it has no light group \"{}\"; there are {}", path, change.group,
                              fmt::join(groups, ", ")));
}

}  // namespace

std::vector<std::string> light_groups_of(const StoredLayers& picture) {
  const std::string prefix = light_group_layer(""), suffix = ".R";
  std::vector<std::string> groups;
  for (const auto& [name, is_half] : picture.channels) {
    if (!name.starts_with(prefix) || !name.ends_with(suffix)) continue;
    const std::string layer = name.substr(0, name.size() - suffix.size());
    if (color_place(picture, layer)) groups.push_back(layer.substr(prefix.size()));
  }
  return groups;
}

void relight(StoredLayers& picture, std::span<const LightChange> changes, const std::string& path) {
  check(picture, changes, path);
  take_out_old_light(picture);
  const ColorPlace sum = *color_place(picture, "");
  const std::size_t channels = picture.channels.size();
  for (std::size_t pixel = 0; pixel < picture.values.size(); pixel += channels)
    for (const std::size_t place : sum) picture.values[pixel + place] = 0;
  for (const std::string& group : light_groups_of(picture)) {
    const ColorPlace place = *color_place(picture, light_group_layer(group));
    const auto [r, g, b] = factor_of(group, changes);
    const std::array factors{r, g, b};
    for (std::size_t pixel = 0; pixel < picture.values.size(); pixel += channels)
      for (std::size_t i = 0; i < 3; ++i)
        picture.values[pixel + sum[i]] += picture.values[pixel + place[i]] *= factors[i];
  }
}

Image colors_of(const StoredLayers& picture) {
  const ColorPlace place = *color_place(picture, "");
  Image image(picture.width, picture.height);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const float* const pixel = &picture.values[i * picture.channels.size()];
    image.pixels[i] = {pixel[place[0]], pixel[place[1]], pixel[place[2]]};
  }
  return image;
}

}  // namespace twinray
