// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/instancing.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <optional>

#include "io/gltf/accessor.h"
#include "io/gltf/document.h"
#include "io/gltf/formats.h"
#include "io/gltf/nodes.h"

namespace twinray {
namespace {

constexpr const char* extension_name = "EXT_mesh_gpu_instancing";

/// The rows of one of the attributes, if the extension has it.
class Instances {
 public:
  Instances(GltfDocument& document, int node)
      : document_(document),
        attributes_(document.model()
                        .nodes[std::size_t(node)]
                        .extensions.find(extension_name)
                        ->second.Get("attributes")),
        pointer_(fmt::format("/nodes/{}/extensions/{}/attributes", node, extension_name)) {}

  std::vector<GltfPose> poses() {
    read("TRANSLATION", [](GltfPose& pose, const GltfNumbers& rows, std::size_t i) {
      for (std::size_t c = 0; c < 3; ++c) pose.translation[c] = rows.at(i, c);
    });
    read("ROTATION", [this](GltfPose& pose, const GltfNumbers& rows, std::size_t i) {
      for (std::size_t c = 0; c < 4; ++c) pose.rotation[c] = rows.at(i, c);
      warn_unless_rotation(pose.rotation, pointer_ + "/ROTATION", document_.context());
    });
    read("SCALE", [](GltfPose& pose, const GltfNumbers& rows, std::size_t i) {
      for (std::size_t c = 0; c < 3; ++c) pose.scale[c] = rows.at(i, c);
    });
    if (!poses_) document_.context().fail(pointer_, "instances need TRANSLATION, ROTATION or SCALE");
    return std::move(*poses_);
  }

 private:
  template <typename Set>
  void read(const char* name, const Set& set) {
    if (!attributes_.Has(name)) return;
    const GltfNumbers rows =
        read_numbers(document_, attributes_.Get(name).GetNumberAsInt(), instance_format(name));
    if (!poses_) poses_.emplace(rows.count);
    if (poses_->size() != rows.count)
      document_.context().fail(
          fmt::format("{}/{}", pointer_, name),
          fmt::format("{} values for {} instances; there must be as many", rows.count, poses_->size()));
    for (std::size_t i = 0; i < rows.count; ++i) set((*poses_)[i], rows, i);
  }

  GltfDocument& document_;
  const tinygltf::Value& attributes_;
  std::string pointer_;
  std::optional<std::vector<GltfPose>> poses_;
};

}  // namespace

std::vector<Transform> instance_transforms(GltfDocument& document, int node, const Transform& to_world) {
  if (document.model().nodes[std::size_t(node)].extensions.count(extension_name) == 0) return {to_world};
  std::vector<Transform> transforms;
  for (const GltfPose& pose : Instances(document, node).poses())
    transforms.push_back(to_world * transform_of(pose));
  return transforms;
}

}  // namespace twinray
