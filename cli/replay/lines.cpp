// SPDX-License-Identifier: Apache-2.0
#include "cli/replay/lines.h"

#include <algorithm>
#include <cmath>

namespace twinray {
namespace {

/// The diagonal of all shapes; 1 without any.
float size_of(const Scene& scene) {
  const Aabb& bounds = scene.geometry->bounds();
  const float size = length(bounds.upper - bounds.lower);
  return std::isfinite(size) && size > 0 ? size : 1;
}

/// Where a ray ends that goes no further than `farthest`.
Vec3 end_of(const Ray& ray, float farthest) {
  const float most = farthest / length(ray.direction);
  return ray.origin + ray.direction * std::min(ray.t_max, most);
}

/// The path's own line.
std::vector<Vec3> path_of(const PathLog& path, float size) {
  std::vector<Vec3> points{path.vertices().front().arrival.ray.origin};
  for (const PathVertex& vertex : path.vertices())
    if (vertex.surface)
      points.push_back(vertex.surface->point().position);
    else if (!vertex.arrival.hit.is_miss())
      points.push_back(vertex.arrival.ray.origin + vertex.arrival.ray.direction * vertex.arrival.hit.t);
    else
      points.push_back(end_of(vertex.arrival.ray, size));
  return points;
}

}  // namespace

std::vector<LineObject> replay_lines(const ReplayedSample& replayed) {
  const float size = size_of(replayed.scene), normal_length = 0.03f * size;
  const PathLog& path = replayed.replay.path;
  LineObject seen{"light_samples", {}}, blocked{"blocked_light_samples", {}}, normals{"normals", {}};
  for (const PathVertex& vertex : path.vertices()) {
    if (!vertex.surface) continue;
    const Vec3& position = vertex.surface->point().position;
    normals.lines.push_back({position, position + vertex.surface->normal() * normal_length});
    for (const auto& [taken, weight, bsdf_pdf] : vertex.light_samples) {
      if (is_black(taken.scattered)) continue;
      const Ray& ray = taken.sample.shadow_ray;
      (is_black(taken.visibility) ? blocked : seen).lines.push_back({ray.origin, end_of(ray, size)});
    }
  }
  std::vector<LineObject> objects{{"path", {path_of(path, size)}}, seen, blocked, normals};
  std::erase_if(objects, [](const LineObject& object) { return object.lines.empty(); });
  return objects;
}

}  // namespace twinray
