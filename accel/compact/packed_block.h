// SPDX-License-Identifier: Apache-2.0
// Private: the primitives of a leaf in little memory, exactly.
//
// The triangles of a leaf are neighbours: they share corners, and the bits of their coordinates, taken for
// integers, lie close together. So a packed block has each corner once, as differences of 16 bits from the
// least of each axis where these suffice, and for each triangle the places of its corners: about 20 bytes a
// triangle of a closed mesh, where a PrimitiveBlock has 48 and more. What does not fit this form (spheres,
// more than eight corners, tiny triangles) is stored as it is.
#pragma once
#include <cstddef>
#include <cstdint>

#include "accel/canonical/primitive_block.h"

namespace twinray {

/// A packed block begins at a multiple of so many words of 16 bits,
inline constexpr std::size_t packed_unit = 4;
/// and may be read for so many words behind its end.
inline constexpr std::size_t packed_slack = 16;

/// The words of a packed block, in this order. Numbers of 32 bits have their lower half first.
///   0, 1, 2       of each corner of a triangle: the places of its vertices, 3 bits a lane, and flags above
///   3             the mesh
///   4, 5          the least index of a primitive in it
///   6 to 11       of each axis the least bits of a coordinate, 32 bits; 0 of a wide axis
///   from 12 on    of each lane the index of its primitive, less the least
///   behind them   of each axis the bits of all vertices' coordinates, less the least; 32 bits on a wide axis
/// With wide ids words 3 to 5 are 0, and each lane has 32 bits of its mesh and 32 of its primitive. Of a
/// block that is stored as it is there are `packed_unit` words of flags and its bytes.
namespace packed {

/// Bits above the places of a corner's vertices.
inline constexpr int flags_shift = 12;
inline constexpr std::uint32_t places_mask = (1u << flags_shift) - 1;
/// Of word 0: bit `axis`: it is wide; and:
inline constexpr std::uint32_t is_cut_out = 8;
/// Of word 1: the number of triangles less 1, and:
inline constexpr std::uint32_t count_mask = 3, has_wide_ids = 4, is_verbatim = 8;
/// Of word 2: the number of vertices less 1.
inline constexpr std::uint32_t vertex_mask = 7;

inline constexpr int max_vertices = 8;
inline constexpr std::size_t ids_word = 12;
/// Of the longest block: one that is stored as it is.
inline constexpr std::size_t max_words = packed_unit + sizeof(PrimitiveBlock) / sizeof(std::uint16_t);

/// What the first words of a block say.
struct Head {
  std::uint32_t wide_axes, count, vertices;
  bool is_cut_out, has_wide_ids, is_verbatim;

  explicit Head(const std::uint16_t* words)
      : wide_axes(std::uint32_t(words[0]) >> flags_shift & 7),
        count((std::uint32_t(words[1]) >> flags_shift & count_mask) + 1),
        vertices((std::uint32_t(words[2]) >> flags_shift & vertex_mask) + 1),
        is_cut_out((std::uint32_t(words[0]) >> flags_shift & packed::is_cut_out) != 0),
        has_wide_ids((std::uint32_t(words[1]) >> flags_shift & packed::has_wide_ids) != 0),
        is_verbatim((std::uint32_t(words[1]) >> flags_shift & packed::is_verbatim) != 0) {}

  bool is_wide(int axis) const { return (wide_axes >> axis & 1) != 0; }
  /// Where the vertices' coordinates begin, and how many words those of an axis take.
  std::size_t vertex_word() const { return ids_word + count * (has_wide_ids ? 4 : 1); }
  std::size_t axis_words(int axis) const { return vertices * (is_wide(axis) ? 2 : 1); }
};

/// A number of 32 bits.
inline std::uint32_t number_at(const std::uint16_t* words, std::size_t index) {
  return words[index] | std::uint32_t(words[index + 1]) << 16;
}

}  // namespace packed

/// Writes a packed block to `words`, of which there must be packed::max_words, and returns how many it took,
/// a multiple of packed_unit.
std::size_t pack(const PrimitiveBlock& block, std::uint16_t* words);

/// The block again: the bits of the one that was packed, in all lanes that it uses.
PrimitiveBlock unpacked(const std::uint16_t* words);

}  // namespace twinray
