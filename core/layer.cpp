// SPDX-License-Identifier: Apache-2.0
#include "core/layer.h"

#include <array>

namespace twinray {
namespace {

/// Where the camera sees nothing, as Cycles has it: farther than any scene, and no infinity that a filter
/// would spread.
constexpr float no_depth = 1e10f;

}  // namespace

const LayerInfo& layer_info(Layer layer) {
  static const std::array<LayerInfo, layer_count> table{
      {{"alpha", {"A"}, Gathering::mean, false},
       {"albedo", {"albedo.R", "albedo.G", "albedo.B"}, Gathering::mean, true},
       {"normal", {"N.X", "N.Y", "N.Z"}, Gathering::mean, true},
       {"geometric-normal", {"Ng.X", "Ng.Y", "Ng.Z"}, Gathering::mean, true},
       {"depth", {"Z"}, Gathering::first, false, no_depth},
       {"position", {"P.X", "P.Y", "P.Z"}, Gathering::first, false},
       {"uv", {"uv.U", "uv.V"}, Gathering::first, false},
       {"ids", {"object_id.X", "material_id.X", "instance_id.X"}, Gathering::first, false},
       {"samples", {"samples.X"}, Gathering::of_color, false},
       {"variance", {"variance.Y"}, Gathering::of_color, false},
       {"emission", {"emission.R", "emission.G", "emission.B"}, Gathering::part, false},
       {"environment", {"environment.R", "environment.G", "environment.B"}, Gathering::part, false},
       {"diffuse-direct",
        {"diffuse_direct.R", "diffuse_direct.G", "diffuse_direct.B"},
        Gathering::part,
        false},
       {"diffuse-indirect",
        {"diffuse_indirect.R", "diffuse_indirect.G", "diffuse_indirect.B"},
        Gathering::part,
        false},
       {"glossy-direct", {"glossy_direct.R", "glossy_direct.G", "glossy_direct.B"}, Gathering::part, false},
       {"glossy-indirect",
        {"glossy_indirect.R", "glossy_indirect.G", "glossy_indirect.B"},
        Gathering::part,
        false},
       {"transmission-direct",
        {"transmission_direct.R", "transmission_direct.G", "transmission_direct.B"},
        Gathering::part,
        false},
       {"transmission-indirect",
        {"transmission_indirect.R", "transmission_indirect.G", "transmission_indirect.B"},
        Gathering::part,
        false}}};
  return table[std::size_t(layer)];
}

std::size_t channel_count(Layer layer) { return layer_info(layer).channels.size(); }

std::vector<Layer> all_layers() {
  std::vector<Layer> all;
  for (std::size_t i = 0; i < layer_count; ++i) all.push_back(Layer(i));
  return all;
}

std::vector<Layer> light_parts() {
  std::vector<Layer> parts = all_layers();
  std::erase_if(parts, [](Layer layer) { return layer_info(layer).gathering != Gathering::part; });
  return parts;
}

}  // namespace twinray
