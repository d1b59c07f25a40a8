// SPDX-License-Identifier: Apache-2.0
#include "cli/verify/tile_check.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <numeric>
#include <optional>
#include <random>

#include "cli/moving_scene.h"
#include "cli/render_outputs.h"
#include "cli/render_scene.h"
#include "core/error.h"
#include "core/parallel.h"
#include "integrators/tiles.h"

namespace twinray {
namespace {

namespace fs = std::filesystem;

RenderArguments arguments_of_tile(const RenderArguments& arguments, const PixelRect& tile) {
  RenderArguments of_tile = arguments;
  of_tile.render.window = tile;
  of_tile.render.threads = 1;  // Tiles are rendered at the same time.
  return of_tile;
}

/// Moves a tile of the whole frame to where it lies in the picture.
PixelRect in_picture(const PixelRect& tile, const PixelRect& window) {
  return {tile.x0 - window.x0, tile.y0 - window.y0, tile.x1 - window.x0, tile.y1 - window.y0};
}

}  // namespace

std::vector<PixelRect> chosen_tiles(const PixelRect& window, std::uint32_t count, std::uint64_t seed) {
  std::vector<std::uint32_t> numbers(tile_grid(window, tile_size).count());
  std::iota(numbers.begin(), numbers.end(), 0u);
  count = std::min(count, std::uint32_t(numbers.size()));
  std::mt19937_64 random(seed);
  std::vector<PixelRect> tiles;
  for (std::uint32_t i = 0; i < count; ++i) {
    std::swap(numbers[i], numbers[i + random() % (numbers.size() - i)]);
    tiles.push_back(spiral_tiles(window, tile_size, TileRange{numbers[i], numbers[i] + 1}).front());
  }
  return tiles;
}

namespace {

/// The tiles with samples [.., end), of which they have those that come before.
void render_up_to(std::uint32_t end, const TracedScene& of, const RenderArguments& arguments,
                  const std::vector<PixelRect>& tiles, std::vector<std::optional<RenderResult>>& results) {
  parallel_for(tiles.size(), 1, arguments.render.threads, [&](std::size_t i, std::size_t) {
    RenderOptions options = arguments_of_tile(arguments, tiles[i]).render;
    options.range = SampleRange{samples_of(options).begin, end};
    if (results[i]) options.restore = [&](RenderState& state) { state = std::move(*results[i]); };
    results[i] = render(of.scene, of.accelerator, of.integrator, options);
  });
}

/// Each moment is read once.
std::vector<std::optional<RenderResult>> render_motion(const RenderArguments& arguments,
                                                       const LoadedScene& loaded,
                                                       const std::vector<PixelRect>& tiles) {
  MovingScene moving(arguments, loaded);
  const Motion motion = moving.motion();
  const SampleRange samples = samples_of(arguments.render);
  std::vector<std::optional<RenderResult>> results(tiles.size());
  for (std::uint32_t begin = samples.begin, end = 0; begin < samples.end; begin = end) {
    end = std::min(motion.end_of_moment(begin), samples.end);
    render_up_to(end, moving.of_sample(begin), arguments, tiles, results);
  }
  return results;
}

std::vector<std::optional<RenderResult>> render_still(const RenderArguments& arguments, const Scene& scene,
                                                      const std::vector<PixelRect>& tiles) {
  const auto integrator = make_integrator(arguments, scene);
  const auto accelerator = build_accelerator(arguments.backend, scene.geometry, arguments.build);
  std::vector<std::optional<RenderResult>> results(tiles.size());
  parallel_for(tiles.size(), 1, arguments.render.threads, [&](std::size_t i, std::size_t) {
    results[i] = render(scene, *accelerator, *integrator, arguments_of_tile(arguments, tiles[i]).render);
  });
  return results;
}

}  // namespace

std::vector<WrongTile> check_tiles(const ClaimedPicture& picture, const RenderArguments& arguments,
                                   const LoadedScene& loaded, const std::vector<PixelRect>& tiles,
                                   const ScratchFolder& folder) {
  const Scene& scene = loaded.scene;
  const std::vector<std::optional<RenderResult>> results =
      arguments.shutter ? render_motion(arguments, loaded, tiles) : render_still(arguments, scene, tiles);
  const PixelRect window = window_of(arguments.render);
  const SceneNames names = scene_names(scene, film_contents(arguments.render, scene));
  const std::string part = folder.file("tile" + fs::path(arguments.output).extension().string());
  std::vector<WrongTile> found;
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    write_pictures({.picture = part}, arguments, {results[i]->film}, {{}, {}, names});
    const PixelRect place = in_picture(tiles[i], window);
    if (const auto pixels = differences(picture.layers, read_picture(part), place, picture.is_denoised))
      found.push_back({tiles[i], *pixels});
  }
  return found;
}

}  // namespace twinray
