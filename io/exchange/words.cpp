// SPDX-License-Identifier: Apache-2.0
#include "io/exchange/words.h"

#include "core/textured_material.h"

namespace twinray {

template <>
Words<EmissionSide> words() {
  return {{"front", EmissionSide::front}, {"back", EmissionSide::back}, {"both", EmissionSide::both}};
}

template <>
Words<MapLayout> words() {
  return {{"latitude-longitude", MapLayout::latitude_longitude}, {"equal-area", MapLayout::equal_area}};
}

template <>
Words<WrapMode> words() {
  return {{"repeat", WrapMode::repeat}, {"clamp", WrapMode::clamp}, {"black", WrapMode::black}};
}

template <>
Words<CoordinateSet> words() {
  return {{"first", CoordinateSet::first}, {"second", CoordinateSet::second}};
}

template <>
Words<TextureFilter> words() {
  return {{"nearest", TextureFilter::nearest},
          {"bilinear", TextureFilter::bilinear},
          {"trilinear", TextureFilter::trilinear},
          {"stochastic", TextureFilter::stochastic}};
}

template <>
Words<NoisePattern> words() {
  return {{"fbm", NoisePattern::fbm},
          {"wrinkled", NoisePattern::wrinkled},
          {"windy", NoisePattern::windy},
          {"marble", NoisePattern::marble}};
}

template <>
Words<TexturePlacement> words() {
  return {{"space", TexturePlacement::space},
          {"planar", TexturePlacement::planar},
          {"spherical", TexturePlacement::spherical},
          {"cylindrical", TexturePlacement::cylindrical}};
}

template <>
Words<MaterialInput> words() {
  Words<MaterialInput> inputs;
  for (int i = 0; i < material_inputs; ++i)
    inputs.emplace_back(input_name(MaterialInput(i)), MaterialInput(i));
  return inputs;
}

template <>
Words<InputMeaning> words() {
  return {{"value", InputMeaning::value},
          {"squared_roughness", InputMeaning::squared_roughness},
          {"metal_reflectance", InputMeaning::metal_reflectance},
          {"widening", InputMeaning::widening},
          {"weighted_color", InputMeaning::weighted_color},
          {"emerging", InputMeaning::emerging}};
}

template <>
Words<PictureRole> words() {
  return {{"color", PictureRole::color}, {"data", PictureRole::data}};
}

template <>
Words<FilterKind> words() {
  Words<FilterKind> kinds;
  for (const FilterKind kind : {FilterKind::box, FilterKind::triangle, FilterKind::gaussian,
                                FilterKind::blackman_harris, FilterKind::mitchell})
    kinds.emplace_back(filter_name(kind), kind);
  return kinds;
}

}  // namespace twinray
