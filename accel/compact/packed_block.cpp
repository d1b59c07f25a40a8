// SPDX-License-Identifier: Apache-2.0
#include "accel/compact/packed_block.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <optional>

namespace twinray {
namespace {

using packed::Head;

using VertexBits = std::array<std::uint32_t, 3>;

std::uint32_t lanes_of(std::uint32_t count) { return (1u << count) - 1; }

/// The different corners of a block's triangles, by their bits.
struct SharedVertices {
  int count = 0;
  VertexBits bits[packed::max_vertices] = {};
  std::uint32_t places[3] = {};  ///< Of each corner: 3 bits a lane.

  /// False where there are too many.
  bool add(int corner, std::uint32_t lane, const VertexBits& vertex) {
    const auto end = bits + count;
    const auto place = std::uint32_t(std::find(bits, end, vertex) - bits);
    if (place == packed::max_vertices) return false;
    if (place == std::uint32_t(count)) bits[count++] = vertex;
    places[corner] |= place << (3 * lane);
    return true;
  }
};

VertexBits bits_of_corner(const PrimitiveBlock& block, int corner, std::uint32_t lane) {
  VertexBits bits;
  for (int axis = 0; axis < 3; ++axis)
    bits[axis] = std::bit_cast<std::uint32_t>(block.corners[corner][axis][lane]);
  return bits;
}

/// None for a block that holds anything but opaque triangles, or cut-outs, of few corners.
std::optional<SharedVertices> shared_vertices(const PrimitiveBlock& block) {
  const std::uint32_t lanes = lanes_of(block.count);
  const bool is_opaque = block.triangles == lanes && block.others == 0;
  const bool is_cut_out = block.cut_outs == lanes && block.others == lanes && block.triangles == 0;
  if ((!is_opaque && !is_cut_out) || block.count == 0) return std::nullopt;
  SharedVertices vertices;
  for (std::uint32_t lane = 0; lane < block.count; ++lane)
    for (int corner = 0; corner < 3; ++corner)
      if (!vertices.add(corner, lane, bits_of_corner(block, corner, lane))) return std::nullopt;
  return vertices;
}

/// Writes words one behind the other.
class Writer {
 public:
  explicit Writer(std::uint16_t* words) : words_(words) {}

  void word(std::uint32_t value) { words_[size_++] = std::uint16_t(value); }
  void number(std::uint32_t value) {
    word(value);
    word(value >> 16);
  }
  /// Fills up to a multiple of packed_unit; returns the size.
  std::size_t finish() {
    while (size_ % packed_unit != 0) word(0);
    return size_;
  }

 private:
  std::uint16_t* words_;
  std::size_t size_ = 0;
};

/// The numbers of an axis, or the ids of a block: the least, and whether all differences fit into 16 bits.
struct Span {
  std::uint32_t least = UINT32_MAX, most = 0;

  void add(std::uint32_t value) {
    least = std::min(least, value);
    most = std::max(most, value);
  }
  bool is_wide() const { return most - least > UINT16_MAX; }
};

Span span_of(const SharedVertices& vertices, int axis) {
  Span span;
  for (int i = 0; i < vertices.count; ++i) span.add(vertices.bits[i][axis]);
  return span;
}

/// The primitives' indices; and whether each needs all of its id.
struct Ids {
  Span primitives;
  bool is_wide = false;

  explicit Ids(const PrimitiveBlock& block) {
    for (std::uint32_t lane = 0; lane < block.count; ++lane) {
      primitives.add(block.ids[lane].primitive);
      is_wide |= block.ids[lane].mesh != block.ids[0].mesh;
    }
    is_wide |= primitives.is_wide() || block.ids[0].mesh > UINT16_MAX;
  }
};

std::size_t pack_verbatim(const PrimitiveBlock& block, std::uint16_t* words) {
  std::fill_n(words, packed_unit, std::uint16_t(0));
  words[1] = packed::is_verbatim << packed::flags_shift;
  std::memcpy(words + packed_unit, &block, sizeof block);
  return packed::max_words;
}

std::size_t pack_shared(const PrimitiveBlock& block, const SharedVertices& vertices, std::uint16_t* words) {
  const Ids ids(block);
  Span spans[3];
  std::uint32_t flags[3] = {block.cut_outs != 0 ? packed::is_cut_out : 0,
                            std::uint32_t(block.count - 1) | (ids.is_wide ? packed::has_wide_ids : 0),
                            std::uint32_t(vertices.count - 1)};
  for (int axis = 0; axis < 3; ++axis) {
    spans[axis] = span_of(vertices, axis);
    flags[0] |= std::uint32_t(spans[axis].is_wide()) << axis;
  }
  Writer writer(words);
  for (int corner = 0; corner < 3; ++corner)
    writer.word(vertices.places[corner] | flags[corner] << packed::flags_shift);
  writer.word(ids.is_wide ? 0 : block.ids[0].mesh);
  writer.number(ids.is_wide ? 0 : ids.primitives.least);
  for (const Span& span : spans) writer.number(span.is_wide() ? 0 : span.least);
  for (std::uint32_t lane = 0; lane < block.count; ++lane) {
    if (ids.is_wide) {
      writer.number(block.ids[lane].mesh);
      writer.number(block.ids[lane].primitive);
    } else {
      writer.word(block.ids[lane].primitive - ids.primitives.least);
    }
  }
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < vertices.count; ++i) {
      const std::uint32_t bits = vertices.bits[i][axis];
      spans[axis].is_wide() ? writer.number(bits) : writer.word(bits - spans[axis].least);
    }
  return writer.finish();
}

PrimitiveId id_at(const Head& head, const std::uint16_t* words, std::uint32_t lane) {
  if (!head.has_wide_ids) return {words[3], packed::number_at(words, 4) + words[packed::ids_word + lane]};
  const std::size_t at = packed::ids_word + 4 * lane;
  return {packed::number_at(words, at), packed::number_at(words, at + 2)};
}

}  // namespace

std::size_t pack(const PrimitiveBlock& block, std::uint16_t* words) {
  const std::optional<SharedVertices> vertices = shared_vertices(block);
  return vertices ? pack_shared(block, *vertices, words) : pack_verbatim(block, words);
}

PrimitiveBlock unpacked(const std::uint16_t* words) {
  const Head head(words);
  PrimitiveBlock block;
  if (head.is_verbatim) {
    std::memcpy(static_cast<void*>(&block), words + packed_unit, sizeof block);
    return block;
  }
  block.count = std::uint16_t(head.count);
  const std::uint32_t lanes = lanes_of(head.count);
  (head.is_cut_out ? block.others : block.triangles) = lanes;
  block.cut_outs = std::uint16_t(head.is_cut_out ? lanes : 0);
  std::size_t row = head.vertex_word();
  for (int axis = 0; axis < 3; ++axis) {
    const std::uint32_t least = packed::number_at(words, std::size_t(6 + 2 * axis));
    for (std::uint32_t lane = 0; lane < head.count; ++lane)
      for (int corner = 0; corner < 3; ++corner) {
        const std::size_t place = words[corner] >> (3 * lane) & 7;
        const std::uint32_t bits =
            head.is_wide(axis) ? packed::number_at(words, row + 2 * place) : words[row + place];
        block.corners[corner][axis][lane] = std::bit_cast<float>(least + bits);
      }
    row += head.axis_words(axis);
  }
  for (std::uint32_t lane = 0; lane < head.count; ++lane) block.ids[lane] = id_at(head, words, lane);
  return block;
}

}  // namespace twinray
