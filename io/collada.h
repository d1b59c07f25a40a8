// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "io/load_options.h"
#include "io/loaded_scene.h"
#include "io/xml_reader.h"

namespace twinray {

/// Reads a COLLADA 1.4 document (Khronos, "COLLADA - Digital Asset Schema Release 1.4.1", 2008) with CS184's
/// extensions, which stand in <technique profile="CGL"> (or CMU462): area lights, spheres, materials.
///
/// The scene has Y up; lengths stay in the file's unit. Each primitive element of each instanced geometry
/// becomes one mesh in world space. Throws Error, with the place, for what is malformed or missing.
LoadedScene read_collada(const XmlDocument& document, const LoadOptions& options);

}  // namespace twinray
