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

/// From the axes of core/light.h to the world. The equal-area square lies around +z: its up becomes +y. What
/// is mirrored keeps the middle of the picture, at +x.
Transform axes_of(EnvironmentLayout layout) {
  if (layout == EnvironmentLayout::equal_area) return Transform::rotation({1, 0, 0}, -90);
  return layout == EnvironmentLayout::panorama ? Transform::scaling(1, 1, -1) : Transform();
}

}  // namespace

void add_environment_placement(OptionGroup& group, EnvironmentPlacement& placement) {
  group.add_choice<EnvironmentLayout>("--environment-layout", placement.layout,
                                      {{"latitude-longitude", EnvironmentLayout::latitude_longitude},
                                       {"panorama", EnvironmentLayout::panorama},
                                       {"equal-area", EnvironmentLayout::equal_area}},
                                      "Also panorama, or pbrt-v4's equal-area", "LAYOUT");
  group.add_number({"--environment-rotation", "DEGREES", "Turns it about +y"}, placement.rotation_degrees,
                   rotations);
  group.add_number({"--environment-scale", "X", "Times its radiance"}, placement.scale, scales);
}

std::vector<std::string> changed_options(const EnvironmentPlacement& placement) {
  const EnvironmentPlacement none;
  std::vector<std::string> options;
  if (placement.layout != none.layout) options.push_back("--environment-layout");
  if (placement.rotation_degrees != none.rotation_degrees) options.push_back("--environment-rotation");
  if (placement.scale != none.scale) options.push_back("--environment-scale");
  return options;
}

EnvironmentLight placed_environment(Image map, const EnvironmentPlacement& placement,
                                    const std::string& file) {
  const bool is_square = placement.layout == EnvironmentLayout::equal_area;
  if (is_square && map.width != map.height)
    throw Error(fmt::format("{}: {} x {} pixels; an equal-area environment is a square", file, map.width,
                            map.height));
  const float scale = placement.scale;
  return {std::make_shared<const Image>(std::move(map)),
          is_square ? MapLayout::equal_area : MapLayout::latitude_longitude,
          Transform::rotation({0, 1, 0}, double(placement.rotation_degrees)) * axes_of(placement.layout),
          {scale, scale, scale}};
}

}  // namespace twinray
