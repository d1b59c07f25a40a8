// SPDX-License-Identifier: Apache-2.0
#include "cli/live/web_picture.h"

#include <algorithm>
#include <utility>

#include "core/error.h"

namespace twinray {
namespace {

/// A page asks four times a second, one that is hidden once.
constexpr std::chrono::seconds attention{3};

}  // namespace

WebPicture::WebPicture(const std::string& picture, const std::string& partial) {
  state_.picture = picture;
  state_.partial = partial;
  state_.layers = live_layers({}, {});
  looks_.resize(state_.layers.size());
}

void WebPicture::begin(const RenderOptions& options, const Scene& scene, const std::vector<LiveLayer>& more) {
  const std::lock_guard lock(mutex_);
  window_ = film_window(options);
  state_.phase = WebState::Phase::rendering;
  state_.width = window_.width();
  state_.height = window_.height();
  state_.layers = live_layers(film_contents(options, scene), scene.light_groups);
  state_.layers.insert(state_.layers.end(), more.begin(), more.end());
  looks_.resize(state_.layers.size());
  state_.progress.samples_total =
      std::uint64_t(window_.width()) * std::uint64_t(window_.height()) * options.samples;
  begun_ = Clock::now();
}

void WebPicture::progress(const RenderProgress& progress) {
  const std::lock_guard lock(mutex_);
  state_.progress = progress;
}

bool WebPicture::is_watched() const {
  const std::lock_guard lock(mutex_);
  return Clock::now() - asked_ < attention;
}

bool WebPicture::is_awaited() const {
  const std::lock_guard lock(mutex_);
  return picture_asked_ > shown_ && Clock::now() - picture_asked_ < attention;
}

std::vector<WebPicture::Seen> WebPicture::seen(Clock::duration within) const {
  const std::lock_guard lock(mutex_);
  std::vector<Seen> seen;
  for (std::size_t i = 0; i < looks_.size(); ++i)
    if (looks_[i].image && Clock::now() - looks_[i].asked < within)
      seen.push_back({state_.layers[i], looks_[i].image});
  return seen;
}

void WebPicture::Seen::copy(const Film& film, const PixelRect& tile) const {
  static thread_local std::vector<float> values;
  read_tile(film, layer, tile, values);
  image->put(tile, values, Clock::now());
}

void WebPicture::copy_old_tiles(const Film& film, const std::vector<Seen>& seen) const {
  const std::vector<PixelRect> tiles = spiral_tiles(window_, tile_size);
  for (const Seen& one : seen)
    for (const PixelRect& tile : tiles)
      if (one.image->is_old(tile)) one.copy(film, tile);
}

void WebPicture::show(const Film& film) {
  needs_film_ = false;
  copy_old_tiles(film, seen(attention));
  const std::lock_guard lock(mutex_);
  shown_ = Clock::now();
}

void WebPicture::show_tile(const Film& film, const PixelRect& tile) {
  for (const Seen& one : seen(attention))
    if (one.image->is_due(tile, Clock::now())) one.copy(film, tile);
}

void WebPicture::show_last(const RenderResult& result) {
  const std::vector<Seen> all = seen(Clock::duration::max());
  for (const Seen& one : all) one.image->age();
  copy_old_tiles(result.film, all);
  const std::lock_guard lock(mutex_);
  state_.phase = WebState::Phase::ended;
  state_.is_complete = result.is_complete;
  state_.seconds = result.seconds;
}

WebState WebPicture::state() {
  const std::lock_guard lock(mutex_);
  asked_ = Clock::now();
  if (state_.phase == WebState::Phase::rendering)
    state_.seconds = std::chrono::duration<double>(asked_ - begun_).count();
  WebState state = state_;
  state.is_stopping = is_stopping_;
  for (const Look& look : looks_) state.versions.push_back(look.image ? look.image->version() : 0);
  return state;
}

std::optional<std::size_t> WebPicture::layer_number(std::string_view name) const {
  const std::lock_guard lock(mutex_);
  const auto found = std::find_if(state_.layers.begin(), state_.layers.end(),
                                  [name](const LiveLayer& layer) { return layer.name == name; });
  if (found == state_.layers.end()) return std::nullopt;
  return std::size_t(found - state_.layers.begin());
}

std::shared_ptr<const LiveImage> WebPicture::look_at(std::size_t layer) {
  const std::lock_guard lock(mutex_);
  Look& look = looks_[layer];
  const Clock::time_point now = Clock::now(), before = std::exchange(look.asked, now);
  asked_ = picture_asked_ = now;
  if (state_.phase != WebState::Phase::rendering) return look.image;
  if (look.image && now - before < attention) return look.image;
  // Tiles came and went while nobody looked.
  if (!look.image) look.image = std::make_shared<LiveImage>(window_, state_.layers[layer].channels.size());
  look.image->age();
  needs_film_ = true;
  return look.image;
}

void WebPicture::stop() {
  const std::lock_guard lock(mutex_);
  if (state_.phase == WebState::Phase::loading) throw Error("The render has not begun.");
  if (state_.phase == WebState::Phase::ended) throw Error("The render has ended.");
  if (state_.partial.empty()) throw Error("The picture goes to no file that could keep a part of it.");
  is_stopping_ = true;
}

}  // namespace twinray
