// SPDX-License-Identifier: Apache-2.0
// Private: the words of the exchange form, each with the value that it stands for.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "core/light.h"
#include "core/material.h"
#include "core/pixel_filter.h"
#include "core/texture.h"
#include "io/picture/picture_meaning.h"

namespace twinray {

template <typename Value>
using Words = std::vector<std::pair<std::string, Value>>;

template <typename Value>
Words<Value> words();

template <>
Words<EmissionSide> words();
template <>
Words<MapLayout> words();
template <>
Words<WrapMode> words();
template <>
Words<TextureFilter> words();
template <>
Words<NoisePattern> words();
template <>
Words<TexturePlacement> words();
template <>
Words<CoordinateSet> words();
template <>
Words<MaterialInput> words();
template <>
Words<InputMeaning> words();
template <>
Words<PictureRole> words();
template <>
Words<FilterKind> words();

}  // namespace twinray
