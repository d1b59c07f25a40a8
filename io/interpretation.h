// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace twinray {

/// By whose rules a scene file becomes a scene.
enum class Interpretation {
  standard,  ///< As COLLADA says.
  /// As the program of Berkeley's course CS184 has it, so that its pictures have the same outlines: the file
  /// gives the camera's direction and lens alone, and the scene's size its place (io/cs184/camera.h); normals
  /// are made anew (io/cs184/normals.h); a <node> has one object and a <mesh> one primitive element; point
  /// lights do not fall off, directional ones come from the point one unit in front of their node, spot
  /// lights give none.
  cs184,
};

}  // namespace twinray
