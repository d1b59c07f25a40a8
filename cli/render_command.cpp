// SPDX-License-Identifier: Apache-2.0
#include "cli/render_command.h"

#include <fmt/format.h>

#include <memory>

#include "check/render_check.h"
#include "cli/console.h"
#include "cli/crosscheck_report.h"
#include "cli/denoising.h"
#include "cli/interrupt.h"
#include "cli/live/live_picture.h"
#include "cli/live/picture_viewers.h"
#include "cli/outputs.h"
#include "cli/partial_picture.h"
#include "cli/picture_metadata.h"
#include "cli/render_outputs.h"
#include "cli/render_scene.h"
#include "cli/render_talk.h"
#include "cli/replay_command.h"
#include "cli/resources.h"
#include "cli/statistics_report.h"
#include "cli/texture_command.h"
#include "core/error.h"
#include "core/memory.h"
#include "io/image_codec.h"
#include "io/image_file.h"
#include "io/output_file.h"

namespace twinray {
namespace {

/// The other engine of --accel=check, and what is found.
class Check {
 public:
  Check(const RenderArguments& arguments, const Scene& scene, const Accelerator& accelerator)
      : other_(build_accelerator(arguments.check_with->backend, scene.geometry, arguments.check_with->build)),
        names_{backend_name(arguments.backend), arguments.check_with->name},
        account_(scene.geometry, {.name = names_[0], .accelerator = &accelerator},
                 {.name = names_[1],
                  .accelerator = other_.get(),
                  .is_canonical = arguments.plant_difference || arguments.check_with->is_canonical()},
                 arguments.render) {}

  /// The options of a render whose rays come here.
  RenderOptions observed(RenderOptions options) {
    options.observe = [this](const PixelSample& sample, std::span<const RecordedRay> rays) {
      account_.observe(sample, rays);
    };
    return options;
  }
  Image picture(const Image& rendered) const { return account_.picture(rendered); }
  SceneCrosscheck found(double seconds) const { return {names_, account_.report(), seconds}; }
  /// "camera ray of pixel 3 4, sample 5"
  std::string label(const Finding& finding) const {
    const PixelSample sample = account_.sample_of(finding);
    return fmt::format("{} ray of pixel {} {}, sample {}", ray_class_name(finding.ray_class), sample.x,
                       sample.y, sample.index);
  }

