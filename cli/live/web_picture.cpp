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

void WebPicture::begin(const RenderOptions& options, const Scene& scene) {
  const std::lock_guard lock(mutex_);
  const PixelRect window = window_of(options);
  state_.phase = WebState::Phase::rendering;
  state_.width = window.width();
  state_.height = window.height();
  state_.layers = live_layers(film_contents(options, scene), scene.light_groups);
  looks_.resize(state_.layers.size());
  state_.progress.samples_total =
      std::uint64_t(window.width()) * std::uint64_t(window.height()) * options.samples;
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

std::vector<std::size_t> WebPicture::watched_layers() const {
  const std::lock_guard lock(mutex_);
  std::vector<std::size_t> layers;
  for (std::size_t i = 0; i < looks_.size(); ++i)
    if (Clock::now() - looks_[i].asked < attention) layers.push_back(i);
  return layers;
}

void WebPicture::copy_layers(const Film& film) {
  // The layers are changed by the render alone, which is here.
  std::vector<std::pair<std::size_t, std::shared_ptr<const LiveValues>>> copies;
  for (const std::size_t layer : watched_layers())
    copies.emplace_back(layer, std::make_shared<const LiveValues>(live_values(film, state_.layers[layer])));
  const std::lock_guard lock(mutex_);
  ++version_;
  for (auto& [layer, values] : copies) looks_[layer].copy = {version_, std::move(values)};
  shown_ = Clock::now();
}

void WebPicture::show(const Film& film) { copy_layers(film); }

void WebPicture::show_last(const RenderResult& result) {
  copy_layers(result.film);
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
  for (const Look& look : looks_) state.versions.push_back(look.copy.version);
  return state;
}

std::optional<std::size_t> WebPicture::layer_number(std::string_view name) const {
  const std::lock_guard lock(mutex_);
  const auto found = std::find_if(state_.layers.begin(), state_.layers.end(),
                                  [name](const LiveLayer& layer) { return layer.name == name; });
  if (found == state_.layers.end()) return std::nullopt;
  return std::size_t(found - state_.layers.begin());
}

WebCopy WebPicture::look_at(std::size_t layer) {
  const std::lock_guard lock(mutex_);
  asked_ = picture_asked_ = looks_[layer].asked = Clock::now();
  return looks_[layer].copy;
}

void WebPicture::stop() {
  const std::lock_guard lock(mutex_);
  if (state_.phase == WebState::Phase::loading) throw Error("The render has not begun.");
  if (state_.phase == WebState::Phase::ended) throw Error("The render has ended.");
  if (state_.partial.empty()) throw Error("The picture goes to no file that could keep a part of it.");
  is_stopping_ = true;
}

}  // namespace twinray
