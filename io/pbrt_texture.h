// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <map>
#include <string>

#include "core/rgb.h"
#include "io/pbrt_context.h"
#include "io/pbrt_parameters.h"

namespace twinray {

/// The textures that a file names. Pictures and patterns are not rendered: each stands for its mean color.
class PbrtTextures {
 public:
  explicit PbrtTextures(PbrtContext& context) : context_(context) {}

  /// Defines the texture that a Texture statement describes: its name, "float" or "spectrum", and its class.
  void define(const std::string& name, const std::string& type, const std::string& texture_class,
              const PbrtParameters& parameters);
  /// The mean of the texture that a parameter of type texture names, with a warning unless it is constant.
  /// Throws Error where none of this name was defined before.
  Rgb mean(const PbrtParameters& parameters, const PbrtParameter& parameter);

 private:
  struct Texture {
    Rgb mean;
    bool is_constant = false;
  };
  Texture value(const PbrtParameters& parameters, const char* name, float fallback);
  Texture mean_of(const std::string& texture_class, const PbrtParameters& parameters);
  Texture read_picture(const PbrtParameters& parameters);

  PbrtContext& context_;
  std::map<std::string, Texture> textures_;
};

}  // namespace twinray
