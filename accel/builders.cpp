// SPDX-License-Identifier: Apache-2.0
#include "accel/builders.h"

#include <fmt/format.h>

#include <utility>

#include "accel/accelerator.h"
#ifdef TWINRAY_WITH_EMBREE
#include "accel/embree/builder.h"
#endif
#include "core/error.h"

namespace twinray {

BuildTree build_by(BuildPrimitives primitives, const BuildOptions& options) {
  if (options.bvh_builder == BvhBuilder::own) return build_tree(std::move(primitives), options);
#ifdef TWINRAY_WITH_EMBREE
  return build_tree_by_embree(std::move(primitives), options);
#else
  throw Error(fmt::format("the builder {} is not part of this build", builder_name(options.bvh_builder)));
#endif
}

}  // namespace twinray
