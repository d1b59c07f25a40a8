// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/deform.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>

#include "io/gltf/document.h"
#include "io/gltf/formats.h"
#include "io/gltf/nodes.h"

namespace twinray {
namespace {

using Attributes = std::map<std::string, int>;

/// One row for each position.
GltfNumbers checked_rows(GltfDocument& document, GltfNumbers rows, std::size_t positions,
                         const std::string& pointer) {
  if (rows.count != positions)
    document.context().fail(
        pointer, fmt::format("{} values for {} positions; there must be as many", rows.count, positions));
  return rows;
}

GltfNumbers rows_of(GltfDocument& document, int accessor, const GltfFormat& format, std::size_t positions,
                    const std::string& pointer) {
  return checked_rows(document, read_numbers(document, accessor, format), positions, pointer);
}

void add_to(std::vector<Vec3>& values, const GltfNumbers& changes, float weight) {
  for (std::size_t i = 0; i < values.size(); ++i) values[i] += changes.vec3(i) * weight;
}

void morph(GltfDocument& document, const Attributes& target, float weight, const std::string& pointer,
           GltfPrimitive& made) {
  for (const auto& [name, accessor] : target) {
    const std::string place = pointer + "/" + name;
    std::vector<Vec3>* const values = name == "POSITION" ? &made.positions
                                      : name == "NORMAL" ? &made.normals
                                                         : nullptr;
    if (!values && name != "TANGENT")
      document.context().warn(place, fmt::format("{} of a morph target is not rendered, and left out", name));
    if (values && !values->empty())
      add_to(*values, rows_of(document, accessor, target_format(name), made.positions.size(), place), weight);
  }
}

/// Which joints move each vertex, and how much: sets of four.
class Skinning {
 public:
  Skinning(GltfDocument& document, const GltfPrimitive& primitive, const Attributes& attributes)
      : document_(document), primitive_(primitive) {
    for (int set = 0;; ++set) {
      const auto joints = attributes.find(fmt::format("JOINTS_{}", set));
      const auto weights = attributes.find(fmt::format("WEIGHTS_{}", set));
      if (joints == attributes.end() || weights == attributes.end()) break;
      sets_.push_back({numbers(*joints), numbers(*weights)});
    }
  }

  bool is_empty() const { return sets_.empty(); }

  /// Bytes that stand for numbers up to 1 add up to it but for their rounding.
  void check_weights() const {
    constexpr float rounding = 0.02f;
    for (std::size_t i = 0; i < primitive_.positions.size() && !sets_.empty(); ++i) {
      float sum = 0, least = 0;
      for (const Set& set : sets_)
        for (std::size_t k = 0; k < 4; ++k) {
          sum += set.weights.at(i, k);
          least = std::min(least, set.weights.at(i, k));
        }
      if (least < 0 || !(std::abs(sum - 1) <= rounding))
        document_.context().warn(
            primitive_.pointer + "/attributes/WEIGHTS_0",
            "a vertex has weights below 0, or that do not add up to 1: those above 0 count, divided by their "
            "sum; without any the vertex stays where it is");
    }
  }

  /// The mean of a vertex's joints; the identity where no joint moves it.
  Transform of(std::size_t vertex, const std::vector<Transform>& joints) const {
    Transform sum;
    for (auto& row : sum.m) std::fill(std::begin(row), std::end(row), 0.0);
    double total = 0;
    for (const Set& set : sets_)
      for (std::size_t k = 0; k < 4; ++k) {
        const double weight = set.weights.at(vertex, k);
        if (!(weight > 0)) continue;
        add(joints[joint(set, vertex, k, joints.size())], weight, sum);
        total += weight;
      }
    if (!(total > 0)) return {};
    for (auto& row : sum.m)
      for (double& number : row) number /= total;
    return sum;
  }

 private:
  struct Set {
    GltfNumbers joints, weights;
  };

  GltfNumbers numbers(const Attributes::value_type& attribute) {
    const GltfFormat& format = vertex_format(attribute.first);
    require_format(document_, attribute.second, format);
    const auto unpacked = primitive_.unpacked.find(attribute.first);
    const GltfNumbers rows = unpacked != primitive_.unpacked.end()
                                 ? unpacked->second
                                 : read_numbers(document_, attribute.second, format);
    require_finite(document_, attribute.second, format, rows);
    return checked_rows(document_, rows, primitive_.positions.size(),
                        fmt::format("{}/attributes/{}", primitive_.pointer, attribute.first));
  }