 private:
  std::unique_ptr<const Accelerator> other_;
  std::vector<std::string> names_;
  RenderCheck account_;
};

struct RenderJob {
  const Scene& scene;
  const Accelerator& accelerator;
  const Integrator& integrator;
};

/// Those who are told of a render while it goes on.
struct Audience {
  RenderTalk& talk;
  LivePicture& live;
};

struct Rendered {
  RenderResult result;
  int stop_code = 0;  ///< Where it was stopped: the program's exit code.
};

/// Where there is a place for a partial picture the first interruption ends the render, not the program.
Rendered render_stoppably(const RenderJob& job, RenderOptions options, const RenderOutputs& partial,
                          const Audience& audience) {
  std::optional<StopRequest> stop;
  if (!partial.picture.empty()) {
    stop.emplace();
    options.is_stopped = [&] {
      if (audience.live.asks_to_stop()) stop->make();
      return stop->is_made();
    };
  }
  audience.talk.rendering();
  RenderResult result =
      render(job.scene, job.accelerator, job.integrator,
             audience.live.watching(std::move(options), job.scene), [&](const RenderProgress& progress) {
               audience.talk.progress(progress);
               audience.live.progress(progress);
             });
  audience.live.show_last(result);
  const int stop_code = result.is_complete ? 0 : stop->exit_code();
  if (stop_code == 0)
    audience.talk.rendered(result);
  else
    audience.talk.stopped();
  return {std::move(result), stop_code};
}

std::string check_json(const RenderArguments& arguments, const SceneCrosscheck& found) {
  return crosscheck_json(found, arguments.scene, replay_command(arguments.scene, arguments.load),
                         Ceilings::remark);
}

/// Prints the table, and what is wrong; the exit code.
int report(const Check& check, const SceneCrosscheck& found, const RenderArguments& arguments,
           const std::string& differences) {
  const bool is_good = is_passed(found.report, Ceilings::remark);
  if (!arguments.quiet && !differences.empty()) console::print("Differences    {}\n\n", differences);
  if (!arguments.quiet || !is_good)
    console::write(crosscheck_text(found, replay_command(arguments.scene, arguments.load), Ceilings::remark,
                                   [&](const Finding& finding) { return check.label(finding); }));
  return is_good ? 0 : 1;
}

int list_cameras(const RenderArguments& arguments) {
  LoadOptions options = arguments.load;
  options.camera_name.clear();
  const SceneSummary summary = load_with_warnings(arguments.scene, options).summary;
  if (summary.cameras.empty()) console::print("no camera in the file; a default one sees the whole scene\n");
  for (const std::string& name : summary.cameras)
    console::print("{}{}\n", name, name == summary.camera ? " (makes the picture)" : "");
  return 0;
}

}  // namespace

int render_command(const RenderArguments& asked, const std::vector<std::string>& words, RenderTalk& talk) {
  RenderArguments arguments = asked;
  if (asked.load.camera_name == "?") return list_cameras(asked);
  if (asked.convert_textures) return convert_textures(asked);
  for (const std::string& warning : arguments.without_effect) console::warn(warning);
  if (asked.replay) return replay_command(asked);
  check_memory(memory_needs(arguments.render));
  const RenderOutputs outputs = render_outputs(arguments);
  const RenderOutputs partial = partial_outputs(outputs);
  std::optional<Denoising> denoising;
  if (arguments.denoiser) {
    denoising.emplace(*arguments.denoiser, arguments.render.threads);
    arguments.render.estimated_error = [&](const HalfFilms& halves) {
      return denoising->estimated_error(halves);
    };
  }
  const InterruptGuard guard(all_names({outputs, partial}));
  prepare_outputs(outputs.names());
  LivePicture live(picture_viewers(arguments, outputs, partial));
  if (const std::string fewer = thread_warning(arguments.render.threads); !fewer.empty())
    console::warn(fewer);
  if (!arguments.environment.empty() || output_format(outputs.picture) != OutputFormat::png)
    load_image_codec_early();
  const LoadedScene loaded = load_for_render(arguments, talk);
  choose_engine(*loaded.scene.geometry, arguments);
  check_memory(memory_needs(arguments, loaded.scene));
  check_samples_for_denoising(arguments);
  PictureNotes notes = picture_notes(arguments, words, loaded.scene);
  const auto integrator = make_integrator(arguments, loaded.scene);
  talk.building(arguments, *loaded.scene.geometry);
  const auto accelerator = build_accelerator(arguments.backend, loaded.scene.geometry, arguments.build);
  talk.built(accelerator->stats());
  std::optional<Check> check;
  if (arguments.check_with) check.emplace(arguments, loaded.scene, *accelerator);

  const auto [result, stop_code] =
      render_stoppably({loaded.scene, *accelerator, *integrator},
                       check ? check->observed(arguments.render) : arguments.render, partial, {talk, live});
  if (stop_code != 0) {
    console::write_error(write_partial(partial, arguments, result.film, notes));
    live.finish();
    return stop_code;
  }
  if (is_open_ended(arguments.render)) {
    arguments.render.samples = result.samples;
    notes = picture_notes(arguments, words, loaded.scene);
  }
  std::optional<DenoisedPicture> denoised;
  if (denoising) {
    denoised = denoising->denoise(*result.halves);
    talk.denoised(*denoised);
    notes.metadata.emplace_back("twinray:denoiser", denoised->denoiser);
  }
  if (const std::string rejected = rejection_text(result.film, arguments); !rejected.empty())
    console::warn(rejected);
  if (const std::string unread = unread_tiles_text(arguments); !unread.empty()) console::warn(unread);
  std::optional<SceneCrosscheck> found;
  if (check) found = check->found(result.seconds);
  talk.saving();
  write_pictures(outputs, arguments, {result.film, denoised ? &*denoised : nullptr}, notes);
  if (!outputs.differences.empty())
    write_image(outputs.differences, check->picture(mean_image(result.film)), notes.metadata);
  talk.saved();
  if (!outputs.statistics.empty())
    write_file(outputs.statistics, statistics_json(arguments, accelerator->stats(), result,
                                                   {found ? check_json(arguments, *found) : "",
                                                    denoised ? &*denoised : nullptr}));
  talk.finished(arguments, accelerator->stats(), result);
  live.finish();
  return check ? report(*check, *found, arguments, outputs.differences) : 0;
}

int render_command(const RenderArguments& arguments, const std::vector<std::string>& words) {
  const std::unique_ptr<RenderTalk> talk =
      arguments.quiet ? std::make_unique<RenderTalk>() : std::make_unique<StandardTalk>();
  return render_command(arguments, words, *talk);
}

}  // namespace twinray
