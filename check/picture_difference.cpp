// SPDX-License-Identifier: Apache-2.0
#include "check/picture_difference.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "check/tiles.h"
#include "core/elementary.h"
#include "core/error.h"
#include "core/same_size.h"

namespace twinray {
namespace {

constexpr std::array channels{&Rgb::r, &Rgb::g, &Rgb::b};

void check_sizes(const Image& picture, const Image& reference) {
  check_same_size(picture, reference);
  if (picture.pixels.empty()) throw Error("pictures without pixels cannot be compared");
}

ChannelDifference channel_difference(const Image& picture, const Image& reference, float Rgb::*channel) {
  ChannelDifference sum;
  for (std::size_t i = 0; i < reference.pixels.size(); ++i) {
    const double expected = reference.pixels[i].*channel;
    const double difference = double(picture.pixels[i].*channel) - expected;
    sum.squared.mse += difference * difference;
    sum.squared.relative += relative_square(difference, expected);
    sum.mean += difference;
    sum.reference_mean += expected;
  }
  const auto n = double(reference.pixels.size());
  return {{sum.squared.mse / n, sum.squared.relative / n}, sum.mean / n, sum.reference_mean / n};
}

ChannelDifference mean_of(const std::array<ChannelDifference, 3>& all) {
  ChannelDifference mean;
  for (const ChannelDifference& one : all) {
    mean.squared.mse += one.squared.mse / 3;
    mean.squared.relative += one.squared.relative / 3;
    mean.mean += one.mean / 3;
    mean.reference_mean += one.reference_mean / 3;
  }
  return mean;
}

PixelDifference largest_difference(const Image& picture, const Image& reference) {
  PixelDifference largest;
  for (int y = 0; y < reference.height; ++y)
    for (int x = 0; x < reference.width; ++x)
      for (std::size_t channel = 0; channel < 3; ++channel) {
        const double value =
            double(picture.at(x, y).*channels[channel]) - double(reference.at(x, y).*channels[channel]);
        if (std::abs(value) > std::abs(largest.value)) largest = {x, y, channel, value};
      }
  return largest;
}

std::size_t count_differing(const Image& picture, const Image& reference) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < reference.pixels.size(); ++i)
    count += !(picture.pixels[i] == reference.pixels[i]);
  return count;
}

TileDifference tile_difference(const Image& picture, const Image& reference, const PixelRect& tile) {
  TileDifference result{tile, 0, 0};
  for (int y = tile.y0; y < tile.y1; ++y)
    for (int x = tile.x0; x < tile.x1; ++x) {
      const Rgb &a = picture.at(x, y), &b = reference.at(x, y);
      for (const auto channel : channels) {
        const double difference = double(a.*channel) - double(b.*channel);
        result.mse += difference * difference;
      }
      result.luminance += double(luminance(a)) - double(luminance(b));
    }
  const double pixels = double(tile.width()) * double(tile.height());
  result.mse /= 3 * pixels;
  result.luminance /= pixels;
  return result;
}

}  // namespace

PictureDifference picture_difference(const Image& picture, const Image& reference) {
  check_sizes(picture, reference);
  PictureDifference result;
  for (std::size_t i = 0; i < channels.size(); ++i)
    result.channels[i] = channel_difference(picture, reference, channels[i]);
  result.all = mean_of(result.channels);
  result.differing_pixels = count_differing(picture, reference);
  result.largest = largest_difference(picture, reference);
  return result;
}

std::vector<TileDifference> largest_differences(const Image& picture, const Image& reference,
                                                std::size_t count, int tile_edge) {
  check_sizes(picture, reference);
  std::vector<TileDifference> tiles;
  for (const PixelRect& tile : tiles_of(reference.width, reference.height, tile_edge))
    tiles.push_back(tile_difference(picture, reference, tile));
  std::erase_if(tiles, [](const TileDifference& one) { return !(one.mse > 0); });
  std::stable_sort(tiles.begin(), tiles.end(),
                   [](const TileDifference& a, const TileDifference& b) { return a.mse > b.mse; });
  tiles.resize(std::min(count, tiles.size()));
  return tiles;
}

std::optional<double> peak_signal_to_noise(const ByteImage& picture, const ByteImage& reference) {
  check_same_size(picture, reference);
  double squares = 0;
  for (std::size_t i = 0; i < reference.bytes.size(); ++i) {
    const double difference = double(picture.bytes[i]) - double(reference.bytes[i]);
    squares += difference * difference;
  }
  if (!(squares > 0)) return std::nullopt;
  const double mse = squares / double(reference.bytes.size());
  return 10 / (std::numbers::log2e * std::numbers::ln10) * log2_of(255.0 * 255.0 / mse);
}

}  // namespace twinray
