// SPDX-License-Identifier: Apache-2.0
#include "integrators/render.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <chrono>
#include <cmath>
#include <mutex>
#include <utility>
#include <vector>

#include "core/denormals.h"
#include "core/error.h"
#include "core/parallel.h"
#include "integrators/denoise/half_pictures.h"
#include "integrators/sample_maker.h"

namespace twinray {
namespace {

/// Passes grow to this many samples a pixel: a preview is there early, and a tile stays long enough in the
/// caches.
constexpr std::uint32_t longest_pass = 16;
/// How many samples an integrator gets at once, at most: their paths stay in the second cache.
constexpr std::size_t samples_together = 1024;

/// All that a sample's record has: each layer once.
FilmContents recorded(const RenderOptions& options, const FilmContents& contents) {
  FilmContents all = contents;
  std::vector<Layer>& layers = all.layers;
  if (options.half_layers)
    layers.insert(layers.end(), options.half_layers->begin(), options.half_layers->end());
  std::sort(layers.begin(), layers.end());
  layers.erase(std::unique(layers.begin(), layers.end()), layers.end());
  return all;
}

/// One render in progress. Threads take tiles from a counter; a tile's pixels belong to one thread during a
/// pass.
class Renderer {
 public:
  Renderer(const TracedScene& of, const RenderOptions& options,
           const std::function<void(const RenderProgress&)>& progress)
      : of_(of),
        options_(options),
        report_(progress),
        range_(samples_of(options)),
        state_(empty_state(options, of.scene)),
        film_(state_.film),
        tiles_(spiral_tiles(window_of(options), tile_size, options.tiles)) {
    state_.samples = range_.begin;
    if (options.restore) restore();
    if (!options.motion) maker_.emplace(of, options);
    progress_.samples_total = pixel_count() * (range_.end - range_.begin);
    if (options.seconds) progress_.seconds_total = *options.seconds;
    progress_.seconds_before = state_.seconds;
    progress_.noise_target = options.noise_target;
    progress_.error = state_.error;
    progress_.rays = state_.rays.total();
  }

  RenderResult run() {
    const std::uint32_t first = state_.samples;
    bool is_over = first == range_.end || (state_.error && is_good(*state_.error));
    if (is_over) report_that_all_is_there();
    while (!is_over && !is_stopped()) {
      const std::uint64_t rays = state_.rays.total();
      const std::uint32_t begin = state_.samples, end = end_in_time(begin, end_of_pass(begin));
      if (end > begin && !render_pass(begin, end)) break;
      allocate(end);
      // Where time is to decide, a pass may find that all pixels have converged.
      const bool is_idle = begin > first && state_.rays.total() == rays;
      is_over = end == range_.end || (options_.seconds && is_idle);
      if (!is_over && is_stopped()) break;  // Whoever resumes it judges the pass.
      is_over = reaches_target(end) || is_over;
      state_.samples = end;
    }
    state_.seconds += seconds();
    return {{std::move(state_)}, is_over};
  }

 private:
  void restore() {
    options_.restore(state_);
    if (state_.samples >= half_pilot && !repeat_pilot()) return;
    if (state_.samples < range_.begin || state_.samples > range_.end)
      throw_wanted(state_.samples, range_.end);
    for (const PixelRect& tile : tiles_)
      for (int y = tile.y0; y < tile.y1; ++y)
        for (int x = tile.x0; x < tile.x1; ++x)
          if (const std::uint32_t end = end_index(x, y, range_.end), next = next_index(x, y); next > end)
            throw_wanted(next, end);
  }

  /// For who has restored the samples of a render that is over.
  void report_that_all_is_there() {
    if (!report_) return;
    progress_.samples_done = pixel_count() * (state_.samples - range_.begin);
    report_(progress_);
  }

  [[noreturn]] void throw_wanted(std::uint32_t there, std::uint32_t wanted) const {
    throw Error(fmt::format("{} samples of a pixel are there already, and {} are wanted",
                            there - range_.begin, wanted - range_.begin));
  }

  /// Half of the pilot by which samples are spread.
  static constexpr std::uint32_t half_pilot = SampleAllocation::pilot / 2;

