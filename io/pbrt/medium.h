// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <map>
#include <string>

#include "core/rgb.h"
#include "io/pbrt/context.h"
#include "io/pbrt/parameters.h"

namespace twinray {

/// What fills space between surfaces, of which light is absorbed alone.
class PbrtMedia {
 public:
  explicit PbrtMedia(PbrtContext& context) : context_(context) {}

  /// MakeNamedMedium. Warns of what is not rendered.
  void define(const std::string& name, const PbrtParameters& parameters);
  /// The absorption of a medium per unit of length; black of the one without a name. Throws Error where none
  /// of that name was defined before.
  Rgb absorption(const std::string& name, const PbrtPlace& place) const;

 private:
  PbrtContext& context_;
  std::map<std::string, Rgb> absorptions_;
};

}  // namespace twinray
