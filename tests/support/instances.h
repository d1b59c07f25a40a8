// SPDX-License-Identifier: Apache-2.0
// Geometry with instances, of transforms that are hard for a tree or a ray.
#pragma once
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "core/scene.h"
#include "tests/support/random.h"

namespace twinray::test {

inline double between(Random& random, double low, double high) { return low + (high - low) * random.unit(); }

// One draw a statement: compilers differ in which operand they work out first.
inline Transform turned(Random& random) {
  const double degrees = between(random, 0, 360);
  return Transform::rotation(normalize(random.in_ball()), degrees);
}

inline Transform moved(Random& random, double distance) {
  const Vec3 shift = random.in_cube(float(distance));
  return Transform::translation(shift.x, shift.y, shift.z);
}

/// What an instance may look like.
enum class Kind { rigid, scaled, mirrored, sheared, squashed, tiny, huge, far };
inline constexpr Kind kinds[] = {Kind::rigid,    Kind::scaled, Kind::mirrored, Kind::sheared,
                                 Kind::squashed, Kind::tiny,   Kind::huge,     Kind::far};

inline Transform transform_of(Kind kind, Random& random) {
  const Transform turn = turned(random), place = moved(random, 4) * turn;
  const double size = std::exp2(between(random, -3, 1));
  switch (kind) {
    case Kind::scaled:
      return place * Transform::scaling(size, size, size);
    case Kind::mirrored:
      return place * Transform::scaling(-size, size, 0.5 * size) * turned(random);
    case Kind::sheared: {
      Transform shear;
      shear.m[0][1] = between(random, -3, 3);
      shear.m[1][2] = between(random, -3, 3);
      return place * shear * turned(random);
    }
    case Kind::squashed:
      return place * Transform::scaling(1, 1e-4, 1) * turned(random);
    case Kind::tiny:
      return place * Transform::scaling(1e-6, 1e-6, 1e-6);
    case Kind::huge:
      return place * Transform::scaling(1e5, 1e5, 1e5);
    case Kind::far:
      return Transform::translation(1e6, -3e5, 2e6) * place;
    default:
      return place;
  }
}

/// `direct` in the scene, and `count` instances of each prototype, of the kinds in turn.
inline std::shared_ptr<const Geometry> share_instanced(std::vector<Shape> direct,
                                                       const std::vector<std::vector<Shape>>& prototypes,
                                                       const std::vector<Kind>& of_kinds, int count,
                                                       std::uint64_t seed) {
  Random random(seed);
  Instancing instancing;
  std::vector<Shape> shapes = std::move(direct);
  for (const std::vector<Shape>& prototype : prototypes) {
    instancing.prototypes.push_back({std::uint32_t(shapes.size()), std::uint32_t(prototype.size())});
    shapes.insert(shapes.end(), prototype.begin(), prototype.end());
  }
  for (int i = 0; i < count; ++i)
    for (std::uint32_t prototype = 0; prototype < prototypes.size(); ++prototype) {
      const Kind kind = of_kinds[instancing.instances.size() % of_kinds.size()];
      instancing.instances.push_back({prototype, transform_of(kind, random)});
    }
  return std::make_shared<const Geometry>(std::move(shapes), nullptr, std::move(instancing));
}

/// A copy of a mesh where a transform moves it, rounded to float.
inline Mesh copied(const Mesh& mesh, const Transform& to_world) {
  Mesh copy = mesh;
  for (Vec3& position : copy.positions) position = to_world.point(position);
  for (Vec3& normal : copy.normals) normal = to_world.front(normal);
  return copy;
}

/// Geometry of meshes with a copy in the place of each instance; `names[shape]` is the instance and the shape
/// that it is a copy of.
inline std::shared_ptr<const Geometry> flattened(
    const Geometry& geometry, std::vector<std::pair<std::uint32_t, std::uint32_t>>& names) {
  std::vector<Shape> shapes;
  for (std::uint32_t i = 0; i < geometry.direct_shapes().count; ++i) {
    shapes.push_back(geometry.shapes()[i]);
    names.emplace_back(no_instance, i);
  }
  for (std::uint32_t i = 0; i < geometry.instances().size(); ++i) {
    const auto& [prototype, to_world] = geometry.instances()[i];
    const ShapeRange range = geometry.prototypes()[prototype];
    for (std::uint32_t shape = range.first; shape < range.end(); ++shape) {
      shapes.push_back(copied(*geometry.mesh(shape), to_world));
      names.emplace_back(i, shape);
    }
  }
  return std::make_shared<const Geometry>(std::move(shapes));
}

/// A scene whose shapes without light are shown by two instances, one of them mirrored, and no other way.
inline Scene instanced(const Scene& scene) {
  Scene result = scene;
  result.bindings.clear();
  std::vector<Shape> shapes;
  std::vector<std::uint32_t> now(scene.bindings.size());
  std::uint32_t direct = 0;
  for (const bool is_direct : {true, false}) {
    for (std::uint32_t i = 0; i < scene.bindings.size(); ++i) {
      if ((scene.bindings[i].light != no_light) != is_direct) continue;
      now[i] = std::uint32_t(shapes.size());
      shapes.push_back(scene.geometry->shapes()[i]);
      result.bindings.push_back(scene.bindings[i]);
    }
    if (is_direct) direct = std::uint32_t(shapes.size());
  }
  for (Light& light : result.lights) {
    if (auto* mesh = std::get_if<MeshLight>(&light.source)) mesh->shape = now[mesh->shape];
    if (auto* sphere = std::get_if<SphereLight>(&light.source)) sphere->shape = now[sphere->shape];
  }
  Instancing instancing{{{direct, std::uint32_t(shapes.size()) - direct}}, {}};
  instancing.instances.push_back({0, Transform::rotation({0.1f, 1, 0}, 3)});
  instancing.instances.push_back(
      {0, Transform::translation(0.3, 0.1, 0) * Transform::scaling(-0.9, 0.8, 1.1)});
  result.geometry = std::make_shared<const Geometry>(std::move(shapes), scene.geometry->acceptance(),
                                                     std::move(instancing));
  return result;
}

}  // namespace twinray::test
