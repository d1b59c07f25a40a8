// SPDX-License-Identifier: Apache-2.0
#include "io/display/color_scale.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/elementary.h"

namespace twinray {
namespace {

constexpr float darkest = 0.2f, lightest = 0.95f, largest_chroma = 0.15f;
/// In turns: violet, and yellow on the way back over blue and green.
constexpr float first_hue = 0.83f, last_hue = 0.3f;

/// Linear sRGB of OKLab (B. Ottosson, "A perceptual color space for image processing", 2020).
Rgb from_oklab(float lightness, float a, float b) {
  const auto cubed = [](float x) { return x * x * x; };
  const float l = cubed(lightness + 0.3963377774f * a + 0.2158037573f * b);
  const float m = cubed(lightness - 0.1055613458f * a - 0.0638541728f * b);
  const float s = cubed(lightness - 0.0894841775f * a - 1.2914855480f * b);
  return {4.0767416621f * l - 3.3077115913f * m + 0.2309699292f * s,
          -1.2684380046f * l + 2.6097574011f * m - 0.3413193965f * s,
          -0.0041960863f * l - 0.7034186147f * m + 1.7076147010f * s};
}

bool is_in_gamut(const Rgb& c) { return std::min({c.r, c.g, c.b}) >= 0 && std::max({c.r, c.g, c.b}) <= 1; }

/// Digits of 3 x 5 pixels: rows from the top, the left pixel in bit 2.
constexpr std::array<std::array<std::uint8_t, 5>, 10> digits{{{7, 5, 5, 5, 7},
                                                              {2, 6, 2, 2, 7},
                                                              {7, 1, 7, 4, 7},
                                                              {7, 1, 7, 1, 7},
                                                              {5, 5, 7, 1, 1},
                                                              {7, 4, 7, 1, 7},
                                                              {7, 4, 7, 5, 7},
                                                              {7, 1, 1, 1, 1},
                                                              {7, 5, 7, 5, 7},
                                                              {7, 5, 7, 1, 7}}};

// The legend's measures in pixels.
constexpr int margin = 10, strip_width = 16, strip_height = 201, parts = 5, tick = 4, enlarged = 2;
constexpr int digit_step = 4 * enlarged, most_digits = 10;
constexpr int text_left = margin + strip_width + 2 * tick;
constexpr int legend_width = text_left + most_digits * digit_step + tick - 2,
              legend_height = strip_height + 2 * margin;

using Bytes = std::array<std::uint8_t, 3>;

Bytes encoded(const Rgb& c) { return {encode_srgb(c.r), encode_srgb(c.g), encode_srgb(c.b)}; }

void fill(ByteImage& image, const PixelRect& where, const Bytes& color) {
  for (int y = where.y0; y < where.y1; ++y)
    for (int x = where.x0; x < where.x1; ++x)
      std::copy(color.begin(), color.end(), image.bytes.begin() + 3 * (std::ptrdiff_t(y) * image.width + x));
}

void draw_number(ByteImage& image, std::uint32_t number, int left, int top) {
  for (const char c : std::to_string(number)) {
    for (int row = 0; row < 5; ++row)
      for (int column = 0; column < 3; ++column) {
        if (!(digits[std::size_t(c - '0')][std::size_t(row)] >> (2 - column) & 1)) continue;
        const int x = left + column * enlarged, y = top + row * enlarged;
        fill(image, {x, y, x + enlarged, y + enlarged}, {0, 0, 0});
      }
    left += digit_step;
  }
}

}  // namespace

Rgb scale_color(float x) {
  const float share = x > 0 ? std::min(x, 1.0f) : 0;
  const float lightness = darkest + share * (lightest - darkest);
  const SinCos hue = sincos_turns(first_hue + share * (last_hue - first_hue));
  float held = 0, beyond = largest_chroma;
  for (int step = 0; step < 20; ++step) {
    const float chroma = step == 0 ? largest_chroma : 0.5f * (held + beyond);
    (is_in_gamut(from_oklab(lightness, chroma * hue.cos, chroma * hue.sin)) ? held : beyond) = chroma;
  }
  return from_oklab(lightness, held * hue.cos, held * hue.sin);
}

std::array<std::uint8_t, 3> signed_color(double x) {
  const double strength = std::isnan(x) ? 0 : std::min(std::abs(x), 1.0);
  using Full = std::array<float, 3>;
  const Full full = x > 0 ? Full{0.75f, 0.05f, 0.1f} : Full{0, 0.3f, 0.7f};
  std::array<std::uint8_t, 3> bytes;
  for (std::size_t i = 0; i < 3; ++i)
    bytes[i] = std::uint8_t(255 * (1 - strength * (1 - double(full[i]))) + 0.5);
  return bytes;
}

std::uint32_t scale_end(const Image& values) {
  float most = 0;
  for (const Rgb& value : values.pixels) most = std::max(most, value.r);
  std::uint32_t end = 5;
  for (const std::uint32_t unit : {1u, 10u, 100u, 1000u, 10000u, 100000u, 1000000u, 10000000u, 100000000u})
    for (const std::uint32_t factor : {5u, 10u, 20u})
      if (float(end) < most) end = factor * unit;
  return end;
}

ByteImage scaled_image(const Image& values, std::uint32_t end) {
  ByteImage image{values.width, values.height, {}};
  image.bytes.reserve(3 * values.pixels.size());
  for (const Rgb& value : values.pixels) {
    const Bytes color = encoded(scale_color(value.r / float(end)));
    image.bytes.insert(image.bytes.end(), color.begin(), color.end());
  }
  return image;
}

ByteImage legend_image(std::uint32_t end) {
  ByteImage image{legend_width, legend_height,
                  std::vector<std::uint8_t>(3 * std::size_t(legend_width) * legend_height, 255)};
  for (int i = 0; i < strip_height; ++i) {
    const int y = margin + strip_height - 1 - i;
    fill(image, {margin, y, margin + strip_width, y + 1},
         encoded(scale_color(float(i) / float(strip_height - 1))));
  }
  for (int part = 0; part <= parts; ++part) {
    const int y = margin + strip_height - 1 - part * (strip_height - 1) / parts;
    fill(image, {margin + strip_width, y, margin + strip_width + tick, y + 1}, {0, 0, 0});
    draw_number(image, end / parts * std::uint32_t(part), text_left, y - 5 * enlarged / 2);
  }
  return image;
}

}  // namespace twinray
