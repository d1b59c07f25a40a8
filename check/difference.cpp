// SPDX-License-Identifier: Apache-2.0
#include "check/difference.h"

#include <fmt/format.h>

namespace twinray {
namespace {

template <typename Sum>
std::string sums_text(const char* name, const Sum& expected, const Sum& found) {
  if (expected.value() == found.value())
    return fmt::format("{} {:a}, but for bits beyond a double's", name, expected.value());
  return fmt::format("{} {:a} and {:a}", name, expected.value(), found.value());
}

std::string pixel_text(const PixelSums& expected, const PixelSums& found) {
  if (expected.count != found.count) return fmt::format("samples {} and {}", expected.count, found.count);
  if (expected.rejected != found.rejected)
    return fmt::format("rejected samples {} and {}", expected.rejected, found.rejected);
  if (expected.rejected_index != found.rejected_index)
    return fmt::format("first rejected samples {} and {}", expected.rejected_index, found.rejected_index);
  if (!(expected.r == found.r)) return sums_text("red", expected.r, found.r);
  if (!(expected.g == found.g)) return sums_text("green", expected.g, found.g);
  if (!(expected.b == found.b)) return sums_text("blue", expected.b, found.b);
  return sums_text("luminance squared", expected.luminance_squared, found.luminance_squared);
}

std::string layer_text(Layer layer, const Rgb& expected, const Rgb& found) {
  return fmt::format("{} {:a} {:a} {:a} and {:a} {:a} {:a}", layer_info(layer).name, expected.r, expected.g,
                     expected.b, found.r, found.g, found.b);
}

/// What a film keeps of a pixel besides its colours, with a name; both films keep the same.
std::optional<std::string> kept_difference(const Film& expected, const Film& found, int x, int y) {
  for (std::size_t layer = 0; layer < found.layers().size(); ++layer) {
    const Layer shown = found.layers()[layer];
    if (layer_info(shown).gathering == Gathering::coverage) {
      if (expected.coverage(layer, x, y) != found.coverage(layer, x, y)) return layer_info(shown).name;
    } else if (const Rgb p = expected.value(layer, x, y), q = found.value(layer, x, y); p != q) {
      return layer_text(shown, p, q);
    }
  }
  for (const Division division : divisions) {
    const std::size_t count = found.contents().parts[std::size_t(division)];
    std::vector<Rgb> a(count), b(count);
    expected.read_parts(division, x, y, a);
    found.read_parts(division, x, y, b);
    if (a != b) return division == Division::paths ? "light by paths" : "light by groups";
  }
  return std::nullopt;
}

bool holds(const PixelRect& outer, const PixelRect& inner) {
  return outer.x0 <= inner.x0 && outer.y0 <= inner.y0 && outer.x1 >= inner.x1 && outer.y1 >= inner.y1;
}

}  // namespace

std::optional<std::string> first_difference(const Film& expected, const Film& found) {
  if (expected.frame_width() != found.frame_width() || expected.frame_height() != found.frame_height() ||
      expected.contents() != found.contents() || !holds(expected.window(), found.window()))
    return "frames, windows or layers that do not fit";
  const PixelRect& window = found.window();
  for (int y = window.y0; y < window.y1; ++y)
    for (int x = window.x0; x < window.x1; ++x) {
      const PixelSums &a = expected.pixel(x, y), &b = found.pixel(x, y);
      if (!(a == b)) return fmt::format("pixel {} {}: {}", x, y, pixel_text(a, b));
      if (const auto kept = kept_difference(expected, found, x, y))
        return fmt::format("pixel {} {}: {}", x, y, *kept);
    }
  return std::nullopt;
}

std::optional<std::string> first_difference(const RayCounts& expected, const RayCounts& found) {
  if (expected.camera != found.camera)
    return fmt::format("camera rays {} and {}", expected.camera, found.camera);
  if (expected.shadow != found.shadow)
    return fmt::format("shadow rays {} and {}", expected.shadow, found.shadow);
  if (expected.bounce != found.bounce)
    return fmt::format("bounce rays {} and {}", expected.bounce, found.bounce);
  return std::nullopt;
}

}  // namespace twinray
