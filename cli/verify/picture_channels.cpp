// SPDX-License-Identifier: Apache-2.0
#include "cli/verify/picture_channels.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "io/picture/image_file.h"
#include "io/picture/picture_header.h"

namespace twinray {
namespace {

constexpr std::size_t absent = SIZE_MAX;

std::size_t channel_of(const StoredLayers& picture, const std::string& name) {
  const auto found = std::find_if(picture.channels.begin(), picture.channels.end(),
                                  [&](const PictureChannel& channel) { return channel.name == name; });
  return found == picture.channels.end() ? absent : std::size_t(found - picture.channels.begin());
}

/// "R" -> "noisy.R", "light_a.R" -> "noisy_light_a.R"
std::string noisy_name(const std::string& name) { return (name.size() == 1 ? "noisy." : "noisy_") + name; }

/// A channel of the picture, and that of the part which must have its bits; either may be absent.
struct Pair {
  std::size_t there = absent, here = absent;
};

std::vector<Pair> compared_channels(const StoredLayers& picture, const StoredLayers& part, bool is_denoised) {
  std::vector<Pair> pairs;
  for (std::size_t there = 0; there < picture.channels.size(); ++there) {
    const std::string& name = picture.channels[there].name;
    if (is_denoised && channel_of(picture, noisy_name(name)) != absent) continue;
    const bool is_noisy = is_denoised && name.starts_with("noisy") && name.size() > 6;
    pairs.push_back({there, channel_of(part, is_noisy ? name.substr(6) : name)});
  }
  for (std::size_t here = 0; here < part.channels.size(); ++here)
    if (std::none_of(pairs.begin(), pairs.end(), [here](const Pair& pair) { return pair.here == here; }))
      pairs.push_back({absent, here});
  return pairs;
}

std::optional<float> value_at(const StoredLayers& picture, std::size_t channel, int x, int y) {
  if (channel == absent) return {};
  return picture
      .values[(std::size_t(y) * std::size_t(picture.width) + std::size_t(x)) * picture.channels.size() +
              channel];
}

bool is_same(const std::optional<float>& a, const std::optional<float>& b) {
  return a && b && std::bit_cast<std::uint32_t>(*a) == std::bit_cast<std::uint32_t>(*b);
}

}  // namespace

StoredLayers read_picture(const std::string& path) {
  if (picture_format(path) == PictureFormat::exr) return read_layers(path);
  const Image image = read_image(path), alpha = read_image(path, {.channels = PictureChannels::alpha});
  StoredLayers picture{image.width, image.height, {{"R"}, {"G"}, {"B"}, {"A"}}, {}, read_metadata(path), {}};
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const auto& [r, g, b] = image.pixels[i];
    picture.values.insert(picture.values.end(), {r, g, b, alpha.pixels[i].r});
  }
  return picture;
}

std::optional<PixelDifferences> differences(const StoredLayers& picture, const StoredLayers& part,
                                            const PixelRect& place, bool is_denoised) {
  const std::vector<Pair> pairs = compared_channels(picture, part, is_denoised);
  PixelDifferences found;
  for (int y = place.y0; y < place.y1; ++y)
    for (int x = place.x0; x < place.x1; ++x)
      for (const Pair& pair : pairs) {
        const std::optional<float> there = value_at(picture, pair.there, x, y);
        const std::optional<float> here = value_at(part, pair.here, x - place.x0, y - place.y0);
        if (is_same(there, here)) continue;
        const PictureChannel& channel =
            pair.there == absent ? part.channels[pair.here] : picture.channels[pair.there];
        if (found.pixels++ == 0) found = {1, x, y, channel.name, there, here};
        break;
      }
  return found.pixels > 0 ? std::optional(found) : std::nullopt;
}

}  // namespace twinray
