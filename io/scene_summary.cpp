// SPDX-License-Identifier: Apache-2.0
#include "io/scene_summary.h"

#include <fmt/format.h>

#include <cmath>

#include "core/mesh_area.h"
#include "core/point_light.h"
#include "core/warp.h"

namespace twinray {
namespace {

double mesh_area(const Mesh& mesh) {
  double sum = 0;
  for (const Triangle& triangle : mesh.triangles) sum += area_vector(mesh, triangle).area();
  return sum;
}

/// Fills all but the name.
struct Summarize {
  const Geometry& geometry;

  LightSummary operator()(const MeshLight& light) const {
    const double sides = light.side == EmissionSide::both ? 2 : 1;
    const double factor = sides * pi * mesh_area(*geometry.mesh(light.shape));
    return {"", sides == 2 ? "mesh, both sides" : "mesh, one side", "radiance", mean_radiance(light),
            mean_radiance(light) * float(factor)};
  }
  LightSummary operator()(const SphereLight& light) const {
    const float radius = geometry.sphere_set(light.shape)->spheres[0].radius;
    return {"", "sphere", "radiance", light.radiance, light.radiance * (4 * pi * pi * radius * radius)};
  }
  LightSummary operator()(const PointLight& light) const {
    return {"", "point", "intensity", light.intensity, power_of(light)};
  }
  LightSummary operator()(const SpotLight& light) const {
    return {"", "spot", "intensity", light.intensity, power_of(light)};
  }
  LightSummary operator()(const GoniometricLight& light) const {
    return {"", "goniometric", "intensity, times the picture,", light.intensity, {}};
  }
  LightSummary operator()(const ProjectionLight& light) const {
    return {"", "projection", "intensity, times the picture,", light.intensity, {}};
  }
  LightSummary operator()(const SunLight& light) const {
    return {
        "", fmt::format("sun of {:g} degrees", light.diameter_degrees), "irradiance", light.irradiance, {}};
  }
  LightSummary operator()(const DirectionalLight& light) const {
    return {"", "directional", "irradiance", light.irradiance, {}};
  }
  LightSummary operator()(const AmbientLight& light) const {
    return {"", "ambient, the hemisphere around up", "radiance", light.radiance, {}};
  }
  LightSummary operator()(const EnvironmentLight& light) const {
    double r = 0, g = 0, b = 0;
    for (const Rgb& pixel : light.map->pixels) r += pixel.r, g += pixel.g, b += pixel.b;
    const double n = double(light.map->pixels.size());
    return {"",
            fmt::format("environment, {} x {} pixels", light.map->width, light.map->height),
            "mean of pixels",
            light.scale * Rgb{float(r / n), float(g / n), float(b / n)},
            {}};
  }
};

std::string plural(std::size_t count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string rgb_text(const Rgb& c) { return fmt::format("{:.4g} {:.4g} {:.4g}", c.r, c.g, c.b); }

std::string animation_line(const AnimationSummary& animation) {
  const auto& [first, last, shown, shutter] = animation;
  return fmt::format(
      "animation: {:g} to {:g} s, {}", first, last,
      shutter ? fmt::format("the shutter is open from {:g} to {:g} s", shutter->open, shutter->close)
      : shown ? fmt::format("shown at {:g} s", *shown)
              : "shown at rest; --time=T shows another moment, --time=T,END motion");
}

std::string other_cameras(const SceneSummary& summary) {
  if (summary.cameras.size() < 2) return "";
  return fmt::format(", one of {}; --camera-name=NAME chooses another, --camera-name=? lists them",
                     summary.cameras.size());
}

}  // namespace

void count_scene(const Scene& scene, SceneSummary& summary) {
  summary.triangles = scene.geometry->triangle_count();
  summary.spheres = scene.geometry->sphere_count();
  for (const Shape& shape : scene.geometry->shapes()) summary.meshes += std::holds_alternative<Mesh>(shape);
  summary.prototypes = scene.geometry->prototypes().size();
  summary.instances = scene.geometry->instances().size();
  summary.seen_primitives = scene.geometry->seen_primitives();
  summary.materials = scene.materials.size();
  for (const Light& light : scene.lights) {
    summary.lights.push_back(std::visit(Summarize{*scene.geometry}, light.source));
    summary.lights.back().name = light.name;
  }
}

std::vector<std::string> summary_lines(const SceneSummary& summary) {
  std::vector<std::string> lines;
  if (!summary.unit_name.empty())
    lines.push_back(fmt::format("unit: {} ({:g} m), kept as it is; up axis: {}{}", summary.unit_name,
                                summary.unit_meters, summary.up_axis,
                                summary.up_axis == 'Y' ? "" : ", turned to Y"));
  lines.push_back(
      summary.camera.empty()
          ? "camera: none in the file; a default one sees the whole scene from the front, right and above"
          : fmt::format("camera: \"{}\"{}", summary.camera, other_cameras(summary)));
  std::string shapes = fmt::format("shapes: {}, {}, {}", plural(summary.meshes, "mesh", "meshes"),
                                   plural(summary.triangles, "triangle", "triangles"),
                                   plural(summary.spheres, "sphere", "spheres"));
  if (summary.dropped_triangles > 0)
    shapes += fmt::format("; {} dropped",
                          plural(summary.dropped_triangles, "degenerate triangle", "degenerate triangles"));
  lines.push_back(shapes + "; " + plural(summary.materials, "material", "materials"));
  if (summary.instances > 0)
    lines.push_back(fmt::format("instances: {} of {}, by which {} triangles and spheres are seen",
                                summary.instances, plural(summary.prototypes, "prototype", "prototypes"),
                                summary.seen_primitives));
  if (summary.animation) lines.push_back(animation_line(*summary.animation));
  if (summary.lights.empty()) lines.push_back("lights: none");
  for (const LightSummary& light : summary.lights) {
    std::string line = fmt::format("light \"{}\": {}, {} {}", light.name, light.kind, light.quantity,
                                   rgb_text(light.amount));
    if (!is_black(light.power)) line += fmt::format(", power {}", rgb_text(light.power));
    lines.push_back(line);
  }
  for (const std::string& note : summary.notes) lines.push_back("note: " + note);
  return lines;
}

}  // namespace twinray
