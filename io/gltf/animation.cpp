// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/animation.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "io/gltf/accessor.h"
#include "io/gltf/curve.h"
#include "io/gltf/document.h"
#include "io/gltf/formats.h"

namespace twinray {
namespace {

/// What a channel moves.
struct Target {
  std::size_t numbers;  ///< Of one key.
  const GltfFormat& format;
  bool is_rotation = false;
};

class Animator {
 public:
  Animator(GltfDocument& document, double seconds, std::vector<GltfPose>& poses)
      : document_(document), seconds_(seconds), poses_(poses) {}

  void apply(const tinygltf::Animation& animation, const std::string& pointer) {
    for (std::size_t i = 0; i < animation.channels.size(); ++i) {
      const tinygltf::AnimationChannel& channel = animation.channels[i];
      const std::string place = fmt::format("{}/channels/{}", pointer, i);
      if (channel.target_node < 0) continue;  // as the format says
      if (std::size_t(channel.sampler) >= animation.samplers.size())
        document_.context().fail(place + "/sampler",
                                 fmt::format("the index {} is out of range; valid are 0 to {}",
                                             channel.sampler, animation.samplers.size() - 1));
      if (!moved_.insert({channel.target_node, channel.target_path}).second) {
        document_.context().warn(place, "the same is moved by another channel, which counts");
        continue;
      }
      move(channel, animation.samplers[std::size_t(channel.sampler)],
           fmt::format("{}/samplers/{}", pointer, channel.sampler), place);
    }
  }

 private:
  void move(const tinygltf::AnimationChannel& channel, const tinygltf::AnimationSampler& sampler,
            const std::string& sampler_pointer, const std::string& place) {
    GltfPose& pose = poses_[std::size_t(channel.target_node)];
    const std::string& path = channel.target_path;
    if (path == "weights") {
      const std::size_t targets = targets_of(channel.target_node);
      if (targets == 0) return document_.context().warn(place, "the node has no morph targets to weigh");
      pose.weights = value(sampler, {targets, output_format(path)}, sampler_pointer);
      return;
    }
    if (path != "translation" && path != "rotation" && path != "scale")
      return document_.context().warn(place, fmt::format("a path \"{}\" is not rendered", path));
    if (pose.matrix) {
      document_.context().warn(place, "the node has a matrix, which moves in its parts: these begin at rest");
      pose.matrix.reset();
    }
    if (path == "rotation")
      assign(value(sampler, {4, output_format(path), true}, sampler_pointer), pose.rotation);
    else
      assign(value(sampler, {3, output_format(path)}, sampler_pointer),
             path == "scale" ? pose.scale : pose.translation);
  }

  template <std::size_t n>
  static void assign(const std::vector<double>& value, std::array<double, n>& target) {
    std::copy_n(value.begin(), n, target.begin());
  }

  std::size_t targets_of(int node) const {
    const tinygltf::Model& model = document_.model();
    const int mesh = model.nodes[std::size_t(node)].mesh;
    if (mesh < 0) return 0;
    const auto& primitives = model.meshes[std::size_t(mesh)].primitives;
    return primitives.empty() ? 0 : primitives[0].targets.size();
  }

  std::vector<double> value(const tinygltf::AnimationSampler& sampler, const Target& target,
                            const std::string& pointer) {
    const GltfNumbers times = read_numbers(document_, sampler.input, time_format);
    for (std::size_t i = 0; i < times.count; ++i)
      if (!std::isfinite(times.values[i]) || (i > 0 && !(times.values[i] > times.values[i - 1])))
        document_.context().fail(
            pointer + "/input",
            fmt::format("the time {} (number {}) is not behind the one before it", times.values[i], i));
    const GltfNumbers values = read_numbers(document_, sampler.output, target.format);
    const std::size_t wanted =
        times.count * target.numbers * (sampler.interpolation == "CUBICSPLINE" ? 3 : 1);
    if (values.values.size() != wanted)
      document_.context().fail(pointer + "/output", fmt::format("{} numbers for {} keys; there must be {}",
                                                                values.values.size(), times.count, wanted));
    if (target.is_rotation)
      for (std::size_t key = 0; key < times.count; ++key)
        check_rotation(values, sampler.interpolation == "CUBICSPLINE" ? 3 * key + 1 : key, pointer);
    return GltfCurve{times.values, values.values, target.numbers, sampler.interpolation, target.is_rotation}
        .at(seconds_);
  }

  void check_rotation(const GltfNumbers& values, std::size_t row, const std::string& pointer) {
    warn_unless_rotation({values.at(row, 0), values.at(row, 1), values.at(row, 2), values.at(row, 3)},
                         pointer + "/output", document_.context());
  }

  GltfDocument& document_;
  double seconds_;
  std::vector<GltfPose>& poses_;
  std::set<std::pair<int, std::string>> moved_;
};

}  // namespace

std::optional<GltfDuration> duration_of(GltfDocument& document) {
  std::optional<GltfDuration> duration;
  std::set<int> inputs;
  for (const tinygltf::Animation& animation : document.model().animations)
    for (const tinygltf::AnimationSampler& sampler : animation.samplers) inputs.insert(sampler.input);
  for (const int input : inputs)
    for (const float time : read_numbers(document, input, time_format).values) {
      if (!std::isfinite(time)) continue;
      if (!duration) duration = {time, time};
      duration->first = std::min(duration->first, double(time));
      duration->last = std::max(duration->last, double(time));
    }
  return duration;
}

void animate(GltfDocument& document, double seconds, std::vector<GltfPose>& poses) {
  Animator animator(document, seconds, poses);
  const auto& animations = document.model().animations;
  for (std::size_t i = 0; i < animations.size(); ++i)
    animator.apply(animations[i], fmt::format("/animations/{}", i));
}

}  // namespace twinray
