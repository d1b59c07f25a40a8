// SPDX-License-Identifier: Apache-2.0
// The one interface to all ray engines. Whatever the backend, an answer is the canonical one (see the files
// accel/canonical/triangle.h, sphere.h and slab.h): the least (t, instance, mesh, primitive) of all accepted
// hits. Only embree_native, Embree with its own triangles, stands outside of that promise.
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "accel/build_options.h"
#include "accel/query.h"
#include "core/aabb.h"
#include "core/denormals.h"
#include "core/geometry.h"
#include "core/hit.h"
#include "core/instruction_sets.h"

namespace twinray {

enum class Backend { bvh, embree, embree_native, brute_force };

struct BuildPhase {
  std::string name;
  double seconds = 0;
};

/// The tree of an engine that shows it. Of an empty geometry all are 0.
struct TreeStats {
  std::size_t nodes = 0;  ///< Inner nodes and leaves.
  std::size_t leaves = 0;
  int depth = 0;        ///< Edges from the root to the deepest leaf.
  double sah_cost = 0;  ///< Expected cost of a random ray, by the build options' costs.
};

/// What a build made.
struct AccelStats {
  std::vector<BuildPhase> phases;  ///< In the order in which they ran; wall-clock time.
  std::size_t primitives = 0;
  std::size_t bytes = 0;          ///< Memory of the finished accelerator, without the geometry itself.
  std::optional<TreeStats> tree;  ///< None of brute force, nor of Embree's trees, which it keeps to itself.

  double build_seconds() const {
    double sum = 0;
    for (const BuildPhase& phase : phases) sum += phase.seconds;
    return sum;
  }
};

/// A ray query structure over one geometry; immutable, and safe to ask from any number of threads.
/// No query allocates or throws. An invalid ray (core/ray.h) is a miss. The answers do not depend on whether
/// the calling thread has denormal numbers switched off (FTZ, DAZ).
class Accelerator {
 public:
  virtual ~Accelerator() = default;
  Accelerator(const Accelerator&) = delete;
  Accelerator& operator=(const Accelerator&) = delete;

  /// The least accepted hit of the closed interval [t_min, t_max], or a miss.
  Hit closest_hit(Query query) const noexcept {
    return keeps_denormals() ? closest(query) : closest_with_denormals(query);
  }
  Hit closest_hit(const Ray& ray) const noexcept { return closest_hit(Query{ray}); }

  /// Whether closest_hit would find one.
  bool any_hit(Query query) const noexcept {
    return keeps_denormals() ? any(query) : any_with_denormals(query);
  }
  bool any_hit(const Ray& ray) const noexcept { return any_hit(Query{ray}); }

  /// Many at once: answers[i] is that of rays[i], with the same bits as one by one; the engine decides how
  /// many rays it traces at a time. Both spans have the same length: an assertion says so, and without
  /// assertions the lesser length counts.
  void closest_hits(std::span<const Ray> rays, std::span<Hit> answers) const noexcept;
  void any_hits(std::span<const Ray> rays, std::span<std::uint8_t> answers) const noexcept;

  const Geometry& geometry() const noexcept { return *geometry_; }
  /// The box of the geometry.
  const Aabb& bounds() const noexcept { return geometry_->bounds(); }
  const AccelStats& stats() const noexcept { return stats_; }

 protected:
  /// Fills in the number of primitives.
  explicit Accelerator(std::shared_ptr<const Geometry> geometry, AccelStats stats = {});

 private:
  // What an engine answers. Of a batch there are as many answers as rays; one by one unless it knows better.
  virtual Hit closest(Query query) const noexcept = 0;
  virtual bool any(Query query) const noexcept = 0;
  virtual void closest_batch(std::span<const Ray> rays, Hit* answers) const noexcept;
  virtual void any_batch(std::span<const Ray> rays, std::uint8_t* answers) const noexcept;

  // For callers whose thread has them switched off.
  Hit closest_with_denormals(Query query) const noexcept;
  bool any_with_denormals(Query query) const noexcept;

  std::shared_ptr<const Geometry> geometry_;
  AccelStats stats_;
};

/// Builds an accelerator over the geometry. Throws Error where options are out of range, where the backend
/// was not compiled in, or where Embree reports an error.
std::unique_ptr<Accelerator> build_accelerator(Backend backend, std::shared_ptr<const Geometry> geometry,
                                               const BuildOptions& options = {});

/// The backends of this build, in the order of their names in help texts.
std::vector<Backend> available_backends();
/// embree where it was compiled in, else bvh.
Backend default_backend();
/// "bvh", "embree", "embree-native", "brute-force".
std::string backend_name(Backend backend);

/// The builders of BVHs of this build, our own first.
std::vector<BvhBuilder> available_builders();
/// "own", "embree-low", "embree-medium", "embree-high".
std::string builder_name(BvhBuilder builder);

}  // namespace twinray
