// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/camera.h"
#include "core/transform.h"
#include "io/collada/document.h"
#include "io/cs184/camera.h"

namespace twinray {

/// Reads a <camera>, perspective or orthographic, that an <instance_camera> places by its node's transform,
/// whose axes are made orthonormal: it looks along -z, with y up. Legal are xfov, yfov or both (xmag and ymag
/// of an orthographic one: half the frame), and an aspect_ratio beside one of them. With one alone the shape
/// of the image decides the other, and with yfov (ymag) and an aspect_ratio too. The clip distances are read
/// where LoadOptions::clip_as_file asks for them, each in `unit` units of the scene. Throws Error for numbers
/// out of range.
Camera read_camera(const XmlElement& camera, const XmlElement& instance, const Transform& to_world,
                   double unit, ColladaDocument& document);

/// What CS184's program reads of it: the angles, of which the horizontal one is 50 degrees where the file has
/// none, the clip distances (0.001 and 1000 where the file has none), and the direction from the world's
/// origin to the point one unit in front of the node. Throws Error like read_camera.
Cs184View read_cs184_view(const XmlElement& camera, const XmlElement& instance, const Transform& to_world,
                          ColladaDocument& document);

}  // namespace twinray
