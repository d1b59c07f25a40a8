// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "io/collada/document.h"
#include "io/collada/texture.h"
#include "io/loaded_scene.h"

namespace twinray {

/// How the files are read that a document refers to.
struct ColladaFiles {
  DocumentOpener document = XmlDocument::load;
  PictureReader picture = load_texture;
};

/// Reads a COLLADA document (Khronos, "COLLADA - Digital Asset Schema", releases 1.4.1 and 1.5.0, 2008) with
/// CS184's extensions, which stand in <technique profile="CGL"> (or CMU462): area lights, spheres, materials.
/// `files` reads the further documents that it refers to, and pictures.
///
/// The scene has Y up; lengths stay in the file's unit. Each primitive element of each instanced geometry
/// becomes one mesh in world space. Throws Error, with the place, for what is malformed or missing.
LoadedScene read_collada(const XmlDocument& document, const LoadOptions& options,
                         const ColladaFiles& files = {});

}  // namespace twinray