  std::size_t joint(const Set& set, std::size_t vertex, std::size_t k, std::size_t count) const {
    const float number = set.joints.at(vertex, k);
    if (!(number >= 0 && number < float(count)))
      document_.context().fail(
          primitive_.pointer,
          fmt::format("vertex {} names the joint {}; the skin has {}", vertex, number, count));
    return std::size_t(number);
  }

  static void add(const Transform& joint, double weight, Transform& sum) {
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 4; ++column) sum.m[row][column] += weight * joint.m[row][column];
  }

  GltfDocument& document_;
  const GltfPrimitive& primitive_;
  std::vector<Set> sets_;
};

void skin(const Skinning& skinning, const std::vector<Transform>& joints, GltfPrimitive& made) {
  for (std::size_t i = 0; i < made.positions.size(); ++i) {
    const Transform moved = skinning.of(i, joints);
    made.positions[i] = moved.point(made.positions[i]);
    if (!made.normals.empty()) made.normals[i] = moved.front(made.normals[i]);
  }
}

/// A matrix whose last row is 0 0 0 1 where it is so but for what inverting it rounded.
std::vector<double> affine_row(const GltfNumbers& matrices, std::size_t row) {
  constexpr double rounding = 1e-5;
  std::vector<double> numbers(16);
  for (std::size_t c = 0; c < 16; ++c) {
    numbers[c] = double(matrices.at(row, c));
    const double exact = c == 15 ? 1 : 0;
    if (c % 4 == 3 && std::abs(numbers[c] - exact) <= rounding) numbers[c] = exact;
  }
  return numbers;
}

}  // namespace

bool GltfDeformation::is_none() const {
  return joints.empty() && std::all_of(weights.begin(), weights.end(), [](double w) { return w == 0; });
}

std::vector<Transform> joint_transforms(GltfDocument& document, int index,
                                        const std::vector<Transform>& world) {
  const tinygltf::Skin& skin = document.model().skins[std::size_t(index)];
  std::vector<Transform> joints;
  for (const int node : skin.joints) joints.push_back(world[std::size_t(node)]);
  if (skin.inverseBindMatrices < 0) return joints;
  const GltfNumbers matrices = read_numbers(document, skin.inverseBindMatrices, matrix_format);
  if (matrices.count < joints.size())
    document.context().fail(fmt::format("/skins/{}/inverseBindMatrices", index),
                            fmt::format("{} matrices for {} joints", matrices.count, joints.size()));
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const std::string place = fmt::format("{}: matrix {}", accessor_pointer(skin.inverseBindMatrices), i);
    joints[i] = joints[i] * matrix_of(affine_row(matrices, i), place, document.context());
  }
  return joints;
}

bool are_mirrored(const std::vector<Transform>& joints) {
  const auto mirrored = std::count_if(joints.begin(), joints.end(),
                                      [](const Transform& joint) { return joint.determinant() < 0; });
  return 2 * std::size_t(mirrored) > joints.size();
}

GltfPrimitive deformed(GltfDocument& document, const GltfPrimitive& rest,
                       const GltfDeformation& deformation) {
  const tinygltf::Primitive& source =
      document.model().meshes[std::size_t(rest.mesh)].primitives[std::size_t(rest.index)];
  GltfPrimitive made = rest;
  const std::size_t targets = std::min(source.targets.size(), deformation.weights.size());
  for (std::size_t i = 0; i < targets; ++i)
    if (deformation.weights[i] != 0)
      morph(document, source.targets[i], float(deformation.weights[i]),
            fmt::format("{}/targets/{}", rest.pointer, i), made);
  if (deformation.joints.empty()) return made;
  const Skinning skinning(document, rest, source.attributes);
  if (skinning.is_empty())
    document.context().warn(rest.pointer, "a node has a skin for it, and it has no JOINTS_0 and WEIGHTS_0");
  skinning.check_weights();
  skin(skinning, deformation.joints, made);
  return made;
}

}  // namespace twinray
