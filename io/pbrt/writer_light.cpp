// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/writer_light.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/angle.h"
#include "core/direction_map.h"
#include "core/elementary.h"
#include "core/frame.h"
#include "io/pbrt/emitted_picture.h"
#include "io/pbrt/text.h"
#include "io/picture/equal_area.h"
#include "io/picture/image_file.h"
#include "io/turned_emitter.h"

namespace twinray {
namespace {

Transform moved(Transform rotation, const Vec3& position) {
  for (int row = 0; row < 3; ++row) rotation.m[row][3] = double(position[row]);
  return rotation;
}

Transform columns(const Vec3& x, const Vec3& y, const Vec3& z) {
  Transform t;
  for (int row = 0; row < 3; ++row)
    t.m[row][0] = double(x[row]), t.m[row][1] = double(y[row]), t.m[row][2] = double(z[row]);
  return t;
}

/// A picture whose width has about this ratio to its height, and no side of which is shorter than it was; a
/// small one is larger, so that the ratio is nearly exact.
Image stretched(const Image& picture, double ratio) {
  constexpr double least = 512, most = 8192;
  const double width = std::max(double(picture.width), picture.height * ratio), height = width / ratio;
  const double scale =
      std::min(std::max(1.0, least / std::max(width, height)), most / std::max(width, height));
  const auto pixels = [](double side) { return std::max(1, int(std::lround(side))); };
  Image image(pixels(width * scale), pixels(height * scale));
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      image.at(x, y) = clamped_value(picture, {(x + 0.5) / image.width, (y + 0.5) / image.height});
  return image;
}

/// A picture times a factor: pbrt has a number there, not a colour.
struct ScaledPicture {
  std::shared_ptr<const Image> image;
  float scale = 1;
};
ScaledPicture scaled(std::shared_ptr<const Image> image, const Rgb& factor) {
  if (is_grey(factor)) return {std::move(image), factor.r};
  auto tinted = std::make_shared<Image>(*image);
  for (Rgb& pixel : tinted->pixels) pixel = pixel * factor;
  return {tinted, 1};
}

/// The picture of a light, in a file of its own.
std::string picture_parameters(const ScaledPicture& picture, std::size_t light, SceneOutput& output) {
  const auto write = [image = picture.image](const std::string& path) { write_exr(path, *image); };
  return pbrt_word("filename", output.add(fmt::format("-pbrt-light-{}.exr", light), write)) +
         pbrt_real("scale", picture.scale);
}

/// Writes the lights of a scene, one after the other.
class Writer {
 public:
  explicit Writer(SceneOutput& output) : output_(output) {}

  void add(const Light& light, std::size_t index) {
    index_ = index;
    name_ = light.name;
    std::visit([&](const auto& source) { add(source); }, light.source);
  }

  std::string text;

 private:
  void statement(const Transform& place, const char* type, const std::string& parameters) {
    text += pbrt_comment(name_) + "AttributeBegin\n" + pbrt_transform(place) +
            fmt::format("LightSource \"{}\"{}\nAttributeEnd\n", type, parameters);
  }
  void lose(const std::string& type, const char* words) {
    output_.losses.add(fmt::format("{} {} light {}", article_of(type), type, words),
                       fmt::format("{{}} {} lights: each {}", type, words));
  }

  std::string picture(const ScaledPicture& picture) { return picture_parameters(picture, index_, output_); }

  void check(const Attenuation& attenuation, const char* type) {
    if (attenuation.constant != 0 || attenuation.linear != 0 || attenuation.quadratic != 1)
      lose(type, "falls off with the square of the distance, not as the scene says");
  }

  void add(const MeshLight&) {}    // with its shape
  void add(const SphereLight&) {}  // with its shape
  void add(const PointLight& light) {
    check(light.attenuation, "point");
    statement(moved({}, light.position), "point", pbrt_rgb("I", light.intensity));
  }
  void add(const SpotLight& light) {
    check(light.attenuation, "spot");
    if (light.falloff_exponent != 0) lose("spot", "is as bright beside its axis as along it");
    statement(moved({}, light.position), "spot",
              pbrt_rgb("I", light.intensity) + pbrt_point("from", {}) + pbrt_point("to", light.direction) +
                  pbrt_real("coneangle", light.falloff_angle_degrees / 2) +
                  pbrt_real("conedeltaangle", light.penumbra_degrees));
  }
  void distant(const Vec3& direction, const Rgb& irradiance) {
    statement({}, "distant",
              pbrt_rgb("L", irradiance) + pbrt_point("from", {}) + pbrt_point("to", direction));
  }
  void add(const DirectionalLight& light) { distant(light.direction, light.irradiance); }
  void add(const SunLight& light) {
    lose("sun", "is a direction, without a disc");
    distant(light.direction, light.irradiance);
  }
  void add(const AmbientLight& light) {
    lose("ambient", "is an environment, which is seen");
    const Frame frame(light.up);
    statement(columns(frame.tangent, frame.bitangent, frame.normal), "infinite",
              picture({std::make_shared<const Image>(hemisphere(light.radiance)), 1}));
  }

