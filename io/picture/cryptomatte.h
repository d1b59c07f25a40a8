// SPDX-License-Identifier: Apache-2.0
// Mattes by name: which things cover a pixel, and how much of it each (Friedman and Jones, "Fully Automatic
// ID Mattes with Support for Motion Blur and Transparency", 2015; Cryptomatte Specification 1.2.0). A thing's
// id is a hash of its name, whose bits are those of a float.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/picture/image_metadata.h"

namespace twinray {

/// MurmurHash3 of 32 bits (Appleby), seed 0, of the name's bytes.
std::uint32_t murmur_hash(std::string_view name);

/// The id of a thing: the bits of a finite, normal float.
std::uint32_t cryptomatte_id(const std::string& name);

/// What a file says of one kind of mattes, "CryptoObject" and the like: how ids are made, and the id of each
/// name.
ImageMetadata cryptomatte_metadata(const std::string& kind, std::span<const std::string> names);

/// How much of a pixel a thing covers.
struct MatteCoverage {
  std::uint32_t id = 0;
  float coverage = 0;  ///< In [0, 1].
};
/// Writes ids and coverages in turn, what covers most first; 0 0 where there are no more. What is more than
/// fits is left out.
void write_ranks(std::span<MatteCoverage> coverages, std::span<float> ranks);

}  // namespace twinray
