// SPDX-License-Identifier: Apache-2.0
#include "accel/bvh/invariants.h"

#include <fmt/format.h>

#include <vector>

#include "core/slab.h"

namespace twinray {
namespace {

class Inspection {
 public:
  Inspection(const Bvh& bvh, const Geometry& geometry, int max_leaf_size)
      : bvh_(bvh), geometry_(geometry), max_leaf_size_(max_leaf_size) {
    for (std::uint32_t shape = 0; shape < geometry.shapes().size(); ++shape) {
      const Mesh* mesh = geometry.mesh(shape);
      seen_.emplace_back(mesh ? mesh->triangles.size() : geometry.sphere_set(shape)->spheres.size());
    }
  }

  std::string fault() {
    if (geometry_.primitive_count() > 0) visit(bvh_.root, bvh_.box, 0);
    for (std::size_t shape = 0; shape < seen_.size(); ++shape)
      for (std::size_t i = 0; i < seen_[shape].size(); ++i)
        if (seen_[shape][i] != 1)
          report("primitive {} of shape {} lies in {} leaves", i, shape, seen_[shape][i]);
    return fault_;
  }

 private:
  template <typename... Values>
  void report(fmt::format_string<Values...> text, Values&&... values) {
    if (fault_.empty()) fault_ = fmt::format(text, std::forward<Values>(values)...);
  }

  void visit(const NodeRef& node, const Aabb& box, int depth) {
    if (depth > max_bvh_depth) return report("a node is {} deep; the stack holds {}", depth, max_bvh_depth);
    if (node.is_leaf()) return visit_leaf(node, box);
    if (node.first >= bvh_.pairs.size())
      return report("pair {} is named, of {}", node.first, bvh_.pairs.size());
    const NodePair& pair = bvh_.pairs[node.first];
    for (int child = 0; child < 2; ++child) {
      if (!box.contains(pair.box(child))) report("child {} of pair {} leaves its parent", child, node.first);
      visit(pair.children[child], pair.box(child), depth + 1);
    }
  }

  void visit_leaf(const NodeRef& node, const Aabb& box) {
    int primitives = 0;
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      if (i >= bvh_.blocks.size()) return report("block {} is named, of {}", i, bvh_.blocks.size());
      for (std::uint32_t lane = 0; lane < bvh_.blocks[i].count; ++lane, ++primitives)
        visit_primitive(bvh_.blocks[i].ids[lane], box);
    }
    if (primitives == 0 || primitives > max_leaf_size_) report("a leaf holds {} primitives", primitives);
  }

  void visit_primitive(PrimitiveId id, const Aabb& box) {
    if (id.mesh >= seen_.size() || id.primitive >= seen_[id.mesh].size())
      return report("there is no primitive {} of shape {}", id.primitive, id.mesh);
    ++seen_[id.mesh][id.primitive];
    if (!box.contains(padded(primitive_bounds(geometry_, id))))
      report("primitive {} of shape {} leaves its leaf's box", id.primitive, id.mesh);
  }

  const Bvh& bvh_;
  const Geometry& geometry_;
  int max_leaf_size_;
  std::vector<std::vector<int>> seen_;
  std::string fault_;
};

}  // namespace

std::string find_fault(const Bvh& bvh, const Geometry& geometry, int max_leaf_size) {
  return Inspection(bvh, geometry, max_leaf_size).fault();
}

}  // namespace twinray
