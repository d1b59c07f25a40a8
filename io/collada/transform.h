// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/transform.h"
#include "io/collada/document.h"

namespace twinray {

/// The transform of a <matrix> or <bind_shape_matrix>. Throws Error for a wrong count, and for what is no
/// affine transform. One of 12 to 15 numbers, as CS184's CBgems.dae has it, is taken with a warning.
Transform read_matrix(const XmlElement& matrix, ColladaDocument& document);

/// The transform of a <node>: its <matrix>, <translate>, <rotate>, <scale>, <lookat> and <skew>, of any
/// number and order, each after those that follow it. Throws Error for wrong counts, and for what is no
/// affine transform. By CS184's rules the first matrix is the last of them.
Transform read_node_transform(const XmlElement& node, ColladaDocument& document);

}  // namespace twinray
