// SPDX-License-Identifier: Apache-2.0
#include "cli/resources.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "accel/build_options.h"
#include "core/film.h"
#include "core/threads.h"

namespace twinray {
namespace {

/// While files are written: linear colours, bytes, and the buffer of the file's writer.
constexpr std::uint64_t picture_bytes_a_pixel = 32;

/// Of layers: the file, which may have to move while it grows.
constexpr std::uint64_t picture_bytes_a_channel = 8;

/// Bytes a primitive, with room. A large compact tree is built in parts, of which one at a time is an
/// ordinary tree: balls of 10,000,000 triangles took 71 bytes a primitive, the part included.
constexpr std::uint64_t wide_bytes = 240, compact_bytes = 90;

/// Primitives of the largest part of a compact tree. Several parts have about an eighth of all each, and of
/// many primitives a sixteenth at most.
std::uint64_t compact_part(std::uint64_t primitives) {
  constexpr std::uint64_t least_part = 1 << 20;
  return primitives <= least_part ? primitives : std::max(least_part / 4, primitives / 16);
}

/// Of forests of 200,000 to 2,000,000 triangles these took 162 to 188, 245 to 282, and 184 bytes a primitive.
std::uint64_t tree_bytes(Backend backend, const BuildOptions& build, std::uint64_t primitives) {
  switch (backend) {
    case Backend::bvh:
      if (build.bvh_width == 2) return 320 * primitives;
      if (build.memory_mode == MemoryMode::ordinary) return wide_bytes * primitives;
      return compact_bytes * primitives + wide_bytes * compact_part(primitives);
    case Backend::embree:
    case Backend::embree_native:
      return 260 * primitives;
    case Backend::brute_force:
      return 0;
  }
  return 0;
}

/// What the tree would take if it were compact, where that is less.
std::string compact_text(Backend backend, const BuildOptions& build, std::uint64_t primitives) {
  if (backend != Backend::bvh || build.bvh_width == 2 || build.memory_mode == MemoryMode::compact) return {};
  BuildOptions compact = build;
  compact.memory_mode = MemoryMode::compact;
  const std::uint64_t bytes = tree_bytes(backend, compact, primitives);
  if (bytes >= tree_bytes(backend, build, primitives)) return {};
  return fmt::format("{} with --memory-mode=compact", bytes_text(bytes));
}

}  // namespace

std::vector<MemoryNeed> memory_needs(Backend backend, const BuildOptions& build, std::size_t primitives) {
  const std::uint64_t bytes = tree_bytes(backend, build, primitives);
  if (bytes == 0) return {};
  return {{fmt::format("the tree of {} over {} primitives", backend_name(backend), primitives), bytes,
           compact_text(backend, build, primitives)}};
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
  const std::size_t others = needs.size();
  // Instances are built into a tree as primitives are.
  const std::size_t primitives = scene.geometry->primitive_count() + scene.geometry->instances().size();
  const auto add_tree = [&](Backend backend, const BuildOptions& build) {
    for (MemoryNeed& need : memory_needs(backend, build, primitives)) needs.push_back(std::move(need));
  };
  add_tree(arguments.backend, arguments.build);
  if (arguments.shutter && needs.size() > others)  // That of the moment, beside that at rest.
    needs.push_back({"the same at another moment", needs.back().bytes, {}});
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
