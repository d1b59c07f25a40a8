// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/writer_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/angle.h"
#include "core/elementary.h"
#include "core/frame.h"

namespace twinray {
namespace {

/// What stands for the depths that a camera without clip distances sees, in sizes of the scene.
constexpr float near_part = 1e-4f, far_part = 1e2f;

/// A node's space, whose -z looks along `forward`.
GltfJson node_matrix(const Vec3& right, const Vec3& up, const Vec3& forward, const Vec3& position) {
  Transform t;
  const Vec3 columns[4] = {right, up, -forward, position};
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column) t.m[row][column] = double(columns[column][row]);
  return gltf_matrix(t);
}

void name_camera_losses(const Camera& camera, const RenderDefaults::Resolution& size, Losses& losses) {
  if (is_panorama(camera.projection))
    losses.add(
        fmt::format("the {} camera is a perspective one of 90 degrees", projection_name(camera.projection)));
  if (has_lens(camera)) losses.add("the camera's lens is a pinhole");
  if (camera.frame_center != Vec2{0, 0}) losses.add("the shift of the camera's frame is left out");
  if (dot(cross(camera.right, camera.up), camera.forward) > 0)
    losses.add("the camera shows the scene mirrored, which readers may not follow");
  const float picture = float(size.width) / float(size.height);
  constexpr float tolerance = 1e-3f;
  if (!is_panorama(camera.projection) &&
      std::fabs(camera.tan_half_width / camera.tan_half_height - picture) > tolerance * picture)
    losses.add("the camera's pixels are oblong, which readers may not follow");
}

/// A perspective frame that readers take, who may refuse one of less or more.
void limit_frame(Camera& camera, Losses& losses) {
  constexpr float least_tangent = 1e-5f, longest = 9999;
  const float height = std::clamp(camera.tan_half_height, least_tangent, 1 / least_tangent);
  const float ratio = camera.tan_half_width / camera.tan_half_height;
  const float width = height * std::clamp(ratio, 1 / longest, longest);
  if (height == camera.tan_half_height && std::fabs(width - height * ratio) <= 1e-6f * width) return;
  losses.add("the camera's frame is another one: it is too narrow, too wide or too long");
  camera.tan_half_height = height;
  camera.tan_half_width = width;
}

class Lights {
 public:
  Lights(const Scene& scene, GltfFile& file) : scene_(scene), file_(file) {}

  void add() {
    for (const Light& light : scene_.lights) {
      name_ = light.name;
      std::visit([&](const auto& source) { add(source); }, light.source);
    }
    if (lights_.empty()) return;
    file_.use("KHR_lights_punctual");
    file_.set_extension("KHR_lights_punctual", {{"lights", lights_}});
  }

 private:
  void lose(const std::string& type, const char* words) {
    file_.output.losses.add(fmt::format("{} {} light {}", article_of(type), type, words),
                            fmt::format("{{}} {} lights: each {}", type, words));
  }
  void check(const Attenuation& attenuation, const char* type) {
    if (attenuation.constant != 0 || attenuation.linear != 0 || attenuation.quadratic != 1)
      lose(type, "falls off with the square of the distance, not as the scene says");
  }

  GltfJson light_of(const char* type, const Rgb& amount) {
    const auto [color, strength] = gltf_light(amount);
    return {{"name", name_},
            {"type", type},
            {"color", gltf_color(color)},
            {"intensity", shortest_decimal(strength)}};
  }
  void place(const GltfJson& light, const GltfJson& place) {
    GltfJson node{{"name", name_}};
    node.update(place);
    node["extensions"]["KHR_lights_punctual"]["light"] = lights_.size();
    lights_.push_back(light);
    file_.add_node(node);
  }
  static GltfJson at(const Vec3& p) {
    return {{"translation", {shortest_decimal(p.x), shortest_decimal(p.y), shortest_decimal(p.z)}}};
  }
  static GltfJson along(const Vec3& direction, const Vec3& position) {
    const Frame frame(-direction);
    return {{"matrix", node_matrix(frame.tangent, frame.bitangent, direction, position)}};
  }

