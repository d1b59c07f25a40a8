// SPDX-License-Identifier: Apache-2.0
// A ray as one word of text that keeps every bit.
#pragma once
#include <cstdint>
#include <string>

#include "core/hit.h"
#include "core/ray.h"

namespace twinray {

/// "ox,oy,oz,dx,dy,dz,t_min,t_max" in hexadecimal floats ("0x1.8p+0", "-0x0p+0", "inf").
std::string ray_text(const Ray& ray);
/// The ray of such a text; decimal numbers are taken as well. Throws UsageError for any other text, and for
/// an invalid ray (core/ray.h).
Ray parse_ray(const std::string& text);

/// "3:7", the primitive of a hit, or "3:7 of instance 2".
std::string primitive_text(std::uint32_t mesh, std::uint32_t primitive, std::uint32_t instance);

}  // namespace twinray
