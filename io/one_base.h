// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/material.h"
#include "io/losses.h"

namespace twinray {

/// The material with one diffuse base, for formats that know no other: of a Principled the subsurface's,
/// whose colour base_color is then, where that is at least half of what is diffuse; else the other one, with
/// nothing below the surface. What is left out is named.
Material with_one_base(const Material& material, Losses& losses);

}  // namespace twinray