  /// Whether there are any behind the pilot.
  bool spreads_samples() const {
    return options_.allocation == Allocation::error && range_.end > SampleAllocation::pilot;
  }

  /// Once the pilot is there, spreads the samples by it. A pass ends at its half, too.
  void allocate(std::uint32_t samples) {
    if (!spreads_samples()) return;
    if (samples == half_pilot) half_pilot_ = pixel_means(film_);
    if (samples == SampleAllocation::pilot)
      allocation_.emplace(film_.window(), half_pilot_, pixel_means(film_));
  }

  /// Makes again the samples by which a render that goes on has spread its own. False where it is stopped.
  bool repeat_pilot() {
    if (!spreads_samples()) return true;
    RenderOptions pilot{.width = options_.width,
                        .height = options_.height,
                        .window = options_.window,
                        .samples = options_.samples,
                        .filter = options_.filter,
                        .sampler = options_.sampler,
                        .seed = options_.seed,
                        .threads = options_.threads,
                        .is_stopped = options_.is_stopped};
    const auto film_of = [&](std::uint32_t begin, std::uint32_t end) {
      pilot.range = SampleRange{begin, end};
      return render(of_.scene, of_.accelerator, of_.integrator, pilot);
    };
    RenderResult half = film_of(0, half_pilot);
    half_pilot_ = pixel_means(half.film);
    const RenderResult rest = film_of(half_pilot, SampleAllocation::pilot);
    if (!half.is_complete || !rest.is_complete) return false;
    half.film.merge(rest.film);
    if (state_.samples >= SampleAllocation::pilot)
      allocation_.emplace(film_.window(), half_pilot_, pixel_means(half.film));
    return true;
  }

  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

  static std::uint64_t pixels_of(const PixelRect& tile) {
    return std::uint64_t(tile.width()) * std::uint64_t(tile.height());
  }

  std::uint64_t pixel_count() const {
    std::uint64_t count = 0;
    for (const PixelRect& tile : tiles_) count += pixels_of(tile);
    return count;
  }

  /// The end of a pass, drawn in so that it is over in time, by the time that the last one took; its begin
  /// where there is none for one more sample.
  std::uint32_t end_in_time(std::uint32_t begin, std::uint32_t end) const {
    if (!options_.seconds || begin == range_.begin) return end;
    const double left = std::max(0.0, *options_.seconds - seconds());
    return left >= pass_seconds_ * (end - begin) ? end : begin + std::uint32_t(left / pass_seconds_);
  }

  /// Whether the picture of so many samples is as good as it is to be.
  bool reaches_target(std::uint32_t samples) {
    const std::uint32_t alike = options_.motion ? options_.motion->samples_per_moment : 1;
    if (!options_.noise_target || samples / alike < least_samples_of_target) return false;
    if (options_.estimated_error && samples < state_.next_estimate) return false;
    state_.next_estimate = samples + samples / 4;
    const double error = options_.estimated_error ? options_.estimated_error(*state_.halves)
                                                  : estimated_relative_error(half_pictures(*state_.halves));
    progress_.error = state_.error = error;
    if (report_) report_(progress_);
    return is_good(error);
  }

  bool is_good(double error) const { return options_.noise_target && error <= *options_.noise_target; }

  bool is_stopped() const { return options_.is_stopped && options_.is_stopped(); }

  bool is_pause_due() const { return options_.is_pause_due && options_.is_pause_due(); }

  /// The samples of the passes that follow are of this moment.
  void stand_at(std::uint32_t moment) {
    if (maker_ && moment == moment_) return;
    maker_.reset();
    const TracedScene now = options_.motion->at(shutter_part(moment, options_.seed));
    if (film_contents(options_, now.scene) != film_.contents())
      throw Error("while the shutter is open, the scene's light groups become others");
    maker_.emplace(now, options_);
    moment_ = moment;
  }

  void stand_or_fail(std::uint32_t moment) {
    try {
      stand_at(moment);
    } catch (const Error&) {
      if (options_.failed) at_present(options_.failed);
      throw;
    }
  }

