// SPDX-License-Identifier: Apache-2.0
#include "cli/error/measurement.h"

#include <ctime>

#include "check/visible_emitters.h"
#include "cli/console.h"
#include "cli/moving_scene.h"
#include "cli/render_scene.h"
#include "cli/render_talk.h"
#include "cli/resources.h"
#include "cli/statistics_report.h"

namespace twinray::error {
namespace {

double process_seconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

double samples_per_pixel(const Film& film) {
  const PixelRect& window = film.window();
  std::uint64_t samples = 0;
  for (int y = window.y0; y < window.y1; ++y)
    for (int x = window.x0; x < window.x1; ++x) samples += film.pixel(x, y).count + film.pixel(x, y).rejected;
  return double(samples) / (double(window.width()) * double(window.height()));
}

/// Tells the watch of pictures that are rendered one after the other.
class Progress {
 public:
  Progress(const Watch& watch, std::uint64_t total) : watch_(watch), total_(total) {}

  /// Renders; none where it was stopped.
  std::optional<Sampled> render(const Subject& subject, std::uint64_t seed, std::uint32_t samples,
                                const std::string& doing) {
    Sampled picture = subject.render(seed, samples, watch_.is_stopped, [&](std::uint64_t done) {
      watch_.progress(doing, before_ + done, total_);
    });
    before_ += samples * subject.pixel_count();
    return picture.is_complete ? std::optional(std::move(picture)) : std::nullopt;
  }

 private:
  const Watch& watch_;
  std::uint64_t before_ = 0, total_;
};

std::vector<Curve> empty_curves(const std::vector<Subject>& subjects, const Rounds& rounds) {
  std::vector<Curve> curves;
  for (const Subject& subject : subjects) {
    Curve& curve = curves.emplace_back(Curve{subject.set().name, subject.set().options, {}});
    for (const std::uint32_t samples : rounds.samples) {
      curve.points.emplace_back();
      curve.points.back().samples = samples;
    }
  }
  return curves;
}

std::uint64_t total_samples(const std::vector<Subject>& subjects, const Rounds& rounds) {
  std::uint64_t samples = 0;
  for (const std::uint32_t one : rounds.samples) samples += one;
  return samples * std::uint64_t(rounds.seeds) * subjects.size() * subjects.front().pixel_count();
}

void add(const Sampled& picture, const Measurement& measurement, Point& point) {
  point.samples_per_pixel.push_back(picture.samples_per_pixel);
  point.cpu_seconds.push_back(picture.cpu_seconds);
  point.errors.push_back(squared_error(picture.mean, measurement.converged, measurement.mask));
  point.moments.add(picture.mean);
}

}  // namespace

Subject::Subject(const OptionSet& set) : set_(set) {
  RenderArguments& arguments = set_.arguments;
  RenderTalk silence;
  loaded_ = std::make_unique<const LoadedScene>(load_for_render(arguments, silence));
  const Scene& scene = loaded_->scene;
  choose_engine(*scene.geometry, arguments);
  check_memory(memory_needs(arguments, scene));
  integrator_ = make_integrator(arguments, scene);
  accelerator_ = build_accelerator(arguments.backend, scene.geometry, arguments.build);
}

Sampled Subject::render(std::uint64_t seed, std::uint32_t samples, const std::function<bool()>& is_stopped,
                        const std::function<void(std::uint64_t)>& progress) const {
  RenderOptions options = set_.arguments.render;
  options.seed = seed;
  options.samples = samples;
  options.is_stopped = is_stopped;
  const double begin = process_seconds();
  MovingScene moving(set_.arguments, *loaded_);
  if (set_.arguments.shutter) options.motion = moving.motion();
  const RenderResult result = twinray::render(loaded_->scene, *accelerator_, *integrator_, options,
                                              [&](const RenderProgress& all) { progress(all.samples_done); });
  const double seconds = process_seconds() - begin;
  if (const std::string rejected = rejection_text(result.film, set_.arguments); !rejected.empty())
    console::warn(rejected);
  return {mean_image(result.film), seconds, samples_per_pixel(result.film), result.is_complete};
}

PixelMask Subject::without_emitters(const std::function<bool()>& is_stopped) const {
  RenderOptions options = set_.arguments.render;
  options.is_stopped = is_stopped;
  return pixels_without_emitters(loaded_->scene, *accelerator_, options);
}

std::uint64_t Subject::pixel_count() const {
  const PixelRect window = window_of(set_.arguments.render);
  return std::uint64_t(window.width()) * std::uint64_t(window.height());
}

bool measure(const std::vector<Subject>& subjects, const Rounds& rounds, const Watch& watch,
             Measurement& measurement) {
  measurement.curves = empty_curves(subjects, rounds);
  Progress progress(watch, total_samples(subjects, rounds));
  for (int round = 0; round < rounds.seeds; ++round)
    for (std::size_t number = 0; number < rounds.samples.size(); ++number)
      for (std::size_t i = 0; i < subjects.size(); ++i) {
        const std::uint32_t samples = rounds.samples[number];
        const auto picture =
            progress.render(subjects[i], rounds.first_seed + std::uint64_t(round), samples,
                            fmt::format("{}: {} samples, seed {} of {}", subjects[i].set().name, samples,
                                        round + 1, rounds.seeds));
        if (!picture) return false;
        add(*picture, measurement, measurement.curves[i].points[number]);
      }
  return true;
}

std::optional<ConvergedPicture> render_converged(const Subject& subject, std::uint32_t samples,
                                                 std::uint64_t seed, const Watch& watch) {
  const std::uint32_t half = samples / 2;
  Progress progress(watch, 2 * half * subject.pixel_count());
  std::vector<Image> halves;
  for (const std::uint64_t one : {seed, seed + 1}) {
    auto picture = progress.render(subject, one, half, fmt::format("reference: 2 x {} samples", half));
    if (!picture) return std::nullopt;
    halves.push_back(std::move(picture->mean));
  }
  return converged_picture(halves[0], halves[1]);
}

}  // namespace twinray::error
