// SPDX-License-Identifier: Apache-2.0
// Embree with its own triangles: an independent witness of the canonical engines, outside of their promise.
// The ends of a ray's interval are Embree's own.
#include <array>
#include <cstring>

#include "accel/backends.h"
#include "accel/build/phase_timer.h"
#include "accel/canonical/instance_ray.h"
#include "accel/canonical/shape_test.h"
#include "accel/embree/bounds.h"
#include "accel/embree/device.h"
#include "accel/embree/native.h"
#include "accel/embree/ray.h"
#include "core/error.h"

namespace twinray {
namespace {

struct NativeQuery : embree::Context {
  const CheckedRay& ray;
  const Geometry& geometry;

  /// The ray as our callbacks want it: in the space of the instance that Embree is in, if it is in one.
  /// Embree's own ray there is rounded otherwise.
  CheckedRay own_ray() const {
    CheckedRay own = ray;
    if (instID[0] == RTC_INVALID_GEOMETRY_ID) return own;
    const std::uint32_t instance = instID[0] - geometry.direct_shapes().count;
    Ray moved{.origin = {}, .direction = {}, .t_min = ray.t_min, .t_max = ray.t_max};
    move_into(geometry.placed()[instance], ray, moved);
    load_ray(moved, own);
    own.instance = instance;
    return own;
  }
};

/// What the callbacks of one shape know.
struct NativeShape {
  const Geometry& geometry;
  std::uint32_t index;
  float size;  ///< As embree::widened() takes it.

  const Sphere& sphere(unsigned i) const { return geometry.sphere_set(index)->spheres[i]; }
};

void bound_sphere(const RTCBoundsFunctionArguments* arguments) {
  const auto& shape = *static_cast<const NativeShape*>(arguments->geometryUserPtr);
  *arguments->bounds_o = embree::widened(sphere_bounds(shape.sphere(arguments->primID)), shape.size);
}

/// The hit of a sphere for a callback's arguments.
template <typename Arguments>
bool find_sphere(const Arguments& arguments, float t_max, ShapeHit& found) {
  const auto& shape = *static_cast<const NativeShape*>(arguments.geometryUserPtr);
  const CheckedRay ray = static_cast<const NativeQuery*>(arguments.context)->own_ray();
  return intersect_primitive(shape.geometry, ray, {shape.index, arguments.primID}, t_max, found);
}

void intersect_sphere(const RTCIntersectFunctionNArguments* arguments) {
  auto& [embree_ray, hit] = *reinterpret_cast<RTCRayHit*>(arguments->rayhit);
  ShapeHit found;
  if (!find_sphere(*arguments, embree_ray.tfar, found)) return;
  embree_ray.tfar = found.t;
  hit.u = found.u;
  hit.v = found.v;
  hit.primID = arguments->primID;
  hit.geomID = arguments->geomID;
  hit.instID[0] = arguments->context->instID[0];
}

void occlude_sphere(const RTCOccludedFunctionNArguments* arguments) {
  auto& embree_ray = *reinterpret_cast<RTCRay*>(arguments->ray);
  ShapeHit found;
  if (find_sphere(*arguments, embree_ray.tfar, found)) embree_ray.tfar = -Aabb::infinity;
}

/// Of single rays: whether Embree's hit of a triangle counts.
void filter(const RTCFilterFunctionNArguments* arguments) {
  const auto& shape = *static_cast<const NativeShape*>(arguments->geometryUserPtr);
  const CheckedRay ray = static_cast<const NativeQuery*>(arguments->context)->own_ray();
  const float t = reinterpret_cast<const RTCRay*>(arguments->ray)->tfar;
  const auto& hit = *reinterpret_cast<const RTCHit*>(arguments->hit);
  if (!accepts(shape.geometry, ray, {shape.index, hit.primID}, {t, hit.u, hit.v})) arguments->valid[0] = 0;
}

/// `shape`, a mesh, must outlive the geometry.
embree::GeometryOwner make_triangles(RTCDevice device, NativeShape& shape) {
  const Mesh& mesh = *shape.geometry.mesh(shape.index);
  embree::GeometryOwner geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE));
  // One vertex more than there are: Embree reads 16 bytes for each.
  void* const vertices = rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                 sizeof(Vec3), mesh.positions.size() + 1);
  void* const indices = rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                sizeof(Triangle), mesh.triangles.size());
  if (!vertices || !indices) return geometry;  // The device knows the error.
  std::memcpy(vertices, mesh.positions.data(), mesh.positions.size() * sizeof(Vec3));
  std::memset(static_cast<char*>(vertices) + mesh.positions.size() * sizeof(Vec3), 0, sizeof(Vec3));
  std::memcpy(indices, mesh.triangles.data(), mesh.triangles.size() * sizeof(Triangle));
  if (mesh.is_opaque) return geometry;
  rtcSetGeometryUserData(geometry.get(), &shape);
  rtcSetGeometryIntersectFilterFunction(geometry.get(), filter);
  rtcSetGeometryOccludedFilterFunction(geometry.get(), filter);
  return geometry;
}

/// `shape` must outlive the geometry.
embree::GeometryOwner make_spheres(RTCDevice device, NativeShape& shape) {
  embree::GeometryOwner geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER));
  rtcSetGeometryUserPrimitiveCount(geometry.get(),
                                   unsigned(shape.geometry.sphere_set(shape.index)->spheres.size()));
  rtcSetGeometryUserData(geometry.get(), &shape);
  rtcSetGeometryBoundsFunction(geometry.get(), bound_sphere, nullptr);
  rtcSetGeometryIntersectFunction(geometry.get(), intersect_sphere);
  rtcSetGeometryOccludedFunction(geometry.get(), occlude_sphere);
  return geometry;
}

