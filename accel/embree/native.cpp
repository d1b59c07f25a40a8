// SPDX-License-Identifier: Apache-2.0
// Embree with its own triangles: an independent witness of the canonical engines, outside of their promise.
// The ends of a ray's interval are Embree's own.
#include <cstring>

#include "accel/backends.h"
#include "accel/build/phase_timer.h"
#include "accel/canonical/checked_ray.h"
#include "accel/canonical/sphere.h"
#include "accel/embree/bounds.h"
#include "accel/embree/device.h"
#include "accel/embree/native.h"
#include "accel/embree/ray.h"
#include "core/error.h"

namespace twinray {
namespace {

struct NativeQuery : embree::Context {
  const CheckedRay& ray;
};

/// What the callbacks of one sphere set know.
struct SphereGeometry {
  const SphereSet& set;
  float scene_size;
};

const Sphere& sphere(const void* user_data, unsigned index) {
  return static_cast<const SphereGeometry*>(user_data)->set.spheres[index];
}

void bound_sphere(const RTCBoundsFunctionArguments* arguments) {
  const auto& geometry = *static_cast<const SphereGeometry*>(arguments->geometryUserPtr);
  *arguments->bounds_o =
      embree::widened(sphere_bounds(geometry.set.spheres[arguments->primID]), geometry.scene_size);
}

void intersect_sphere(const RTCIntersectFunctionNArguments* arguments) {
  const CheckedRay& ray = static_cast<const NativeQuery*>(arguments->context)->ray;
  auto& [embree_ray, hit] = *reinterpret_cast<RTCRayHit*>(arguments->rayhit);
  ShapeHit found;
  if (!intersect_sphere(ray, sphere(arguments->geometryUserPtr, arguments->primID), embree_ray.tfar, found))
    return;
  embree_ray.tfar = found.t;
  hit.u = found.u;
  hit.v = found.v;
  hit.primID = arguments->primID;
  hit.geomID = arguments->geomID;
}

void occlude_sphere(const RTCOccludedFunctionNArguments* arguments) {
  const CheckedRay& ray = static_cast<const NativeQuery*>(arguments->context)->ray;
  auto& embree_ray = *reinterpret_cast<RTCRay*>(arguments->ray);
  ShapeHit found;
  if (intersect_sphere(ray, sphere(arguments->geometryUserPtr, arguments->primID), embree_ray.tfar, found))
    embree_ray.tfar = -Aabb::infinity;
}

embree::GeometryOwner make_geometry(RTCDevice device, const Mesh& mesh) {
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
  return geometry;
}

/// `spheres` must outlive the geometry.
embree::GeometryOwner make_geometry(RTCDevice device, SphereGeometry& spheres) {
  embree::GeometryOwner geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER));
  rtcSetGeometryUserPrimitiveCount(geometry.get(), unsigned(spheres.set.spheres.size()));
  rtcSetGeometryUserData(geometry.get(), &spheres);
  rtcSetGeometryBoundsFunction(geometry.get(), bound_sphere, nullptr);
  rtcSetGeometryIntersectFunction(geometry.get(), intersect_sphere);
  rtcSetGeometryOccludedFunction(geometry.get(), occlude_sphere);
  return geometry;
}

/// Embree's tree over all shapes; a shape's number in the scene is its index.
struct NativeWorld {
  std::vector<SphereGeometry> spheres;  ///< Never grown, for their addresses are user data.
  embree::Device device;
  embree::Scene scene;

  explicit NativeWorld(const BuildOptions& options)
      : device(embree::configuration(options)), scene(rtcNewScene(device.get())) {}

  void build(const Geometry& geometry, const BuildOptions& options) {
    if (options.embree_mode == EmbreeMode::robust) rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene.get(), options.embree_quality == EmbreeQuality::high
                                             ? RTC_BUILD_QUALITY_HIGH
                                             : RTC_BUILD_QUALITY_MEDIUM);
    add_shapes(geometry);
    embree::commit(device, scene.get(), options.threads);
  }

 private:
  void add_shapes(const Geometry& geometry) {
    const float scene_size = embree::scene_size(geometry);
    spheres.reserve(geometry.shapes().size());
    for (std::uint32_t shape = 0; shape < geometry.shapes().size(); ++shape) {
      if (const Mesh* mesh = geometry.mesh(shape)) {
        embree::attach(scene.get(), make_geometry(device.get(), *mesh), shape);
      } else {
        spheres.push_back({*geometry.sphere_set(shape), scene_size});
        embree::attach(scene.get(), make_geometry(device.get(), spheres.back()), shape);
      }
    }
  }
};

class EmbreeNative final : public Accelerator {
 public:
  EmbreeNative(std::shared_ptr<const Geometry> geometry, NativeWorld world, AccelStats stats)
      : Accelerator(std::move(geometry), std::move(stats)), world_(std::move(world)) {}

  embree::NativeScene scene() const { return {world_.scene.get(), !world_.spheres.empty()}; }

 private:
  // What Embree's own leaves do cannot be counted.
  Hit closest(Query query) const noexcept override {
    return closest_of(query.ray, [&](const CheckedRay& ray) -> Hit {
      NativeQuery native{{}, ray};
      embree::initialize(native);
      RTCRayHit found;
      embree::set_ray(found.ray, ray.origin, ray.direction, ray.t_min, ray.t_max);
      embree::set_no_hit(found.hit);
      embree::trace(world_.scene.get(), native, found);
      if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
      return {found.ray.tfar, found.hit.u, found.hit.v, found.hit.primID, found.hit.geomID, no_instance};
    });
  }

  bool any(Query query) const noexcept override {
    return any_of(query.ray, [&](const CheckedRay& ray) {
      NativeQuery native{{}, ray};
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
