// SPDX-License-Identifier: Apache-2.0
// Embree with its own triangles: an independent witness of the canonical engines, outside of their promise.
// The ends of a ray's interval are Embree's own.
#include <cstring>

#include "accel/backends.h"
#include "accel/build/phase_timer.h"
#include "accel/canonical/checked_ray.h"
#include "accel/canonical/sphere.h"
#include "accel/checked_accelerator.h"
#include "accel/embree/bounds.h"
#include "accel/embree/device.h"
#include "accel/embree/direct.h"
#include "accel/embree/ray.h"
#include "core/error.h"

namespace twinray {
namespace {

struct Query : embree::Context {
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
  const CheckedRay& ray = static_cast<const Query*>(arguments->context)->ray;
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
  const CheckedRay& ray = static_cast<const Query*>(arguments->context)->ray;
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

class EmbreeNative final : public CheckedAccelerator {
 public:
  EmbreeNative(std::shared_ptr<const Geometry> geometry, const BuildOptions& options)
      : geometry_(std::move(geometry)),
        device_(embree::configuration(options)),
        scene_(rtcNewScene(device_.get())) {
    timed("embree", stats_.phases, [&] {
      if (options.embree_mode == EmbreeMode::robust) rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
      rtcSetSceneBuildQuality(scene_.get(), options.embree_quality == EmbreeQuality::high
                                                ? RTC_BUILD_QUALITY_HIGH
                                                : RTC_BUILD_QUALITY_MEDIUM);
      add_shapes();
      embree::commit(device_, scene_.get(), options.threads);
    });
    stats_.primitives = geometry_->primitive_count();
    stats_.bytes = device_.bytes();
  }

  Aabb bounds() const noexcept override { return geometry_->bounds(); }
  AccelStats stats() const override { return stats_; }

  std::size_t closest_hits_directly(std::span<const Ray> rays) const {
    std::size_t hits = 0;
    if (!spheres_.empty()) {
      for (const Ray& ray : rays) hits += bool(closest_hit(ray));
      return hits;
    }
    embree::Context context;
    embree::initialize(context);
    for (const Ray& ray : rays) {
      RTCRayHit found =
          embree::without_hit(embree::make_ray(ray.origin, ray.direction, ray.t_min, ray.t_max));
      embree::intersect(scene_.get(), context, found);
      hits += found.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    }
    return hits;
  }

  std::size_t any_hits_directly(std::span<const Ray> rays) const {
    std::size_t hits = 0;
    if (!spheres_.empty()) {
      for (const Ray& ray : rays) hits += any_hit(ray);
      return hits;
    }
    embree::Context context;
    embree::initialize(context);
    for (const Ray& ray : rays) {
      RTCRay occlusion_ray = embree::make_ray(ray.origin, ray.direction, ray.t_min, ray.t_max);
      embree::occluded(scene_.get(), context, occlusion_ray);
      hits += occlusion_ray.tfar < 0;
    }
    return hits;
  }

 private:
  /// A shape's number in the scene is its index.
  void add_shapes() {
    const float scene_size = embree::scene_size(*geometry_);
    spheres_.reserve(geometry_->shapes().size());  // Their addresses are user data.
    for (std::uint32_t shape = 0; shape < geometry_->shapes().size(); ++shape) {
      if (const Mesh* mesh = geometry_->mesh(shape)) {
        embree::attach(scene_.get(), make_geometry(device_.get(), *mesh), shape);
      } else {
        spheres_.push_back({*geometry_->sphere_set(shape), scene_size});
        embree::attach(scene_.get(), make_geometry(device_.get(), spheres_.back()), shape);
      }
    }
  }

  Hit trace_closest(const CheckedRay& ray) const noexcept override {
    Query query{{}, ray};
    embree::initialize(query);
    RTCRayHit found = embree::without_hit(embree::make_ray(ray.origin, ray.direction, ray.t_min, ray.t_max));
    embree::intersect(scene_.get(), query, found);
    if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    return {found.ray.tfar, found.hit.u, found.hit.v, found.hit.primID, found.hit.geomID, no_instance};
  }

  bool trace_any(const CheckedRay& ray) const noexcept override {
    Query query{{}, ray};
    embree::initialize(query);
    RTCRay occlusion_ray = embree::make_ray(ray.origin, ray.direction, ray.t_min, ray.t_max);
    embree::occluded(scene_.get(), query, occlusion_ray);
    return occlusion_ray.tfar < 0;
  }

  // What Embree's own leaves do cannot be counted.
  Hit count_closest(const CheckedRay& ray, QueryCounts&) const noexcept override {
    return trace_closest(ray);
  }
  bool count_any(const CheckedRay& ray, QueryCounts&) const noexcept override { return trace_any(ray); }

  std::shared_ptr<const Geometry> geometry_;
  std::vector<SphereGeometry> spheres_;
  AccelStats stats_;
  embree::Device device_;
  embree::Scene scene_;
};

const EmbreeNative& as_native(const Accelerator& accelerator) {
  const auto* const native = dynamic_cast<const EmbreeNative*>(&accelerator);
  if (!native) throw Error("only the engine embree-native can be asked without its interface");
  return *native;
}

}  // namespace

std::unique_ptr<Accelerator> build_embree_native(std::shared_ptr<const Geometry> geometry,
                                                 const BuildOptions& options) {
  return std::make_unique<EmbreeNative>(std::move(geometry), options);
}

std::size_t embree::closest_hits_directly(const Accelerator& native, std::span<const Ray> rays) {
  return as_native(native).closest_hits_directly(rays);
}

std::size_t embree::any_hits_directly(const Accelerator& native, std::span<const Ray> rays) {
  return as_native(native).any_hits_directly(rays);
}

}  // namespace twinray