  /// Shows the render with the seconds that it has taken so far.
  void at_present(const std::function<void(const RenderState&)>& show) {
    const double before = std::exchange(state_.seconds, state_.seconds + seconds());
    show(state_);
    state_.seconds = before;
  }

  /// The next place where a pass may end, whatever was before: 1, 2, 4, ..., longest_pass and its multiples;
  /// the end of a moment. Adaptive sampling decides between passes alone.
  std::uint32_t end_of_pass(std::uint32_t begin) const {
    std::uint32_t end =
        std::min(begin < longest_pass ? std::bit_ceil(begin + 1) : (begin / longest_pass + 1) * longest_pass,
                 range_.end);
    if (options_.motion) end = std::min(end, options_.motion->end_of_moment(begin));
    return options_.adaptive
               ? std::min(end, (begin / options_.adaptive->batch + 1) * options_.adaptive->batch)
               : end;
  }

  /// False where it is stopped before its end.
  bool render_pass(std::uint32_t begin, std::uint32_t end) {
    const double start = seconds();
    if (options_.motion) stand_or_fail(options_.motion->moment_of(begin));
    progress_.samples_done = pixel_count() * (begin - range_.begin);
    std::atomic<std::size_t> next = 0, done = 0;
    render_tiles(begin, end, next, done);
    while (done < tiles_.size() && !is_stopped()) {
      at_present(options_.paused);
      render_tiles(begin, end, next, done);
    }
    if (done < tiles_.size()) return false;
    if (options_.pass_done) options_.pass_done(film_);
    pass_seconds_ = (seconds() - start) / (end - begin);
    return true;
  }

  /// What the samples of a batch are made in.
  struct Batch {
    Batch(const FilmContents& recorded, std::size_t size) : camera_samples(size), records(recorded, size) {
      samples.reserve(size);
    }
    /// How many samples are made together, at most.
    std::size_t size() const { return camera_samples.size(); }

    std::vector<PixelSample> samples;
    std::vector<CameraSample> camera_samples;
    Records records;
  };

  /// Until all are done, or it is stopped or to pause.
  void render_tiles(std::uint32_t begin, std::uint32_t end, std::atomic<std::size_t>& next,
                    std::atomic<std::size_t>& done) {
    const int threads = options_.threads > 0 ? options_.threads : available_threads();
    std::atomic<bool> is_resting = false;
    parallel_for(std::size_t(threads), 1, threads, [&](std::size_t, std::size_t) {
      Batch batch(recorded(options_, film_.contents()), options_.observe ? 1 : samples_together);
      while (!is_stopped() && !is_resting) {
        if (is_pause_due()) is_resting = true;
        if (is_resting) return;
        const std::size_t tile = next++;
        if (tile >= tiles_.size()) return;
        done += render_tile(tiles_[tile], begin, end, batch);
      }
    });
  }

  /// False where it is stopped before all samples of the pass are done.
  bool render_tile(const PixelRect& tile, std::uint32_t begin, std::uint32_t end, Batch& batch) {
    std::vector<RecordedRay> rays;
    Tracer tracer(maker_->accelerator(), options_.counting, options_.observe ? &rays : nullptr);
    std::vector<PixelSample>& samples = batch.samples;
    samples.clear();
    const auto finish = [&] {
      add(batch, tracer);
      if (options_.observe) options_.observe(samples.front(), rays);
      samples.clear();
      rays.clear();
    };
    for_each_sample(tile, begin, end, [&](const PixelSample& sample) {
      samples.push_back(sample);
      if (samples.size() == batch.size()) finish();
    });
    const bool is_done = !is_stopped();
    if (is_done && !samples.empty()) finish();
    if (is_done && options_.tile_done) options_.tile_done(film_, tile);
    finish_tile(is_done ? pixels_of(tile) * (end - begin) : 0, tracer.counts());
    return is_done;
  }

