// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/color_space.h"

#include <algorithm>
#include <array>
#include <string>

#include "io/lower_case.h"

namespace twinray {
namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

struct Space {
  std::string_view name;
  PbrtColorSpace space;
  Matrix to_srgb;  ///< Through XYZ; ACES's white by Bradford's adaptation. Rows sum to 1.
};

constexpr std::array<Space, 4> spaces{
    {{"srgb", PbrtColorSpace::srgb, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}},
     {"dci-p3",
      PbrtColorSpace::dci_p3,
      {{{1.224940, -0.224940, 0}, {-0.042057, 1.042057, 0}, {-0.019638, -0.078636, 1.098274}}}},
     {"rec2020",
      PbrtColorSpace::rec2020,
      {{{1.660491, -0.587641, -0.072850},
        {-0.124550, 1.132900, -0.008350},
        {-0.018151, -0.100579, 1.118730}}}},
     {"aces2065-1",
      PbrtColorSpace::aces2065_1,
      {{{2.521686, -1.134131, -0.387555},
        {-0.276480, 1.372719, -0.096239},
        {-0.015378, -0.152975, 1.168353}}}}}};

}  // namespace

std::optional<PbrtColorSpace> color_space_named(std::string_view name) {
  for (const Space& space : spaces)
    if (space.name == lower_case(std::string(name))) return space.space;
  return std::nullopt;
}

Rgb to_srgb(const Rgb& color, PbrtColorSpace space) {
  if (space == PbrtColorSpace::srgb) return color;
  const Matrix& m = spaces[std::size_t(space)].to_srgb;
  const auto row = [&](std::size_t i) {
    return std::max(0.0f, float(m[i][0] * color.r + m[i][1] * color.g + m[i][2] * color.b));
  };
  return {row(0), row(1), row(2)};
}

}  // namespace twinray
