// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/vec.h"
#include "io/collada/document.h"

namespace twinray {

/// The elements of a <source> as its <accessor> names them, in order: as many as its array holds.
struct SourceValues {
  std::size_t width = 3;      ///< Numbers of an element.
  std::vector<float> values;  ///< width for each element.
  std::size_t stated = 0;     ///< The elements that the accessor counts: at most count().
  bool has_nan = false;       ///< Some number is not finite: it is NaN here.

  std::size_t count() const { return values.size() / width; }
  /// An element of three numbers.
  Vec3 vec3(std::size_t element) const {
    const float* p = &values[3 * element];
    return {p[0], p[1], p[2]};
  }
  /// Whether all numbers of an element are finite.
  bool is_finite(std::size_t element) const;
};

/// Reads the first `width` named <param>s (all of them, where none has a name) of each element, by the
/// accessor's offset and stride. Counts that disagree with the array are warnings: the array is right. So are
/// a stride and an accessor that are missing. Throws Error where there are fewer parameters.
SourceValues read_source(const XmlElement& source, std::size_t width, ColladaDocument& document);

/// The names of a <source>, for joints and for the targets of a morph.
struct SourceNames {
  std::vector<std::string> names;
  bool are_ids = false;  ///< An IDREF_array has ids, a Name_array sids.
};

/// Throws Error where the source has no such array.
SourceNames read_names(const XmlElement& source);

/// The sources of a mesh, which its primitive elements share: each is read once.
class ColladaSources {
 public:
  explicit ColladaSources(ColladaDocument& document) : document_(document) {}
  /// As read_source() has it.
  std::shared_ptr<const SourceValues> get(const XmlElement& source, std::size_t width);

 private:
  ColladaDocument& document_;
  std::map<std::pair<XmlElement, std::size_t>, std::shared_ptr<const SourceValues>> known_;
};

}  // namespace twinray
