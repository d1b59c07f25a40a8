// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "core/scene.h"

namespace twinray::generated {

/// Gathers shapes, materials and lights, and makes a scene of them.
class SceneMaker {
 public:
  /// A mesh with a Lambert material.
  void add(Mesh mesh, const Rgb& reflectance);
  void add(Mesh mesh, const SurfaceModel& model);
  /// A black mesh that emits from its front.
  void add_lamp(Mesh mesh, const Rgb& radiance);
  void add_light(const std::string& name, LightSource source);

  /// Meshes that are added from now on are shown by instances alone, as those of a prototype, whose number
  /// this is.
  std::uint32_t begin_prototype();
  void add_instance(std::uint32_t prototype, const Transform& to_world);

  std::size_t triangles() const { return triangles_; }
  /// Ends the making. Throws Error for shapes that are not valid.
  Scene finish(const Camera& camera);

 private:
  Scene scene_;
  std::vector<Shape> shapes_;
  Instancing instancing_;
  std::size_t triangles_ = 0;
};

/// Where a camera stands and what it looks at.
struct View {
  Vec3 eye, target;
  float tan_half_width = 0.6f;
};
/// A camera of 4 : 3 with +y up; it must not look straight up or down.
Camera camera_of(const View& view);

/// Throws Error unless the number of instances lies in [1, 2^28].
void check_count(const std::string& scene, std::size_t instances);

/// Throws Error unless the number of triangles lies in [least, 2^28].
void check_size(const std::string& scene, std::size_t triangles, std::size_t least);

}  // namespace twinray::generated
