// SPDX-License-Identifier: Apache-2.0
// The one interface to all ray engines. Whatever the backend, an answer is the canonical one (see the files
// accel/canonical/triangle.h, sphere.h and slab.h): the least (t, instance, mesh, primitive) of all accepted
// hits. Only embree_native, Embree with its own triangles, stands outside of that promise.
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "accel/build_options.h"
#include "accel/counters.h"
#include "core/aabb.h"
#include "core/geometry.h"
#include "core/hit.h"
#include "core/ray.h"

namespace twinray {

enum class Backend { bvh, embree, embree_native, brute_force };

struct BuildPhase {
  std::string name;
  double seconds = 0;
};

/// What a build made. Numbers that a backend cannot know are 0.
struct AccelStats {
  std::vector<BuildPhase> phases;  ///< In the order in which they ran; wall-clock time.
  std::size_t primitives = 0;
  std::size_t bytes = 0;  ///< Memory of the finished accelerator, without the geometry itself.
  std::size_t nodes = 0;  ///< Inner nodes and leaves.
  std::size_t leaves = 0;
  int depth = 0;        ///< Edges from the root to the deepest leaf.
  double sah_cost = 0;  ///< Expected cost of a random ray, by the build options' costs.

  double build_seconds() const {
    double sum = 0;
    for (const BuildPhase& phase : phases) sum += phase.seconds;
    return sum;
  }
};

/// A ray query structure over one geometry; immutable, and safe to ask from any number of threads.
/// No query allocates or throws. An invalid ray (core/ray.h) is a miss.
class Accelerator {
 public:
  virtual ~Accelerator() = default;
  Accelerator(const Accelerator&) = delete;
  Accelerator& operator=(const Accelerator&) = delete;

  /// The least accepted hit of the closed interval [t_min, t_max], or a miss.
  Hit closest_hit(const Ray& ray) const noexcept { return find_closest(ray); }
  /// Whether closest_hit would find one.
  bool any_hit(const Ray& ray) const noexcept { return find_any(ray); }

  /// The same answers, and what it took to find them, added to `counts`: counts of a scalar traversal, equal
  /// on every machine.
  Hit closest_hit(const Ray& ray, QueryCounts& counts) const noexcept { return find_closest(ray, counts); }
  bool any_hit(const Ray& ray, QueryCounts& counts) const noexcept { return find_any(ray, counts); }

  /// Batches: answers[i] is that of rays[i], with the same bits as one by one; the eight-wide BVH traces
  /// many rays at a time, which pays for all but small scenes. Both spans have the same length.
  void closest_hits(std::span<const Ray> rays, std::span<Hit> answers) const noexcept {
    find_closest_batch(rays, answers.data());
  }
  void any_hits(std::span<const Ray> rays, std::span<std::uint8_t> answers) const noexcept {
    find_any_batch(rays, answers.data());
  }

  /// Whether batches are faster than single rays: a guess by the size of the scene; false where a batch is
  /// traced one by one.
  virtual bool prefers_batches() const noexcept { return false; }

  /// The box of the geometry.
  virtual Aabb bounds() const noexcept = 0;
  virtual AccelStats stats() const = 0;

 protected:
  Accelerator() = default;

 private:
  // What an engine answers; a batch, one by one unless it knows better. Most derive from CheckedAccelerator.
  virtual Hit find_closest(const Ray& ray) const noexcept = 0;
  virtual bool find_any(const Ray& ray) const noexcept = 0;
  virtual Hit find_closest(const Ray& ray, QueryCounts& counts) const noexcept = 0;
  virtual bool find_any(const Ray& ray, QueryCounts& counts) const noexcept = 0;
  virtual void find_closest_batch(std::span<const Ray> rays, Hit* hits) const noexcept;
  virtual void find_any_batch(std::span<const Ray> rays, std::uint8_t* hits) const noexcept;
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

/// The names that BuildOptions::simd may have on this machine: "best", then from the fastest on "avx512",
/// "avx2" and "sse4" where it has them, and "scalar".
std::vector<std::string> available_instruction_sets();

/// The builders of BVHs of this build, our own first.
std::vector<BvhBuilder> available_builders();
/// "own", "embree-low", "embree-medium", "embree-high".
std::string builder_name(BvhBuilder builder);

}  // namespace twinray
