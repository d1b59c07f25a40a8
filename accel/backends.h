// SPDX-License-Identifier: Apache-2.0
// Private: one build function for each backend.
#pragma once
#include <memory>

#include "accel/accelerator.h"

namespace twinray {

std::unique_ptr<Accelerator> build_brute_force(std::shared_ptr<const Geometry>, const BuildOptions&);
std::unique_ptr<Accelerator> build_bvh(std::shared_ptr<const Geometry>, const BuildOptions&);
std::unique_ptr<Accelerator> build_moller_trumbore(std::shared_ptr<const Geometry>, const BuildOptions&);
std::unique_ptr<Accelerator> build_wide_bvh(std::shared_ptr<const Geometry>, const BuildOptions&);
std::unique_ptr<Accelerator> build_compact_bvh(std::shared_ptr<const Geometry>, const BuildOptions&);
std::unique_ptr<Accelerator> build_embree(std::shared_ptr<const Geometry>, const BuildOptions&);
std::unique_ptr<Accelerator> build_embree_native(std::shared_ptr<const Geometry>, const BuildOptions&);

}  // namespace twinray
