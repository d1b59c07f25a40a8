// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/material.h"
#include "io/pbrt/context.h"
#include "io/pbrt/parameters.h"
#include "io/pbrt/spectrum.h"
#include "io/pbrt/texture.h"

namespace twinray {

/// Reads the inputs of a material, each a value or a texture.
struct PbrtMaterialInputs {
  const PbrtParameters& parameters;
  PbrtTextures& textures;
  PbrtContext& context;
  std::vector<TextureUse>& uses;  ///< Textures that the model's inputs have.

  bool has(const std::string& name) const { return parameters.find(name.c_str()) != nullptr; }
  Rgb color(const char* name, const Rgb& fallback, ColorRole role = ColorRole::reflectance) const;
  /// The same of a name in the file that is not the input's.
  Rgb color(const char* name, const Rgb& fallback, MaterialInput input, InputMeaning meaning) const;
  float number(const char* name, float fallback) const;
  /// One that no texture gives point by point: of a texture the mean, with a warning, within the range.
  float mean_number(const char* name, float fallback, const NumberRange& range) const;
  /// A metal's k by its "reflectance".
  Rgb k_of_reflectance(const PbrtParameter& reflectance) const;
  /// An index of refraction; of a spectrum the mean as the eye weighs it.
  float ior(const char* name) const;
  /// Of a coat: below 1 it is none (core/lobes/coat.h).
  float coat_ior(const char* name) const;
  /// The width of microfacets, of "roughness", "uroughness" and "vroughness" and what stands before these
  /// ("interface."). `input`: the model's.
  Roughness roughness(const std::string& prefix = "", MaterialInput input = MaterialInput::roughness) const;

 private:
  const PbrtTextures::Named& use(const PbrtParameter& parameter, PictureChannels kind,
                                 std::optional<MaterialInput> input,
                                 InputMeaning meaning = InputMeaning::value) const;
  /// The alpha of a roughness along one axis.
  float axis(const PbrtParameter* found, MaterialInput input) const;
};

}  // namespace twinray
