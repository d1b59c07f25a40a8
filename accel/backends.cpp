// SPDX-License-Identifier: Apache-2.0
#include "accel/backends.h"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "core/error.h"

namespace twinray {
namespace {

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

std::unique_ptr<Accelerator> build_accelerator(Backend backend, std::shared_ptr<const Geometry> geometry,
                                               const BuildOptions& options) {
  check_options(options);
  switch (backend) {
    case Backend::bvh:
      if (options.triangle_test == TriangleTest::moller_trumbore)
        return build_moller_trumbore(std::move(geometry), options);
      if (options.bvh_width == 2) return build_bvh(std::move(geometry), options);
      return options.memory_mode == MemoryMode::compact ? build_compact_bvh(std::move(geometry), options)
                                                        : build_wide_bvh(std::move(geometry), options);
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
