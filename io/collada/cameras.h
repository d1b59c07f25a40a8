// SPDX-License-Identifier: Apache-2.0
// A scene may have several cameras. One of them makes the picture, and only that one is read.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/scene.h"
#include "core/transform.h"
#include "io/collada/document.h"
#include "io/cs184/camera.h"

namespace twinray {

/// A camera where its node puts it.
struct ColladaCamera {
  XmlElement element, instance, node;
  Transform to_world;
  double unit = 1;  ///< That of its clip distances, in units of the scene.
};

/// That of the <camera>; where it has none, of the <node>; else "unnamed".
std::string camera_name(const ColladaCamera& camera);

/// The camera that LoadOptions::camera_name means, by name or id of the <camera> or of the <node>; without
/// such a name the one that the visual scene's <render camera_node> does, or the first one (by CS184's rules
/// the last one). Null where there is no camera. Throws Error, with the names that there are, for a name that
/// none has.
const ColladaCamera* choose_camera(const std::vector<ColladaCamera>& cameras, const XmlElement& visual_scene,
                                   ColladaDocument& document);

/// Throws Error as read_camera() does.
Camera place_camera(const ColladaCamera& camera, ColladaDocument& document);
/// What is to be said of clip distances that are not used: where they would have cut off some vertex.
std::optional<std::string> unused_clip_note(const ColladaCamera& camera, const Scene& scene,
                                            const ColladaDocument& document);
/// What CS184's program keeps of it. Throws Error as read_cs184_view() does.
Cs184View cs184_view_of(const ColladaCamera& camera, ColladaDocument& document);

}  // namespace twinray
