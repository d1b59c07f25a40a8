// SPDX-License-Identifier: Apache-2.0
#include "cli/resources.h"

#include <fmt/format.h>

#include <utility>

#include "core/film.h"
#include "core/threads.h"

namespace twinray {
namespace {

/// While files are written: linear colours, bytes, and the buffer of the file's writer.
constexpr std::uint64_t picture_bytes_a_pixel = 32;

/// Of layers: the file, which may have to move while it grows.
constexpr std::uint64_t picture_bytes_a_channel = 8;

/// Bytes a primitive, with room: on forests of 200,000 to 2,000,000 triangles these were 162 to 188, 245 to
/// 282, and 184.
std::uint64_t tree_bytes_a_primitive(Backend backend, const BuildOptions& build) {
  switch (backend) {
    case Backend::bvh:
      return build.bvh_width == 2 ? 320 : 240;
    case Backend::embree:
    case Backend::embree_native:
      return 260;
    case Backend::brute_force:
      return 0;
  }
  return 0;
}

}  // namespace

std::vector<MemoryNeed> memory_needs(Backend backend, const BuildOptions& build, std::size_t primitives) {
  const std::uint64_t bytes = tree_bytes_a_primitive(backend, build) * primitives;
  if (bytes == 0) return {};
  return {{fmt::format("the tree of {} over {} primitives", backend_name(backend), primitives), bytes}};
}

std::vector<MemoryNeed> memory_needs(const RenderOptions& options, const Scene& scene) {
  const FilmContents contents = film_contents(options, scene);
  const PixelRect window = window_of(options);
  const std::uint64_t pixels = std::uint64_t(window.width()) * std::uint64_t(window.height());
  std::uint64_t channels = 0;
  for (const Layer layer : contents.layers) channels += channel_count(layer);
  for (const std::size_t parts : contents.parts) channels += 3 * parts;
  const std::uint64_t halves =
      options.half_layers ? 2 * Film::bytes(pixels, half_contents(options, scene)) : 0;
  return {{fmt::format("the film of {} x {} pixels", window.width(), window.height()),
           Film::bytes(pixels, contents) + halves},
          {"the pictures made of it", pixels * (picture_bytes_a_pixel + channels * picture_bytes_a_channel)}};
}

std::vector<MemoryNeed> memory_needs(const RenderArguments& arguments, const Scene& scene) {
  std::vector<MemoryNeed> needs = memory_needs(arguments.render, scene);
  // Instances are built into a tree as primitives are.
  const std::size_t primitives = scene.geometry->primitive_count() + scene.geometry->instances().size();
  const auto add_tree = [&](Backend backend, const BuildOptions& build) {
    for (MemoryNeed& need : memory_needs(backend, build, primitives)) needs.push_back(std::move(need));
  };
  add_tree(arguments.backend, arguments.build);
  if (arguments.check_with) add_tree(arguments.check_with->backend, arguments.check_with->build);
  return needs;
}

std::vector<MemoryNeed> memory_needs(const Recording& recording) {
  const std::uint64_t samples =
      std::uint64_t(recording.width) * std::uint64_t(recording.height) * recording.samples;
  const std::uint64_t rays_a_sample =
      1 + 2 * std::uint64_t(recording.max_depth);  // a camera, shadow and bounce rays
  return {{fmt::format("the rays of {} x {} pixels", recording.width, recording.height),
           samples * rays_a_sample * (sizeof(RecordedRay) + sizeof(Ray))}};
}

std::string thread_warning(int wanted) {
  const ThreadCount threads = count_threads(wanted);
  if (threads.usable == threads.wanted) return {};
  return fmt::format(
      "the system lets the program have {} of {} threads (see ulimit -u, and the container's limit of "
      "processes): it runs on {}",
      threads.usable, threads.wanted, threads.usable == 1 ? "that one" : "those");
}

}  // namespace twinray
