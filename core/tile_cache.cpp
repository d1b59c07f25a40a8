// SPDX-License-Identifier: Apache-2.0
#include "core/tile_cache.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/error.h"
#include "core/parallel.h"

namespace twinray {
namespace {

constexpr std::uint64_t tile_bytes = texels_a_tile * sizeof(Rgb);
constexpr Rgb magenta{1, 0, 1};

}  // namespace

/// A place for one tile. Whoever reads needs no lock: what is written, is written between two versions.
class TileCache::Frame {
 public:
  /// The texel, unless the tile of another slot is here, or comes while it is read.
  std::optional<Rgb> texel(const Slot& slot, std::uint32_t index) {
    const std::uint32_t version = version_.load(std::memory_order_acquire);
    if (version % 2 != 0 || owner_.load(std::memory_order_acquire) != &slot) return std::nullopt;
    const Rgb value{load(3 * index), load(3 * index + 1), load(3 * index + 2)};
    if (version_.load(std::memory_order_relaxed) != version) return std::nullopt;
    if (!is_used_.load(std::memory_order_relaxed)) is_used_.store(true, std::memory_order_relaxed);
    return value;
  }

  // The others are called by one thread at a time.

  Slot* owner() const { return owner_.load(std::memory_order_relaxed); }
  bool take_use() { return is_used_.exchange(false, std::memory_order_relaxed); }
  void leave() {
    if (Slot* const owner = owner_.exchange(nullptr, std::memory_order_relaxed))
      owner->store(nullptr, std::memory_order_relaxed);
  }
  /// Each store is seen after those before it: whoever sees a new texel sees that the version is another.
  void fill(Slot& slot, std::span<const Rgb> texels) {
    leave();
    const std::uint32_t version = version_.load(std::memory_order_relaxed);
    version_.store(version + 1, std::memory_order_relaxed);
    owner_.store(&slot, std::memory_order_release);
    for (std::size_t i = 0; i < texels.size(); ++i) {
      store(3 * i, texels[i].r);
      store(3 * i + 1, texels[i].g);
      store(3 * i + 2, texels[i].b);
    }
    version_.store(version + 2, std::memory_order_release);
    slot.store(this, std::memory_order_release);
  }

 private:
  float load(std::size_t i) const { return std::atomic_ref(floats_[i]).load(std::memory_order_acquire); }
  void store(std::size_t i, float value) {
    std::atomic_ref(floats_[i]).store(value, std::memory_order_release);
  }

  std::atomic<std::uint32_t> version_{0};  ///< Odd while a tile is written.
  std::atomic<bool> is_used_{false};
  std::atomic<Slot*> owner_{nullptr};
  std::unique_ptr<float[]> floats_ = std::make_unique<float[]>(3 * texels_a_tile);
};

TileCache::TileCache(std::uint64_t bytes)
    : most_frames_(std::size_t(std::max<std::uint64_t>(bytes / tile_bytes, 1))),
      lookups_(std::make_unique<Count[]>(counts)) {}

TileCache::~TileCache() = default;

Rgb TileCache::texel(Slot& slot, const TileSource& source, const TileLayout::Place& place) {
  const std::size_t thread = std::size_t(thread_index());
  lookups_[thread % counts].lookups.fetch_add(1, std::memory_order_relaxed);
  if (Frame* const frame = slot.load(std::memory_order_acquire))
    if (const std::optional<Rgb> value = frame->texel(slot, place.texel)) return *value;
  std::vector<Rgb> texels(texels_a_tile);
  read(source, place.tile, texels);
  keep(slot, texels);
  return texels[place.texel];
}

void TileCache::read(const TileSource& source, std::uint32_t tile, std::span<Rgb> texels) {
  std::string failure;
  try {
    source.read(tile, texels);
  } catch (const Error& error) {
    std::fill(texels.begin(), texels.end(), magenta);
    failure = error.what();
  }
  const std::lock_guard lock(mutex_);
  ++statistics_.tiles_read;
  if (failure.empty()) return;
  if (++statistics_.tiles_failed == 1) statistics_.first_failure = failure;
}

void TileCache::keep(Slot& slot, std::span<const Rgb> texels) {
  const std::lock_guard lock(mutex_);
  if (!slot.load(std::memory_order_relaxed))  // Else another thread was faster.
    free_frame().fill(slot, texels);
}

TileCache::Frame& TileCache::free_frame() {
  if (frames_.size() < most_frames_) {
    frames_.push_back(std::make_unique<Frame>());
    statistics_.peak_bytes = frames_.size() * tile_bytes;
    return *frames_.back();
  }
  for (;;) {
    Frame& frame = *frames_[hand_];
    hand_ = (hand_ + 1) % frames_.size();
    if (!frame.take_use()) return frame;
  }
}

void TileCache::forget(std::span<Slot> slots) {
  const std::lock_guard lock(mutex_);
  for (const auto& frame : frames_)
    if (frame->owner() >= slots.data() && frame->owner() < slots.data() + slots.size()) frame->leave();
}

TileStatistics TileCache::statistics() const {
  const std::lock_guard lock(mutex_);
  TileStatistics statistics = statistics_;
  for (std::size_t i = 0; i < counts; ++i)
    statistics.lookups += lookups_[i].lookups.load(std::memory_order_relaxed);
  return statistics;
}

std::uint64_t TileCache::most_bytes() const { return most_frames_ * tile_bytes; }

}  // namespace twinray
