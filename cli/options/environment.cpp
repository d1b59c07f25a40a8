// SPDX-License-Identifier: Apache-2.0
#include "cli/options/environment.h"

#include <fmt/format.h>

#include <memory>
#include <utility>

#include "core/error.h"

namespace twinray {
namespace {

constexpr Range<float> rotations{-360, 360};
constexpr Range<float> scales{0, 1e9f};

}  // namespace

void add_environment_placement(OptionGroup& group, EnvironmentPlacement& placement) {
  group.add_choice<MapLayout>(
      "--environment-layout", placement.layout,
      {{"latitude-longitude", MapLayout::latitude_longitude}, {"equal-area", MapLayout::equal_area}},
      "Of its picture; pbrt-v4's: equal-area", "LAYOUT");
  group.add_number({"--environment-rotation", "DEGREES", "Turns it about +y"}, placement.rotation_degrees,
                   rotations);
  group.add_number({"--environment-scale", "X", "Times its radiance"}, placement.scale, scales);
}

EnvironmentLight placed_environment(Image map, const EnvironmentPlacement& placement,
                                    const std::string& file) {
  if (placement.layout == MapLayout::equal_area && map.width != map.height)
    throw Error(fmt::format("{}: {} x {} pixels; an equal-area environment is a square", file, map.width,
                            map.height));
  const float scale = placement.scale;
  Transform upright;  // The equal-area square lies around +z: its up becomes +y.
  if (placement.layout == MapLayout::equal_area) upright = Transform::rotation({1, 0, 0}, -90);
  return {std::make_shared<const Image>(std::move(map)),
          placement.layout,
          Transform::rotation({0, 1, 0}, double(placement.rotation_degrees)) * upright,
          {scale, scale, scale}};
}

}  // namespace twinray
