// SPDX-License-Identifier: Apache-2.0
// Private: scenes of 3MF packages.
#pragma once
#include <string>

#include "io/load_options.h"
#include "io/loaded_scene.h"

namespace twinray {

/// Reads a 3MF package: what its <build> shows, with materials and colours, but without pictures. Its z axis,
/// which is up, becomes y. Throws Error, with the place, for a package that is damaged, that requires an
/// extension which is not read, or whose objects are not there or contain themselves.
LoadedScene load_three_mf(const std::string& path, const LoadOptions& options);

}  // namespace twinray
