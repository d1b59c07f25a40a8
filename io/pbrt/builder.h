// SPDX-License-Identifier: Apache-2.0
// Gathers the shapes, lights and materials of a scene that is read from pbrt's format.
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/loaded_scene.h"
#include "io/pbrt/camera.h"
#include "io/pbrt/material.h"
#include "io/pbrt/medium.h"
#include "io/pbrt/shape.h"
#include "io/pbrt/state.h"

namespace twinray {

class PbrtBuilder {
 public:
  explicit PbrtBuilder(PbrtContext& context) : context_(context), materials_(context), media_(context) {}

  PbrtMaterials& materials() { return materials_; }
  PbrtMedia& media() { return media_; }
  /// Where the camera stands, and in what if no shape is around it.
  void place_camera(const Vec3& position, PbrtMediumPointer medium) {
    camera_ = position;
    around_camera_ = std::move(medium);
  }

  void add_shape(const std::string& type, const PbrtParameters& parameters, const PbrtState& state);
  void add_light(const std::string& type, const PbrtParameters& parameters, const PbrtState& state);

  /// Shapes up to end_object() are parts of an object that instances show; the scene does not.
  void begin_object(const std::string& name, const PbrtPlace& place);
  void end_object();
  /// Shows an object's shapes. Throws Error where there is none of this name.
  void add_instance(const std::string& name, const Transform& to_world, const PbrtPlace& place);

  /// The scene, but for its camera, with all light times the exposure. Throws Error where a name was used
  /// that nothing was given.
  LoadedScene finish(float exposure);

  static constexpr std::size_t max_triangles = std::size_t(1) << 28;

 private:
  /// A shape with what it is made of.
  struct Part {
    std::shared_ptr<const PbrtShape> shape;
    Transform to_world;
    bool is_reversed;
    std::uint32_t material;
    bool is_filled;                     ///< Its inside or outside is another medium than what lies around.
    PbrtMediumPointer within, without;  ///< Of one that is filled.
    std::shared_ptr<const PbrtAreaLight> light;
    std::uint32_t alpha;
    PbrtPlace place;
    std::uint32_t asset;  ///< The object that it belongs to, if any.
  };
  struct ShownAt {
    Transform to_world;
    PbrtPlace place;
  };
  /// What instances show, and where.
  struct Object {
    std::vector<Part> parts;
    std::vector<ShownAt> shown;
  };
  /// What a shape is filled with.
  struct Filling {
    PbrtMediumPointer medium, outside;
    PbrtPlace place;  ///< Of the shape.
  };
  /// Shapes in their places, what they wear, and what is within them.
  struct Placed {
    std::vector<Shape> shapes;
    std::vector<ShapeBinding> bindings;
    std::map<std::size_t, Filling> fillings;  ///< Of those shapes that have any.
  };

  void place(const Part& part, const Transform& to_world, Placed& placed);
  /// Makes instances or copies of all objects; puts the shapes of the former behind all others.
  Instancing place_objects();
  void place_object(const Object& object, Placed& shared, Instancing& instancing);
  /// Whether there are so many copies of an object that what does not emit is better stored once.
  bool is_shared(const Object& object) const;

  bool emits(const Part& part) const;
  Rgb glow_of(std::uint32_t material) const;
  bool is_textured(std::uint32_t material) const;
  /// Whether the shape's texture coordinates matter.
  bool needs_uvs(const Part& part) const;
  /// The shape; where textures need coordinates and it has none, with those that pbrt gives each triangle.
  std::shared_ptr<const PbrtShape> with_uvs(const Part& part) const;
  void add_emission(const Part& part, ShapeBinding& binding);
  void check_room(const Part& part);
  /// Whether light passes the shape: such a one stands behind all others, so that where two surfaces lie in
  /// one place it hides none that is there.
  bool is_passed(const Part& part) const;
  /// A light of a mesh, or of a sphere in its place, as an index into shape_lights_.
  std::uint32_t add_shape_light(const std::string& name, const MeshLight& light);
  /// Gives shapes with something in them materials of their own.
  void fill_interiors();
  /// A material with that in it in place of its own; a clear filling leaves its own.
  std::uint32_t add_filled(std::uint32_t material, const Interior& filling);
  /// What fills the space around all shapes, as a material; no_material where nothing does.
  std::uint32_t add_atmosphere(std::size_t direct_shapes);
  /// Makes lights of shapes whose materials emit by themselves.
  void add_glow();

  PbrtContext& context_;
  PbrtMaterials materials_;
  PbrtMedia media_;
  Vec3 camera_;
  PbrtMediumPointer around_camera_;
  Placed placed_;             ///< All that stands in the scene directly and, at the end, what instances show.
  std::vector<Part> passed_;  ///< Those that stand in it last.
  std::vector<Light> shape_lights_, lights_;
  std::map<std::string, Object> objects_;
  Object* object_ = nullptr;         ///< The one that shapes belong to: the last of the assets.
  std::vector<std::string> assets_;  ///< Names of the objects in their order.
  PlacedShapes account_;
  std::size_t triangles_ = 0;
};

}  // namespace twinray