/// The box of the spheres of some shapes.
Aabb spheres_box(const Geometry& geometry, ShapeRange shapes) {
  Aabb box;
  for (std::uint32_t i = shapes.first; i < shapes.end(); ++i)
    if (const SphereSet* set = geometry.sphere_set(i))
      for (const Sphere& sphere : set->spheres) box.extend(sphere_bounds(sphere));
  return box;
}

/// A transform as Embree takes it: four columns of three.
std::array<float, 12> columns_of(const Transform& transform) {
  std::array<float, 12> columns;
  for (std::size_t column = 0; column < 4; ++column)
    for (std::size_t row = 0; row < 3; ++row) columns[3 * column + row] = float(transform.m[row][column]);
  return columns;
}

/// Embree's tree over all shapes and instances, whose numbers named() knows, and those over the prototypes.
struct NativeWorld {
  std::vector<NativeShape> shapes;  ///< Never grown, for their addresses are user data.
  embree::Device device;
  embree::Scene scene;
  std::vector<embree::Scene> prototypes;
  bool has_callbacks = false;

  explicit NativeWorld(const BuildOptions& options) : device(embree::configuration(options)) {}

  void build(const Geometry& geometry, const BuildOptions& options) {
    shapes.reserve(geometry.shapes().size());
    scene = new_scene(options);
    add_shapes(geometry, geometry.direct_shapes(), embree::scene_size(geometry), scene.get());
    for (const ShapeRange& prototype : geometry.prototypes()) {
      prototypes.push_back(new_scene(options));
      add_shapes(geometry, prototype, embree::prototype_size(spheres_box(geometry, prototype)),
                 prototypes.back().get());
      embree::commit(device, prototypes.back().get(), options.threads);
    }
    add_instances(geometry);
    embree::commit(device, scene.get(), options.threads);
  }

 private:
  embree::Scene new_scene(const BuildOptions& options) {
    embree::Scene made(rtcNewScene(device.get()));
    if (options.embree_mode == EmbreeMode::robust) rtcSetSceneFlags(made.get(), RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(made.get(), options.embree_quality == EmbreeQuality::high
                                            ? RTC_BUILD_QUALITY_HIGH
                                            : RTC_BUILD_QUALITY_MEDIUM);
    return made;
  }
  void add_shapes(const Geometry& geometry, ShapeRange range, float size, RTCScene to) {
    for (std::uint32_t i = range.first; i < range.end(); ++i) {
      shapes.push_back({geometry, i, size});
      const bool is_mesh = geometry.mesh(i) != nullptr;
      has_callbacks = has_callbacks || !is_mesh || !geometry.is_opaque(i);
      embree::attach(to, (is_mesh ? make_triangles : make_spheres)(device.get(), shapes.back()),
                     i - range.first);
    }
  }
  void add_instances(const Geometry& geometry) {
    const std::vector<Instance>& instances = geometry.instances();
    for (std::uint32_t i = 0; i < instances.size(); ++i) {
      embree::GeometryOwner instance(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_INSTANCE));
      rtcSetGeometryInstancedScene(instance.get(), prototypes[instances[i].prototype].get());
      rtcSetGeometryTransform(instance.get(), 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR,
                              columns_of(instances[i].to_world).data());
      embree::attach(scene.get(), std::move(instance), geometry.direct_shapes().count + i);
    }
  }
};

class EmbreeNative final : public Accelerator {
 public:
  EmbreeNative(std::shared_ptr<const Geometry> geometry, NativeWorld world, AccelStats stats)
      : Accelerator(std::move(geometry), std::move(stats)), world_(std::move(world)) {}

  embree::NativeScene scene() const { return {world_.scene.get(), world_.has_callbacks}; }

 private:
  // What Embree's own leaves do cannot be counted.
  Hit closest(Query query) const noexcept override {
    return closest_of(geometry(), query.ray, [&](const CheckedRay& ray) -> Hit {
      NativeQuery native{{}, ray, geometry()};
      embree::initialize(native);
      RTCRayHit found;
      embree::set_ray(found.ray, ray.origin, ray.direction, ray.t_min, ray.t_max);
      embree::set_no_hit(found.hit);
      embree::trace(world_.scene.get(), native, found);
      if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
      return embree::named(
          {found.ray.tfar, found.hit.u, found.hit.v, found.hit.primID, found.hit.geomID, found.hit.instID[0]},
          geometry());
    });
  }

  bool any(Query query) const noexcept override {
    return any_of(geometry(), query.ray, [&](const CheckedRay& ray) {
      NativeQuery native{{}, ray, geometry()};
      embree::initialize(native);
      RTCRay occlusion_ray;
      embree::set_ray(occlusion_ray, ray.origin, ray.direction, ray.t_min, ray.t_max);
      embree::trace(world_.scene.get(), native, occlusion_ray);
      return occlusion_ray.tfar < 0;
    });
  }

  NativeWorld world_;
};

}  // namespace

std::unique_ptr<Accelerator> build_embree_native(std::shared_ptr<const Geometry> geometry,
                                                 const BuildOptions& options) {
  AccelStats stats;
  NativeWorld world(options);
  timed("embree", stats.phases, [&] { world.build(*geometry, options); });
  stats.bytes = world.device.bytes();
  return std::make_unique<EmbreeNative>(std::move(geometry), std::move(world), std::move(stats));
}

embree::NativeScene embree::native_scene(const Accelerator& accelerator) {
  const auto* const native = dynamic_cast<const EmbreeNative*>(&accelerator);
  if (!native) throw Error("only the engine embree-native can be asked without its interface");
  return native->scene();
}

}  // namespace twinray
