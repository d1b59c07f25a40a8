// SPDX-License-Identifier: Apache-2.0
// The numbers of accessors: typed views of buffers, in which some elements may be replaced (sparse ones).
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/vec.h"

namespace twinray {

class GltfDocument;
struct GltfFormat;

/// Rows of so many numbers each.
struct GltfNumbers {
  std::size_t count = 0, components = 0;
  std::vector<float> values;  ///< count x components

  float at(std::size_t row, std::size_t component) const { return values[row * components + component]; }
  Vec2 vec2(std::size_t row) const { return {at(row, 0), at(row, 1)}; }
  Vec3 vec3(std::size_t row) const { return {at(row, 0), at(row, 1), at(row, 2)}; }
};

/// "/accessors/7"
std::string accessor_pointer(int accessor);

std::size_t accessor_count(const GltfDocument& document, int accessor);

/// The numbers of an accessor as floats: normalised integers in [0, 1] or [-1, 1], others as they are.
/// Without a buffer view they are 0. Throws Error, with the place, where it does not have the format, its
/// data reach beyond their buffer or are not aligned, or it has more elements than the file has bytes.
GltfNumbers read_numbers(GltfDocument& document, int accessor, const GltfFormat& format);

/// Throws Error unless the accessor has the format's type and numbers.
void require_format(const GltfDocument& document, int accessor, const GltfFormat& format);

/// Throws Error, with the accessor and the element, where one of its numbers must be finite and is not.
void require_finite(const GltfDocument& document, int accessor, const GltfFormat& format,
                    const GltfNumbers& numbers);

/// What an accessor's numbers are, of a whole number (or the bits of one that is negative): see read_numbers.
float accessor_number(std::uint32_t bits, const GltfDocument& document, int accessor);

/// Indices of vertices, whole numbers >= 0 as they are; otherwise as read_numbers.
std::vector<std::uint32_t> read_indices(GltfDocument& document, int accessor);

/// The number that no index may be: the largest of its type.
std::uint32_t largest_index(const GltfDocument& document, int accessor);

}  // namespace twinray
