// SPDX-License-Identifier: Apache-2.0
// An ordinary tree made compact: node by node, and block by block.
#include <fmt/format.h>

#include <algorithm>

#include "accel/compact/node.h"
#include "core/error.h"
#include "core/parallel.h"

namespace twinray {
namespace {

/// How many nodes or blocks a task makes.
constexpr std::size_t items_per_task = 2048;

/// All blocks of a tree, packed one behind the other.
class Packing {
 public:
  explicit Packing(const BigVector<PrimitiveBlock>& blocks)
      : places_(blocks.size()), parts_((blocks.size() + items_per_task - 1) / items_per_task) {
    parallel_for(parts_.size(), 1, 0, [&](std::size_t begin, std::size_t end) {
      for (std::size_t part = begin; part < end; ++part) pack_part(blocks, part);
    });
    std::size_t size = 0;
    for (Part& part : parts_) {
      part.begin = size;
      size += part.words.size();
    }
    size_ = size;
    if (size / packed_unit >= WideRef::instance_bit)
      throw Error(fmt::format("the leaves of a compact tree take {} bytes; there may be {}", 2 * size,
                              2 * packed_unit * std::size_t(WideRef::instance_bit)));
  }

  /// Where a block begins, in words.
  std::size_t place(std::size_t block) const { return parts_[block / items_per_task].begin + places_[block]; }
  BigVector<std::uint16_t> words() const {
    BigVector<std::uint16_t> words(size_ + packed_slack);
    parallel_for(parts_.size(), 1, 0, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        std::copy(parts_[i].words.begin(), parts_[i].words.end(),
                  words.begin() + std::ptrdiff_t(parts_[i].begin));
    });
    std::fill(words.begin() + std::ptrdiff_t(size_), words.end(), std::uint16_t(0));
    return words;
  }

 private:
  struct Part {
    std::size_t begin = 0;
    std::vector<std::uint16_t> words;
  };

  void pack_part(const BigVector<PrimitiveBlock>& blocks, std::size_t part) {
    std::vector<std::uint16_t>& words = parts_[part].words;
    const std::size_t first = part * items_per_task;
    for (std::size_t i = first; i < std::min(first + items_per_task, blocks.size()); ++i) {
      std::uint16_t packed[packed::max_words];
      const std::size_t size = pack(blocks[i], packed);
      places_[i] = std::uint32_t(words.size());
      words.insert(words.end(), packed, packed + size);
    }
  }

  std::vector<std::uint32_t> places_;  ///< Of blocks, within their parts.
  std::vector<Part> parts_;
  std::size_t size_ = 0;
};

}  // namespace

CompactBvh::CompactBvh(const WideBvh& bvh) {
  const Packing packing(bvh.blocks);
  const auto packed = [&](WideRef ref) {
    const bool is_block = ref.is_leaf() && !ref.is_none() && !ref.is_instance();
    return is_block ? WideRef::block(packing.place(ref.index()) / packed_unit) : ref;
  };
  root = packed(bvh.root);
  for (const WideRef& prototype : bvh.prototypes) prototypes.push_back(packed(prototype));
  nodes.resize(bvh.nodes.size());
  parallel_for(nodes.size(), items_per_task, 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      nodes[i] = CompactNode(bvh.nodes[i]);
      for (WideRef& child : nodes[i].children) child = packed(child);
    }
  });
  if (!bvh.blocks.empty()) blocks = packing.words();
}

}  // namespace twinray
