// SPDX-License-Identifier: Apache-2.0
#include "io/exchange/json.h"

#include <fmt/format.h>

#include <string_view>

#include "io/decimal.h"

namespace twinray {
namespace {

constexpr std::string_view ending = ".json";

/// "room.json" and "-3.ply" -> "room-3.ply".
std::string beside(const std::string& path, const std::string& suffix) {
  return path.substr(0, path.size() - ending.size()) + suffix;
}

}  // namespace

Json json_of(float number) { return shortest_decimal(number); }

Json json_of(const Vec2& v) { return {json_of(v.x), json_of(v.y)}; }
Json json_of(const Vec3& v) { return {json_of(v.x), json_of(v.y), json_of(v.z)}; }
Json json_of(const Rgb& color) { return {json_of(color.r), json_of(color.g), json_of(color.b)}; }
Json json_of(const Roughness& roughness) { return {json_of(roughness.x), json_of(roughness.y)}; }

Json json_of(const Transform& rotation) {
  Json object;
  for (int column = 0; column < 3; ++column)
    object[std::string(1, char('x' + column))] = {rotation.m[0][column], rotation.m[1][column],
                                                  rotation.m[2][column]};
  return object;
}

Json json_of(const Attenuation& attenuation) {
  Json object;
  Attenuation copy = attenuation;
  members(MemberWriter(object), copy);
  return object;
}

Json json_of(const Wrap& wrap) {
  if (wrap.u == wrap.v) return json_of(wrap.u);
  return Json::array({json_of(wrap.u), json_of(wrap.v)});
}

namespace {

template <typename Matrix>
Json rows_of(const Matrix& matrix) {
  Json rows = Json::array();
  for (const auto& row : matrix) {
    rows.push_back(Json::array());
    for (const float number : row) rows.back().push_back(json_of(number));
  }
  return rows;
}

}  // namespace

Json json_of(const UvTransform& uv) { return rows_of(uv.m); }
Json json_of(const PointTransform& map) { return rows_of(map.m); }

std::string exchange_mesh_file(const std::string& path, std::size_t shape) {
  return beside(path, fmt::format("-{}.ply", shape));
}
std::string exchange_light_file(const std::string& path, std::size_t light) {
  return beside(path, fmt::format("-light-{}.exr", light));
}
std::string exchange_texture_file(const std::string& path, std::size_t texture) {
  return beside(path, fmt::format("-texture-{}.exr", texture));
}
std::string exchange_density_file(const std::string& path, std::size_t density) {
  return beside(path, fmt::format("-density-{}.exr", density));
}
std::string exchange_brdf_file(const std::string& path, std::size_t material) {
  return beside(path, fmt::format("-material-{}.bsdf", material));
}

}  // namespace twinray
