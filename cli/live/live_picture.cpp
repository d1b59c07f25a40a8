// SPDX-License-Identifier: Apache-2.0
#include "cli/live/live_picture.h"

#include <algorithm>
#include <utility>

#include "cli/console.h"

namespace twinray {
namespace {

constexpr std::chrono::milliseconds shortest_interval{250};
/// From one copy to the next, in lengths of a copy.
constexpr int picture_rarity = 50;

}  // namespace

RenderOptions LivePicture::watching(RenderOptions options, const Scene& scene,
                                    const std::vector<LiveLayer>& more) {
  if (viewers_.empty()) return options;
  for (const auto& viewer : viewers_) viewer->begin(options, scene, more);
  options.tile_done = [this](const Film& film, const PixelRect& tile) {
    for (const auto& viewer : viewers_) viewer->show_tile(film, tile);
  };
  options.pass_done = [this](const Film& film) { show_pass(film); };
  options.is_pause_due = [this, is_due = std::move(options.is_pause_due)] {
    return needs_film() || (is_due && is_due());
  };
  options.paused = [this, paused = std::move(options.paused)](const RenderState& state) {
    for (const auto& viewer : viewers_)
      if (viewer->needs_film()) viewer->show(state.film);
    if (paused) paused(state);
  };
  return options;
}

bool LivePicture::needs_film() const {
  return std::any_of(viewers_.begin(), viewers_.end(),
                     [](const auto& viewer) { return viewer->needs_film(); });
}

void LivePicture::progress(const RenderProgress& progress) {
  for (const auto& viewer : viewers_) viewer->progress(progress);
}

bool LivePicture::asks_to_stop() const {
  return std::any_of(viewers_.begin(), viewers_.end(),
                     [](const auto& viewer) { return viewer->asks_to_stop(); });
}

void LivePicture::show_pass(const Film& film) {
  const Clock::time_point begin = Clock::now();
  if (begin < next_) return;
  for (const auto& viewer : viewers_)
    if (viewer->is_ready()) viewer->show(film);
  const Clock::time_point end = Clock::now();
  next_ = end + std::max<Clock::duration>(shortest_interval, picture_rarity * (end - begin));
}

void LivePicture::show_last(const RenderResult& result) {
  for (const auto& viewer : viewers_) viewer->show_last(result);
}

void LivePicture::finish() {
  for (const auto& viewer : viewers_)
    if (const std::string fault = viewer->finish(); !fault.empty()) console::warn(fault);
}

}  // namespace twinray
