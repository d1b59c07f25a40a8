// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "core/rgb.h"
#include "io/pbrt/context.h"
#include "io/pbrt/parameters.h"

namespace twinray {

/// What fills space between surfaces, of which light is absorbed alone. A statement may name it before
/// another one makes it.
struct PbrtMedium {
  std::optional<Rgb> absorption;  ///< Per unit of length; nothing until it is made.
  PbrtPlace first_use;
};
/// Null: nothing fills the space.
using PbrtMediumPointer = std::shared_ptr<const PbrtMedium>;

/// Whether it absorbs, or may do so once it is made.
inline bool may_absorb(const PbrtMediumPointer& medium) {
  return medium && !(medium->absorption && is_black(*medium->absorption));
}
/// Once all are made.
inline Rgb absorption_of(const PbrtMediumPointer& medium) {
  return medium ? medium->absorption.value() : Rgb{};
}

class PbrtMedia {
 public:
  explicit PbrtMedia(PbrtContext& context) : context_(context) {}

  /// MakeNamedMedium. Warns of what is not rendered.
  void define(const std::string& name, const PbrtParameters& parameters);
  /// The medium of that name, which may be made later; null for the one without a name.
  PbrtMediumPointer named(const std::string& name, const PbrtPlace& place);
  /// Throws Error where a name was used that no statement gave.
  void check_all_made() const;

 private:
  PbrtContext& context_;
  std::map<std::string, std::shared_ptr<PbrtMedium>> media_;
};

}  // namespace twinray
