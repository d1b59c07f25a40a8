// SPDX-License-Identifier: Apache-2.0
#include "io/collada/skin.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/collada/source.h"
#include "io/collada/transform.h"

namespace twinray {
namespace {

Transform matrix_at(const std::vector<double>& numbers, std::size_t first) {
  Transform result;
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 4; ++column)
      result.m[row][column] = numbers[first + 4 * row + column];
  return result;
}

std::vector<Transform> read_inverse_binds(const XmlElement& joints, ColladaDocument& document) {
  const XmlElement source = document.resolve(required_input(joints, "INV_BIND_MATRIX"), "source", "source");
  const std::vector<double> numbers = source.required_child("float_array").doubles();
  std::vector<Transform> result;
  for (std::size_t i = 0; i + 16 <= numbers.size(); i += 16) result.push_back(matrix_at(numbers, i));
  return result;
}

/// What each joint makes of a point in the geometry's coordinates.
std::vector<Transform> joint_transforms(const XmlElement& skin, const XmlElement& instance,
                                        const ColladaJoints& scene, ColladaDocument& document) {
  const XmlElement joints = skin.required_child("joints");
  const XmlElement source = document.resolve(required_input(joints, "JOINT"), "source", "source");
  const SourceNames names = read_names(source);
  const std::vector<Transform> inverse_binds = read_inverse_binds(joints, document);
  if (inverse_binds.size() < names.names.size())
    joints.fail(fmt::format("there are {} joints, and {} inverse bind matrices", names.names.size(),
                            inverse_binds.size()));
  const Transform shape = bind_shape(skin, document);
  std::vector<Transform> result;
  for (std::size_t i = 0; i < names.names.size(); ++i) {
    const ColladaJoint* joint =
        names.are_ids ? scene.with_id(names.names[i]) : scene.named(names.names[i], instance);
    if (!joint) source.fail(fmt::format("no <node> of the scene is the joint \"{}\"", names.names[i]));
    result.push_back(joint->to_scene * conversion(document.space_of(skin), document.space_of(joint->node)) *
                     inverse_binds[i] * shape);
  }
  return result;
}

/// The sum of transforms, each with its weight.
struct Blend {
  Transform sum = Transform::scaling(0, 0, 0);
  double weights = 0;

  void add(const Transform& t, double weight) {
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 4; ++column) sum.m[row][column] += weight * t.m[row][column];
    weights += weight;
  }
  Transform mean() const {
    Transform result = sum;
    for (auto& row : result.m)
      for (double& x : row) x /= weights;
    return result;
  }
};

/// The lists of a <vertex_weights>: for each vertex how many joints move it, and for each of these the index
/// of the joint and that of the weight.
struct Influences {
  XmlElement v;
  std::vector<std::uint32_t> counts;
  std::vector<double> indices;
  std::size_t stride = 1, joint = 0, weight = 0;
  SourceValues weights;

  /// The joint of an influence, which is -1 or below `joints`.
  std::int64_t joint_of(std::size_t influence, std::size_t joints) const {
    return checked(influence * stride + joint, -1, joints, "joint");
  }
  double weight_of(std::size_t influence) const {
    const auto at = checked(influence * stride + weight, 0, weights.count(), "weight");
    return weights.values[std::size_t(at)];
  }

 private:
  std::int64_t checked(std::size_t at, int least, std::size_t count, const char* what) const {
    const double index = indices[at];
    if (index < least || index >= double(count) || index != std::floor(index))
      throw error_at(v.number_place(at), fmt::format("{} is not the index of a {}; there are {}, numbered "
                                                     "from 0",
                                                     index, what, count));
    return std::int64_t(index);
  }
};

Influences read_influences(const XmlElement& skin, std::size_t vertices, ColladaDocument& document) {
  const XmlElement element = skin.required_child("vertex_weights");
  const XmlElement joint = required_input(element, "JOINT"), weight = required_input(element, "WEIGHT");
  Influences result{element.required_child("v"), element.required_child("vcount").indices()};
  result.indices = result.v.doubles();
  result.joint = joint.required_index_attribute("offset");
  result.weight = weight.required_index_attribute("offset");
  for (const XmlElement& input : element.children("input"))
    result.stride = std::max(result.stride, input.required_index_attribute("offset") + std::size_t(1));
  result.weights = read_source(document.resolve(weight, "source", "source"), 1, document);
  std::size_t influences = 0;
  for (const std::uint32_t count : result.counts) influences += count;
  if (result.counts.size() < vertices)
    element.fail(
        fmt::format("<vcount> has {} numbers, and there are {} vertices", result.counts.size(), vertices));
  if (result.indices.size() / result.stride < influences)
    element.fail(fmt::format("<vcount> asks for {} joints of {} indices, and <v> has {} indices", influences,
                             result.stride, result.indices.size()));
  return result;
}

}  // namespace

Transform bind_shape(const XmlElement& skin, ColladaDocument& document) {
  const auto matrix = skin.child("bind_shape_matrix");
  return matrix ? read_matrix(*matrix, document) : Transform{};
}

std::vector<Transform> skin_transforms(const XmlElement& skin, const XmlElement& instance,
                                       std::size_t vertices, const ColladaJoints& joints,
                                       ColladaDocument& document) {
  const std::vector<Transform> moves = joint_transforms(skin, instance, joints, document);
  const Transform shape = bind_shape(skin, document);
  const Influences influences = read_influences(skin, vertices, document);
  std::vector<Transform> result;
  std::size_t next = 0;
  for (std::size_t vertex = 0; vertex < vertices; ++vertex) {
    Blend blend;
    for (const std::size_t end = next + influences.counts[vertex]; next < end; ++next) {
      const std::int64_t joint = influences.joint_of(next, moves.size());
      blend.add(joint < 0 ? shape : moves[std::size_t(joint)], influences.weight_of(next));
    }
    result.push_back(blend.weights > 0 ? blend.mean() : shape);
  }
  return result;
}

}  // namespace twinray