  /// Calls `take(sample)` for the samples of a pass that the tile's pixels still need, until it is stopped.
  template <typename Take>
  void for_each_sample(const PixelRect& tile, std::uint32_t begin, std::uint32_t end, const Take& take) {
    // A large film is not in the cache: its next row is asked for while this one is sampled.
    for (int x = tile.x0; x < tile.x1; ++x) film_.prefetch(x, tile.y0);
    for (int y = tile.y0; y < tile.y1; ++y)
      for (int x = tile.x0; x < tile.x1; ++x) {
        if (is_stopped()) return;
        if (y + 1 < tile.y1) film_.prefetch(x, y + 1);
        if (is_converged(x, y, begin)) continue;
        const std::uint32_t end_of_pixel = end_index(x, y, end);
        for (std::uint32_t index = next_index(x, y); index < end_of_pixel; ++index)
          take(PixelSample{x, y, index});
      }
  }

  /// The end of a pixel's samples after the pass with such an end.
  std::uint32_t end_index(int x, int y, std::uint32_t end) const {
    return allocation_ ? allocation_->samples_of(x, y, end) : end;
  }

  /// The first sample that a pixel does not have.
  std::uint32_t next_index(int x, int y) const {
    const PixelSums& pixel = film_.pixel(x, y);
    return range_.begin + pixel.count + pixel.rejected;
  }

  /// Whether sampling stops before sample `index`. A function of the samples at multiples of the batch alone,
  /// so that a resumed render decides alike: a pixel that has stopped has fewer samples than its next index,
  /// and one that has more is amid the pass.
  bool is_converged(int x, int y, std::uint32_t index) const {
    if (!options_.adaptive || index == 0) return false;
    const std::uint32_t next = next_index(x, y);
    if (next != index) return next < index;
    return index % options_.adaptive->batch == 0 &&
           (!maker_->may_see(x, y) || has_enough_samples(film_.pixel(x, y), *options_.adaptive));
  }

  void add(Batch& batch, Tracer& tracer) {
    const std::span<CameraSample> camera_samples =
        std::span(batch.camera_samples).first(batch.samples.size());
    const RecordSpans records = batch.records.spans(batch.samples.size());
    maker_->make(batch.samples, camera_samples, tracer, records);
    for (std::size_t i = 0; state_.halves && i < batch.samples.size(); ++i) {
      const auto& [x, y, index] = batch.samples[i];
      state_.halves->of(index).add(x, y, index, records, i);
    }
    for (std::size_t begin = 0, end = 0; begin < batch.samples.size(); begin = end) {
      const auto& [x, y, index] = batch.samples[begin];
      while (end < batch.samples.size() && batch.samples[end].x == x && batch.samples[end].y == y) ++end;
      film_.add(x, y, index, records, begin, end - begin);
    }
  }

  void finish_tile(std::uint64_t samples, const RayCounts& rays) {
    const std::lock_guard lock(mutex_);
    state_.rays += rays;
    progress_.rays = state_.rays.total();
    progress_.samples_done += samples;
    if (report_) report_(progress_);
  }

  const TracedScene of_;
  const RenderOptions& options_;
  const std::function<void(const RenderProgress&)>& report_;
  std::optional<SampleMaker> maker_;  ///< Of what moves: at one moment,
  std::uint32_t moment_ = 0;          ///< which is this.
  const SampleRange range_;
  RenderState state_;
  Film& film_;  ///< Its film.
  std::vector<PixelRect> tiles_;
  std::vector<Rgb> half_pilot_;  ///< Means after it.
  std::optional<SampleAllocation> allocation_;
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  double pass_seconds_ = 0;  ///< Of a sample of all pixels, in the last pass.
  std::mutex mutex_;
  RenderProgress progress_;
};

}  // namespace

RenderState empty_state(const RenderOptions& options, const Scene& scene) {
  RenderState state{Film(options.width, options.height, film_window(options), film_contents(options, scene))};
  if (options.half_layers) state.halves = half_films(state.film, half_contents(options, scene));
  return state;
}

RenderResult render(const Scene& scene, const Accelerator& accelerator, const Integrator& integrator,
                    const RenderOptions& options,
                    const std::function<void(const RenderProgress&)>& progress) {
  check(options);
  const KeepDenormals keep;
  return Renderer({scene, accelerator, integrator}, options, progress).run();
}

}  // namespace twinray
