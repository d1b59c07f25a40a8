// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <vector>

#include "io/collada_document.h"

namespace twinray {

/// The elements of a <source> as its <accessor> names them, in order.
struct SourceValues {
  std::size_t width = 3;      ///< Numbers of an element.
  std::vector<float> values;  ///< width for each element.
  std::size_t count() const { return values.size() / width; }
};

/// Reads the first `width` named <param>s (all of them, where the accessor has none) of each element, by the
/// accessor's count, offset and stride. Throws Error where the array's count is wrong, the accessor reaches
/// beyond the array, or it has fewer parameters.
SourceValues read_source(const XmlElement& source, std::size_t width, const ColladaDocument& document);

}  // namespace twinray
