// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "core/scene.h"
#include "io/losses.h"

namespace twinray {

/// What fills bodies and the space around them, as statements of pbrt's format. There each shape says what is
/// inside and outside of it, and the camera what it is in; here that follows from which bodies are within
/// which.
class PbrtMediaWriter {
 public:
  /// `names`: of the scene's materials; empty of one that no shape has. The scene must outlive it. Tells of
  /// what is lost.
  PbrtMediaWriter(const Scene& scene, const std::vector<std::string>& names, Losses& losses);

  /// Statements before the camera: what that is in.
  const std::string& view() const { return view_; }
  /// Those behind WorldBegin.
  const std::string& world() const { return world_; }
  /// That before a shape; mostly empty.
  std::string interface_of(std::uint32_t shape) const;

 private:
  /// A shape that has something inside, or nothing where there is something around.
  struct Body {
    std::uint32_t shape;
    Aabb box;
    std::string medium;  ///< Empty: clear.
  };
  /// What is at a point, but for a shape that it lies on.
  const std::string& around(const Vec3& point, std::uint32_t shape) const;

  const Scene& scene_;
  std::vector<std::string> media_;  ///< The name of that within each material's shapes; mostly empty.
  std::vector<Body> bodies_;        ///< Of the scene's direct shapes, the smallest first.
  std::string atmosphere_, first_;  ///< What is around all, and the first one within a body; or empty.
  std::string view_, world_;
};

}  // namespace twinray
