// SPDX-License-Identifier: Apache-2.0
// The one door to NanoVDB.
#pragma once
#include <memory>
#include <string_view>

#include "core/density_grid.h"
#include "core/transform.h"
#include "io/nanovdb/file.h"

namespace twinray {

struct NvdbGrid {
  std::shared_ptr<const DensityGrid> densities;
  std::size_t negative = 0;  ///< So many of its values are below 0; 0 stands for them.
};

/// A grid of a file, whose space `to_world` takes to the scene's: values of 32 bits, or of those that stand
/// for them in fewer. As in pbrt-v4 they are those of points with whole coordinates. Throws Error where there
/// is no such grid, where it is of another type or a level set, does not fit into memory or has values that
/// are not finite.
NvdbGrid read_nvdb_grid(const NvdbFile& file, std::string_view name, const Transform& to_world);

}  // namespace twinray
