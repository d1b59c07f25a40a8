// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>

#include "core/scene.h"
#include "io/losses.h"

namespace twinray {

/// The scene for writers that know one set of texture coordinates: pictures that go by the second are their
/// mean colour, which is a loss. It is the same scene where there are none: then it must outlive what is
/// returned.
std::shared_ptr<const Scene> by_first_coordinates(const Scene& scene, Losses& losses);

}  // namespace twinray
