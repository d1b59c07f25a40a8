// SPDX-License-Identifier: Apache-2.0
#include "core/layer.h"

#include <array>

#include <fmt/format.h>

namespace twinray {
namespace {

/// Where the camera sees nothing, as Cycles has it: farther than any scene, and no infinity that a filter
/// would spread.
constexpr float no_depth = 1e10f;

/// Of a Cryptomatte: pairs of an id and its coverage, two of them in each sub-layer.
std::vector<std::string> rank_channels(const std::string& name) {
  std::vector<std::string> channels;
  for (std::size_t sub_layer = 0; sub_layer < coverage_ranks / 2; ++sub_layer)
    for (const char channel : {'R', 'G', 'B', 'A'})
      channels.push_back(fmt::format("{}{:02}.{}", name, sub_layer, channel));
  return channels;
}

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
       {"cryptomatte-object", rank_channels("CryptoObject"), Gathering::coverage, false},
       {"cryptomatte-material", rank_channels("CryptoMaterial"), Gathering::coverage, false},
       {"cryptomatte-asset", rank_channels("CryptoAsset"), Gathering::coverage, false}}};
  return table[std::size_t(layer)];
}

std::size_t channel_count(Layer layer) { return layer_info(layer).channels.size(); }

std::vector<Layer> all_layers() {
  std::vector<Layer> all;
  for (std::size_t i = 0; i < layer_count; ++i) all.push_back(Layer(i));
  return all;
}

}  // namespace twinray
