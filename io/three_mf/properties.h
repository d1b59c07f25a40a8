// SPDX-License-Identifier: Apache-2.0
// Private: what triangles of 3MF wear: materials and colours, in groups that have numbers.
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/rgb.h"
#include "io/diagnostic.h"
#include "io/xml/reader.h"

namespace twinray {

/// A material, or a colour; linear.
struct ThreeMfProperty {
  std::string name;  ///< Of a colour "#RRGGBB".
  Rgb color;
};

/// Which property an element names: a group, and of an object's default the number in it.
struct ThreeMfChoice {
  std::uint32_t group = 0, index = 0;
};

/// The groups of one document.
class ThreeMfProperties {
 public:
  /// Reads those of <resources>. Throws Error, with the place, where a colour is none.
  ThreeMfProperties(const XmlElement& resources, WarningList& warnings);

  /// Throws Error at the element's place where the group has no such property, or there is no such group.
  /// None of a group of a kind that is not read.
  std::optional<ThreeMfProperty> find(const XmlElement& named_by, const ThreeMfChoice& choice) const;

 private:
  void add(const XmlElement& group, WarningList& warnings);

  std::map<std::uint32_t, std::optional<std::vector<ThreeMfProperty>>> groups_;
};

}  // namespace twinray