  /// pbrt takes squares of equal areas alone.
  std::shared_ptr<const Image> square(const std::shared_ptr<const Image>& map, MapLayout layout,
                                      const char* type) {
    if (layout == MapLayout::equal_area) return map;
    lose(type, "is drawn anew as a square of equal areas");
    return std::make_shared<const Image>(equal_area_of(*map, layout));
  }
  void add(const EnvironmentLight& light) {
    const Image& map = *light.map;
    if (map.pixels.size() == 1) return statement({}, "infinite", pbrt_rgb("L", map.pixels[0] * light.scale));
    statement(light.rotation, "infinite",
              picture(scaled(square(light.map, light.layout, "environment"), light.scale)));
  }
  /// The light's y axis is the picture's z axis.
  void add(const GoniometricLight& light) {
    if (!std::all_of(light.map->pixels.begin(), light.map->pixels.end(), is_grey))
      lose("goniometric", "shines in one color, by the mean of its picture's channels");
    const Transform swap{{{1, 0, 0, 0}, {0, 0, 1, 0}, {0, 1, 0, 0}}};
    statement(moved(light.rotation * swap, light.position), "goniometric",
              pbrt_rgb("I", light.intensity) + picture({square(light.map, light.layout, "goniometric"), 1}));
  }
  /// pbrt's frames have their pictures' sides.
  std::shared_ptr<const Image> of_frame(const ProjectionLight& light) {
    const Image& picture = *light.picture;
    const double width = picture.width, height = picture.height;
    const double ratio = double(light.tan_half_width) / double(light.tan_half_height);
    constexpr double tolerance = 1e-6;
    if (std::fabs(ratio * height / width - 1) < tolerance) return light.picture;
    lose("projection", "has a picture that is drawn anew, with the sides of its frame");
    return std::make_shared<const Image>(stretched(picture, ratio));
  }
  /// "fov" is that of the picture's shorter side.
  void add(const ProjectionLight& light) {
    const float shorter = std::min(light.tan_half_width, light.tan_half_height);
    statement(moved(columns(light.right, light.up, light.forward), light.position), "projection",
              pbrt_real("fov", float(2 * degrees_per_turn * atan2_turns(double(shorter), 1))) +
                  picture(scaled(of_frame(light), light.intensity)));
  }

  SceneOutput& output_;
  std::size_t index_ = 0;
  std::string name_;
};

}  // namespace

std::string pbrt_lights(const Scene& scene, SceneOutput& output) {
  Writer writer(output);
  for (std::size_t i = 0; i < scene.lights.size(); ++i) writer.add(scene.lights[i], i);
  return writer.text;
}

std::string pbrt_area_light(const Scene& scene, std::uint32_t light, SceneOutput& output) {
  const std::string begin = "AreaLightSource \"diffuse\"";
  const LightSource& source = scene.lights[light].source;
  if (const auto* sphere = std::get_if<SphereLight>(&source))
    return begin + pbrt_rgb("L", sphere->radiance) + "\n";
  const auto& mesh = std::get<MeshLight>(source);
  name_turned_emitter(scene, mesh, output.losses);
  std::string text = begin;
  text += mesh.picture ? picture_parameters(scaled(emitted_picture(mesh), mesh.radiance), light, output)
                       : pbrt_rgb("L", mesh.radiance);
  if (mesh.picture && !is_emitted_whole(mesh, std::get<Mesh>(scene.geometry->shapes()[mesh.shape]).uvs))
    output.losses.add(
        "a picture that emits ends with the unit square of the texture coordinates, and goes on as at its "
        "edge",
        "{} pictures that emit end with the unit square of the texture coordinates, and go on as at their "
        "edges");
  if (mesh.side == EmissionSide::both) text += pbrt_flag("twosided", true);
  if (mesh.side == EmissionSide::back) text += "\nReverseOrientation";
  return text + "\n";
}

}  // namespace twinray
