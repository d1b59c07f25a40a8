// SPDX-License-Identifier: Apache-2.0
#include "tests/support/round_trip.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "io/exchange/writer.h"
#include "io/scene_file.h"
#include "io/scene_writer.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

constexpr int width = 480, height = 360;

float apart(const Vec3& a, const Vec3& b) { return max_abs(a - b); }

/// Adds one triangle's corners to the difference.
void compare(const Mesh& a, const Mesh& b, std::size_t triangle, GeometryDifference& d) {
  for (std::size_t k = 0; k < 3; ++k) {
    d.positions = std::max(
        d.positions, apart(a.positions[a.triangles[triangle][k]], b.positions[b.triangles[triangle][k]]));
    if (!a.normals.empty()) {
      const Vec3 &m = a.normals[a.normal_indices[triangle][k]], &n = b.normals[b.normal_indices[triangle][k]];
      d.normals = std::max(d.normals, std::min(apart(m, n), apart(m, -n)));
    }
    if (a.uvs.empty() != b.uvs.empty()) d.has_lost_uvs = true;
    if (!a.uvs.empty() && !b.uvs.empty()) {
      const Vec2 s = a.uvs[a.uv_indices[triangle][k]], t = b.uvs[b.uv_indices[triangle][k]];
      d.uvs = std::max({d.uvs, std::fabs(s.x - t.x), std::fabs(s.y - t.y)});
    }
  }
}

std::string fault_of(const Mesh& a, const Mesh& b) {
  if (a.triangles.size() != b.triangles.size())
    return fmt::format("{} has {} triangles, not {}", a.name, b.triangles.size(), a.triangles.size());
  return a.normals.empty() != b.normals.empty() ? a.name + " has normals in one scene alone" : "";
}

nlohmann::json exchange(const Scene& scene) {
  return nlohmann::json::parse(exchange_json(scene, "a.json", {width, height}));
}

nlohmann::json without_names(nlohmann::json entry) {
  for (const char* key : {"name", "shape", "file"}) entry.erase(key);
  return entry;
}

}  // namespace

RoundTrip round_trip(const Scene& scene, const std::string& name, LoadOptions options) {
  const TemporaryFolder folder;
  const std::string path = folder.file(name);
  const WrittenScene written = written_scene({scene, {.resolution = {{width, height}}}}, path);
  write_files(written);
  RoundTrip trip;
  trip.text = read_text(path);
  for (const std::string& warning : written.warnings)
    trip.warnings.push_back(warning.substr(path.size() + 2));
  if (options.instances == InstanceUse::automatic) options.instances = InstanceUse::keep;
  options.strict = true;
  trip.scene = load_scene(path, options).scene;
  return trip;
}

Scene scene_of(Shape shape, const SurfaceModel& model) {
  Scene scene;
  scene.materials = {{"stuff", model}};
  scene.bindings = {{}};
  scene.geometry = std::make_shared<const Geometry>(std::vector<Shape>{std::move(shape)});
  return scene;
}

const Material& only_material(const RoundTrip& trip) {
  return trip.scene.materials[trip.scene.bindings[0].material];
}

GeometryDifference difference(const Scene& a, const Scene& b) {
  GeometryDifference d;
  const auto &of_a = a.geometry->shapes(), &of_b = b.geometry->shapes();
  if (of_a.size() != of_b.size()) d.fault = fmt::format("{} shapes, not {}", of_b.size(), of_a.size());
  for (std::size_t i = 0; i < of_a.size() && d.fault.empty(); ++i) {
    const auto *mesh = std::get_if<Mesh>(&of_a[i]), *other = std::get_if<Mesh>(&of_b[i]);
    if (!mesh != !other) d.fault = fmt::format("shape {} is of another kind", i);
    if (mesh && other) d.fault = fault_of(*mesh, *other);
    if (!d.fault.empty()) break;
    for (std::size_t k = 0; mesh && k < mesh->triangles.size(); ++k) compare(*mesh, *other, k, d);
    if (mesh) continue;
    const auto &spheres = std::get<SphereSet>(of_a[i]).spheres,
               &others = std::get<SphereSet>(of_b[i]).spheres;
    if (spheres.size() != others.size()) d.fault = fmt::format("shape {} has other spheres", i);
    for (std::size_t k = 0; k < std::min(spheres.size(), others.size()); ++k)
      d.positions = std::max({d.positions, apart(spheres[k].center, others[k].center),
                              std::fabs(spheres[k].radius - others[k].radius)});
  }
  return d;
}

nlohmann::json surfaces(const Scene& scene) {
  const nlohmann::json json = exchange(scene);
  nlohmann::json list = nlohmann::json::array();
  for (const ShapeBinding& binding : scene.bindings) {
    list.push_back({{"material", without_names(json["materials"][binding.material])}});
    if (binding.light != no_light) list.back()["light"] = without_names(json["lights"][binding.light]);
  }
  return list;
}

nlohmann::json free_lights(const Scene& scene) {
  nlohmann::json list = nlohmann::json::array();
  const nlohmann::json json = exchange(scene);
  for (const nlohmann::json& light : json["lights"])
    if (!light.contains("shape")) list.push_back(without_names(light));
  return list;
}

std::string first_difference(const nlohmann::json& a, const nlohmann::json& b, double tolerance) {
  if (a.is_number() && b.is_number()) {
    const double x = a.get<double>(), y = b.get<double>();
    return std::fabs(x - y) <= tolerance * std::max({std::fabs(x), std::fabs(y), 1e-3})
               ? ""
               : fmt::format(": {} and {}", x, y);
  }
  if (a.type() != b.type() || a.size() != b.size()) return ": " + a.dump() + " and " + b.dump();
  if (!a.is_structured()) return a == b ? "" : ": " + a.dump() + " and " + b.dump();
  for (const auto& [key, value] : a.items()) {
    if (a.is_object() && !b.contains(key)) return "/" + key + " is not there";
    const nlohmann::json& other = a.is_object() ? b[key] : b[std::size_t(std::stoul(key))];
    const std::string found = first_difference(value, other, tolerance);
    if (!found.empty()) return "/" + key + found;
  }
  return "";
}

float difference(const Camera& a, const Camera& b) {
  const Camera first = fit_frame(a, width, height), second = fit_frame(b, width, height);
  float most = 0;
  for (const Vec2 frame : {Vec2{0.5f, 0.5f}, {0, 0}, {1, 0}, {0, 1}, {0.3f, 0.9f}})
    for (const Vec2 lens : {Vec2{0, 0}, {0.5f, -0.25f}}) {
      const Ray p = camera_ray(first, frame, lens), q = camera_ray(second, frame, lens);
      most = std::max({most, apart(p.origin, q.origin), apart(p.direction, q.direction)});
    }
  return most;
}

}  // namespace twinray::test
