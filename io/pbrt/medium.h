// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/density_grid.h"
#include "core/material.h"
#include "io/nanovdb/file.h"
#include "io/pbrt/context.h"
#include "io/pbrt/parameters.h"

namespace twinray {

/// What fills space between surfaces. A statement may name it before another one makes it.
struct PbrtMedium {
  std::optional<Interior> filling;  ///< Nothing until it is made.
  PbrtPlace first_use;
};
/// Null: nothing fills the space.
using PbrtMediumPointer = std::shared_ptr<const PbrtMedium>;

/// Whether it absorbs or scatters light, or may do so once it is made.
inline bool may_dim(const PbrtMediumPointer& medium) {
  return medium && !(medium->filling && is_black(medium->filling->extinction()));
}
/// Once all are made; what does neither is nothing.
inline Interior filling_of(const PbrtMediumPointer& medium) {
  const bool is_clear = !medium || is_black(medium->filling.value().extinction());
  return is_clear ? Interior{} : *medium->filling;
}

class PbrtMedia {
 public:
  explicit PbrtMedia(PbrtContext& context) : context_(context) {}

  /// MakeNamedMedium, in a space. Warns of what is not rendered.
  void define(const std::string& name, const PbrtParameters& parameters, const Transform& to_world);
  /// The medium of that name, which may be made later; null for the one without a name.
  PbrtMediumPointer named(const std::string& name, const PbrtPlace& place);
  /// Throws Error where a name was used that no statement gave.
  void check_all_made() const;

  std::vector<std::shared_ptr<const DensityGrid>> densities;  ///< Of those that are not even.

 private:
  /// The index of a grid; no_density of none.
  std::uint32_t add(const std::shared_ptr<const DensityGrid>& grid);
  Interior read_uniform_grid(const PbrtParameters& parameters, const Transform& to_world);
  Interior read_cloud(const PbrtParameters& parameters, const Transform& to_world);
  Interior read_nanovdb(const PbrtParameters& parameters, const Transform& to_world);
  /// A grid of a file.
  std::shared_ptr<const DensityGrid> read_nvdb(const PbrtParameters& parameters, const NvdbFile& file,
                                               const std::string& name, const Transform& to_world);

  PbrtContext& context_;
  std::map<std::string, std::shared_ptr<PbrtMedium>> media_;
};

}  // namespace twinray
