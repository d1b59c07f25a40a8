// SPDX-License-Identifier: Apache-2.0
#include "accel/accelerator.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "accel/backends.h"
#include "core/checked_ray.h"
#include "core/error.h"

namespace twinray {
namespace {

/// Gives a hit's t the caller's units.
void scale_back(Hit& hit, const CheckedRay& ray) {
  if (ray.t_scale != 1) hit.t = float(hit.t * ray.t_scale);
}

/// The next rays of a batch that are valid, and where their answers go.
class LoadedRays {
 public:
  static constexpr std::size_t most = 128;

  /// Loads some more; false where there are none.
  bool load(std::span<const Ray> all) {
    begin_ = end_;
    count_ = 0;
    for (; end_ < all.size() && count_ < most; ++end_) {
      places_[count_] = end_;
      count_ += load_ray(all[end_], rays_[count_]);
    }
    return end_ > begin_;
  }
  std::span<const CheckedRay> rays() const { return {rays_, count_}; }
  /// Invalid rays get the answer of a miss.
  template <typename Answer>
  void deal_out(const Answer* answers, std::span<Answer> all) const {
    std::fill(all.begin() + std::ptrdiff_t(begin_), all.begin() + std::ptrdiff_t(end_), Answer());
    for (std::size_t i = 0; i < count_; ++i) all[places_[i]] = answers[i];
  }

 private:
  CheckedRay rays_[most];
  std::size_t places_[most];
  std::size_t begin_ = 0, end_ = 0, count_ = 0;
};

constexpr std::array<std::pair<Backend, const char*>, 4> backend_names{
    {{Backend::bvh, "bvh"},
     {Backend::embree, "embree"},
     {Backend::embree_native, "embree-native"},
     {Backend::brute_force, "brute-force"}}};

constexpr std::array<std::pair<BvhBuilder, const char*>, 4> builder_names{
    {{BvhBuilder::own, "own"},
     {BvhBuilder::embree_low, "embree-low"},
     {BvhBuilder::embree_medium, "embree-medium"},
     {BvhBuilder::embree_high, "embree-high"}}};

void check_range(const char* name, double value, double least, double most) {
  if (!(value >= least && value <= most))
    throw Error(fmt::format("{} is {}; it must lie in [{}, {}]", name, value, least, most));
}

void check_options(const BuildOptions& options) {
  check_range("the number of threads", options.threads, 0, 65536);
  if (options.bvh_width != 2 && options.bvh_width != 8)
    throw Error(fmt::format("the width of the BVH is {}; it must be 2 or 8", options.bvh_width));
  check_range("the number of BVH bins", options.bvh_bins, 2, 256);
  check_range("the maximum leaf size", options.max_leaf_size, 1, 255);
  check_range("the leaf block", options.leaf_block, 1, 255);
  check_range("the traversal cost", options.traversal_cost, 1e-6, 1e6);
  check_range("the intersection cost", options.intersection_cost, 1e-6, 1e6);
}

}  // namespace

Hit Accelerator::closest_hit(const Ray& ray) const noexcept {
  CheckedRay checked;
  return load_ray(ray, checked) ? closest_of(checked) : Hit();
}

// One variable that every path returns: the hit is written where it goes, for copying what was just written
// in parts stalls.
Hit Accelerator::closest_of(const CheckedRay& ray) const noexcept {
  Hit hit = trace_closest(ray);
  scale_back(hit, ray);
  return hit;
}

bool Accelerator::any_hit(const Ray& ray) const noexcept {
  CheckedRay checked;
  return load_ray(ray, checked) && trace_any(checked);
}

Hit Accelerator::closest_hit(const Ray& ray, QueryCounts& counts) const noexcept {
  CheckedRay checked;
  if (!load_ray(ray, checked)) return {};
  Hit hit = count_closest(checked, counts);
  scale_back(hit, checked);
  return hit;
}

bool Accelerator::any_hit(const Ray& ray, QueryCounts& counts) const noexcept {
  CheckedRay checked;
  return load_ray(ray, checked) && count_any(checked, counts);
}

void Accelerator::trace_closest_batch(std::span<const CheckedRay> rays, Hit* hits) const noexcept {
  for (const CheckedRay& ray : rays) *hits++ = trace_closest(ray);
}

void Accelerator::trace_any_batch(std::span<const CheckedRay> rays, std::uint8_t* hits) const noexcept {
  for (const CheckedRay& ray : rays) *hits++ = trace_any(ray);
}

void Accelerator::closest_hits(std::span<const Ray> rays, std::span<Hit> answers) const noexcept {
  LoadedRays loaded;
  while (loaded.load(rays)) {
    Hit hits[LoadedRays::most];
    trace_closest_batch(loaded.rays(), hits);
    for (std::size_t i = 0; i < loaded.rays().size(); ++i) scale_back(hits[i], loaded.rays()[i]);
    loaded.deal_out(hits, answers);
  }
}

void Accelerator::any_hits(std::span<const Ray> rays, std::span<std::uint8_t> answers) const noexcept {
  LoadedRays loaded;
  while (loaded.load(rays)) {
    std::uint8_t hits[LoadedRays::most] = {};
    trace_any_batch(loaded.rays(), hits);
    loaded.deal_out(hits, answers);
  }
}

std::unique_ptr<Accelerator> build_accelerator(Backend backend, std::shared_ptr<const Geometry> geometry,
                                               const BuildOptions& options) {
  check_options(options);
  switch (backend) {
    case Backend::bvh:
      return options.bvh_width == 8 ? build_wide_bvh(std::move(geometry), options)
                                    : build_bvh(std::move(geometry), options);
    case Backend::brute_force:
      return build_brute_force(std::move(geometry), options);
#ifdef TWINRAY_WITH_EMBREE
    case Backend::embree:
      return build_embree(std::move(geometry), options);
    case Backend::embree_native:
      return build_embree_native(std::move(geometry), options);
#else
    default:
      break;
#endif
  }
  throw Error(fmt::format("the engine {} is not part of this build", backend_name(backend)));
}

std::vector<Backend> available_backends() {
#ifdef TWINRAY_WITH_EMBREE
  return {Backend::embree, Backend::bvh, Backend::embree_native, Backend::brute_force};
#else
  return {Backend::bvh, Backend::brute_force};
#endif
}

Backend default_backend() { return available_backends().front(); }

std::string backend_name(Backend backend) {
  for (const auto& [value, name] : backend_names)
    if (value == backend) return name;
  return "unknown";
}

std::vector<BvhBuilder> available_builders() {
#ifdef TWINRAY_WITH_EMBREE
  return {BvhBuilder::own, BvhBuilder::embree_low, BvhBuilder::embree_medium, BvhBuilder::embree_high};
#else
  return {BvhBuilder::own};
#endif
}

std::string builder_name(BvhBuilder builder) {
  for (const auto& [value, name] : builder_names)
    if (value == builder) return name;
  return "unknown";
}

}  // namespace twinray
