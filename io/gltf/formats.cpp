// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/formats.h"

#include <algorithm>
#include <iterator>

namespace twinray {
namespace {

constexpr std::string_view any_rotation = "5126 5120n 5121n 5122n 5123n";

constexpr GltfFormat vertex_formats[] = {
    {"POSITION", "VEC3", "5126", "5120 5120n 5121 5121n 5122 5122n 5123 5123n"},
    {"NORMAL", "VEC3", "5126", "5120n 5122n"},
    {"TANGENT", "VEC4", "5126", "5120n 5122n"},
    {"TEXCOORD_n", "VEC2", "5126 5121n 5123n", "5120 5120n 5121 5122 5122n 5123"},
    {"COLOR_n", "VEC3 VEC4", "5126 5121n 5123n", "", true},
    {"JOINTS_n", "VEC4", "5121 5123"},
    {"WEIGHTS_n", "VEC4", "5126 5121n 5123n", "", true}};

constexpr GltfFormat target_formats[] = {
    {"POSITION of a morph target", "VEC3", "5126", "5120 5120n 5122 5122n"},
    {"NORMAL of a morph target", "VEC3", "5126", "5120n 5122n"},
    {"TANGENT of a morph target", "VEC3", "5126", "5120n 5122n"}};

constexpr GltfFormat instance_formats[] = {{"TRANSLATION of instances", "VEC3", "5126", "", true},
                                           {"ROTATION of instances", "VEC4", "5126 5120n 5122n", "", true},
                                           {"SCALE of instances", "VEC3", "5126", "", true}};

constexpr GltfFormat output_formats[] = {{"translations of an animation", "VEC3", "5126", "", true},
                                         {"rotations of an animation", "VEC4", any_rotation, "", true},
                                         {"scales of an animation", "VEC3", "5126", "", true},
                                         {"weights of an animation", "SCALAR", any_rotation, "", true}};

/// The one whose use begins with these letters, of a list that has one.
template <std::size_t n>
const GltfFormat& find(const GltfFormat (&formats)[n], std::string_view start) {
  return *std::find_if(std::begin(formats), std::end(formats) - 1,
                       [&](const GltfFormat& each) { return each.use.starts_with(start); });
}

}  // namespace

const GltfFormat& vertex_format(std::string_view attribute) {
  const std::size_t number = attribute.find('_');
  return find(vertex_formats, attribute.substr(0, number == std::string_view::npos ? number : number + 1));
}

const GltfFormat& target_format(std::string_view attribute) { return find(target_formats, attribute); }

const GltfFormat& instance_format(std::string_view attribute) { return find(instance_formats, attribute); }

const GltfFormat& output_format(std::string_view path) { return find(output_formats, path); }

}  // namespace twinray