  void add(const MeshLight&) {}  // with its shape
  void add(const SphereLight&) { lose("sphere", "is a mesh that emits"); }
  void add(const PointLight& light) {
    check(light.attenuation, "point");
    place(light_of("point", light.intensity), at(light.position));
  }
  void add(const SpotLight& light) {
    check(light.attenuation, "spot");
    if (light.falloff_exponent != 0) lose("spot", "is as bright beside its axis as along it");
    if (light.falloff_angle_degrees > 180) lose("spot", "has a cone of a half of all directions at most");
    const double outer =
        std::min(double(light.falloff_angle_degrees) / 2 * radians_per_degree, pi_double / 2);
    const double inner = outer - double(light.penumbra_degrees) * radians_per_degree;
    GltfJson json = light_of("spot", light.intensity);
    json["spot"] = {{"innerConeAngle", std::clamp(inner, 0.0, std::nextafter(outer, 0.0))},
                    {"outerConeAngle", outer}};
    place(json, along(light.direction, light.position));
  }
  void add(const DirectionalLight& light) {
    place(light_of("directional", light.irradiance), along(light.direction, {}));
  }
  void add(const SunLight& light) {
    lose("sun", "is a direction, without a disc");
    place(light_of("directional", light.irradiance), along(light.direction, {}));
  }
  void add(const GoniometricLight& light) {
    lose("goniometric", "is a point that shines the same to all sides");
    place(light_of("point", light.intensity * mean_of(*light.map)), at(light.position));
  }
  /// A cone around its frame.
  void add(const ProjectionLight& light) {
    lose("projection", "is a spot of its mean color");
    const double outer =
        2 * pi_double * atan2_turns(double(std::max(light.tan_half_width, light.tan_half_height)), 1);
    GltfJson json = light_of("spot", light.intensity * mean_of(*light.picture));
    json["spot"] = {{"innerConeAngle", std::nextafter(outer, 0.0)}, {"outerConeAngle", outer}};
    place(json, along(light.forward, light.position));
  }
  void add(const AmbientLight&) { lose("ambient", "is left out"); }
  void add(const EnvironmentLight&) { lose("environment", "is left out"); }

  const Scene& scene_;
  GltfFile& file_;
  std::string name_;
  GltfJson lights_ = GltfJson::array();
};

}  // namespace

void add_gltf_camera(const SceneToWrite& input, GltfFile& file) {
  const RenderDefaults::Resolution& size = *input.picture.resolution;
  Camera camera = fit_frame(input.scene.camera, size.width, size.height);
  name_camera_losses(camera, size, file.output.losses);
  if (input.picture.crop) file.output.losses.add("the picture's crop is left out");
  if (input.picture.daylight_kelvin) file.output.losses.add("the picture's white balance is left out");
  if (is_panorama(camera.projection)) {
    camera.tan_half_height = 1;
    camera.tan_half_width = float(size.width) / float(size.height);
  }
  const Vec3 extent = input.scene.geometry->bounds().extent();
  const float reach = std::max(max_abs(extent), 1e-6f) + max_abs(camera.position);
  // What stands for one of both distances lies on its side of the other one.
  const float near = camera.clip_near > 0 ? camera.clip_near : near_part * std::min(reach, camera.clip_far);
  const float far =
      std::isfinite(camera.clip_far) ? camera.clip_far : far_part * std::max(reach, camera.clip_near);
  GltfJson lens;
  if (camera.projection == Projection::orthographic) {
    lens = {{"type", "orthographic"},
            {"orthographic",
             {{"xmag", shortest_decimal(camera.tan_half_width)},
              {"ymag", shortest_decimal(camera.tan_half_height)},
              {"znear", shortest_decimal(camera.clip_near)},
              {"zfar", shortest_decimal(far)}}}};
  } else {
    limit_frame(camera, file.output.losses);
    lens = {{"type", "perspective"},
            {"perspective",
             {{"aspectRatio", shortest_decimal(camera.tan_half_width / camera.tan_half_height)},
              {"yfov", 4 * pi_double * atan2_turns(double(camera.tan_half_height), 1)},
              {"znear", shortest_decimal(near)}}}};
    if (std::isfinite(camera.clip_far)) lens["perspective"]["zfar"] = shortest_decimal(camera.clip_far);
  }
  const std::size_t index = file.add("cameras", lens);
  file.add_node({{"name", "camera"},
                 {"camera", index},
                 {"matrix", node_matrix(camera.right, camera.up, camera.forward, camera.position)}});
}

void add_gltf_lights(const Scene& scene, GltfFile& file) { Lights(scene, file).add(); }

}  // namespace twinray
