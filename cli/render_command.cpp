// SPDX-License-Identifier: Apache-2.0
#include "cli/render_command.h"

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <thread>
#include <utility>

#include "cli/console.h"
#include "cli/denoising.h"
#include "cli/engine_check.h"
#include "cli/interrupt.h"
#include "cli/live/live_picture.h"
#include "cli/live/picture_viewers.h"
#include "cli/moving_scene.h"
#include "cli/options/limits.h"
#include "cli/outputs.h"
#include "cli/partial_picture.h"
#include "cli/picture_metadata.h"
#include "cli/render_keeping.h"
#include "cli/render_outputs.h"
#include "cli/render_scene.h"
#include "cli/render_talk.h"
#include "cli/replay/command.h"
#include "cli/resources.h"
#include "cli/sandbox/render_sandbox.h"
#include "cli/statistics_report.h"
#include "cli/status/status_talk.h"
#include "cli/texture_command.h"
#include "core/error.h"
#include "core/memory.h"
#include "io/destination.h"
#include "io/output_file.h"
#include "io/picture/image_codec.h"
#include "io/picture/image_file.h"

namespace twinray {
namespace {

int list_cameras(const RenderArguments& arguments) {
  LoadOptions options = arguments.load;
  options.camera_name.clear();
  const SceneSummary summary = load_with_warnings(arguments.scene, options).summary;
  if (summary.cameras.empty()) console::print("no camera in the file; a default one sees the whole scene\n");
  for (const std::string& name : summary.cameras)
    console::print("{}{}\n", name, name == summary.camera ? " (makes the picture)" : "");
  return 0;
}

/// What a command line may write. Of a list of cameras, nothing.
std::vector<std::string> written_files(const RenderArguments& arguments) {
  if (arguments.load.camera_name == "?") return {};
  if (arguments.replay) return given_names({arguments.replay->json_file, arguments.replay->obj_file});
  const RenderOutputs outputs = render_outputs(arguments);
  return all_names({outputs, partial_outputs(outputs)});
}

/// Before anything of the scene is read.
void protect_the_machine(const RenderArguments& arguments, RenderTalk& talk) {
  limit_process(arguments.limits);
  if (arguments.sandbox)
    talk.note("sandbox: " + enter_sandbox(needs_of_render(arguments, written_files(arguments))));
}

/// Throws Error where what else a render writes, or leaves when it is stopped, would replace its checkpoint,
/// or what that is while it is written.
void check_checkpoint_stays(RenderOutputs outputs, const RenderOutputs& partial) {
  const std::string checkpoint = std::exchange(outputs.checkpoint, "");
  if (checkpoint.empty()) return;
  for (const std::string& place : {checkpoint, earlier_film_name(checkpoint)})
    for (const std::string& name : all_names({outputs, partial}))
      if (is_same_place(destination_of(place), destination_of(name)))
        throw Error(fmt::format("--checkpoint={}: {} would be written there, too; choose another name",
                                checkpoint, name));
}

/// One render, step by step.
class RenderRun {
 public:
  /// From then on signals do what InterruptGuard says.
  RenderRun(const RenderArguments& arguments, const Words& words, RenderTalk& talk)
      : arguments_(arguments),
        words_(words),
        talk_(talk),
        outputs_(render_outputs(arguments)),
        partial_(partial_outputs(outputs_)),
        guard_(all_names({outputs_, partial_}), arguments.checkpoint.empty() ? 0 : try_again_code) {}

  /// What can be known before the scene is read.
  void prepare() {
    check_memory(memory_needs(arguments_.render));
    prepare_outputs(outputs_.names(), {arguments_.scene, arguments_.environment, arguments_.camera_file});
    check_checkpoint_stays(outputs_, partial_);
    if (!arguments_.checkpoint.empty()) check_films_alone_are_replaced(arguments_.checkpoint);
    if (arguments_.denoiser) use_denoiser(*arguments_.denoiser);
    arguments_.load.files = std::make_shared<std::vector<std::string>>();
    if (const std::string fewer = thread_warning(arguments_.render.threads); !fewer.empty())
      console::warn(fewer);
    if (const std::string late = clock_warning(arguments_); !late.empty()) console::warn(late);
    if (codec_reads(arguments_.environment) || (makes_picture() && codec_writes(outputs_.picture)))
      codec_loader_ = load_image_codec_early();
  }

  /// The exit code.
  int run() {
    LivePicture live(picture_viewers(arguments_, outputs_, partial_));
    const LoadedScene loaded = load();
    const InputFiles inputs = input_files(arguments_);
    notes_ = picture_notes(arguments_, words_, loaded.scene, inputs);
    RenderKeeping keeping(arguments_, partial_, notes_, talk_, request_);
    if (uses_films(arguments_)) {
      keeping.use_films(words_, inputs);
      notes_ = keeping.films()->picture();
    }
    const auto integrator = make_integrator(arguments_, loaded.scene);
    talk_.building(arguments_, *loaded.scene.geometry);
    const auto accelerator = build_accelerator(arguments_.backend, loaded.scene.geometry, arguments_.build);
    talk_.built(accelerator->stats());
    if (arguments_.check_with) check_.emplace(arguments_, loaded.scene, *accelerator);
    if (arguments_.shutter) arguments_.render.motion = moving_.emplace(arguments_, loaded).motion();
    const RenderResult rendered = render({loaded.scene, *accelerator, *integrator}, keeping, live);
    const int code = rendered.is_complete ? finish(rendered, *accelerator, keeping)
                                          : stopped_in_samples(rendered, keeping);
    live.finish();
    return code;
  }

 private:
  struct Job {
    const Scene& scene;
    const Accelerator& accelerator;
    const Integrator& integrator;
  };

  bool makes_picture() const { return outputs_.film.empty(); }

  void use_denoiser(DenoiserKind kind) {
    denoising_.emplace(kind, arguments_.render.threads);
    arguments_.render.estimated_error = [this](const HalfFilms& halves) {
      return denoising_->estimated_error(halves);
    };
  }

  LoadedScene load() {
    LoadedScene loaded = load_for_render(arguments_, talk_);
    check_not_read(outputs_.names(), *arguments_.load.files);
    choose_engine(*loaded.scene.geometry, arguments_);
    check_memory(memory_needs(arguments_, loaded.scene));
    check_samples_for_denoising(arguments_);
    return loaded;
  }

  /// Where something is kept the first interruption ends the work, and not the program.
  void heed_stops(const LivePicture& live) {
    stop_.emplace();
    arguments_.render.is_stopped = [this, &live] {
      if (live.asks_to_stop()) stop_->make();
      return stop_->is_made();
    };
  }

  RenderResult render(const Job& job, RenderKeeping& keeping, LivePicture& live) {
    heed_the_clock(arguments_);
    if (keeping.keeps_something()) heed_stops(live);
    RenderOptions options = keeping.resting(check_ ? check_->observed(arguments_.render) : arguments_.render);
    const std::vector<LiveLayer> more = check_ ? std::vector{check_->layer()} : std::vector<LiveLayer>{};
    options = live.watching(std::move(options), job.scene, more);
    talk_.rendering();
    RenderResult result = twinray::render(job.scene, job.accelerator, job.integrator, options,
                                          [&](const RenderProgress& progress) {
                                            talk_.progress(progress);
                                            live.progress(progress);
                                          });
    live.show_last(result);
    if (result.is_complete) talk_.rendered(result);
    return result;
  }

  /// False where it is stopped.
  bool denoise(const RenderResult& result) {
    denoised_ = denoising_->denoise(*result.halves, arguments_.render.is_stopped);
    if (!denoised_) return false;
    talk_.denoised(*denoised_);
    set_value(notes_.metadata, "twinray:denoiser", denoised_->denoiser);
    return true;
  }

  /// The exit code.
  int stopped_in_samples(const RenderResult& result, RenderKeeping& keeping) {
    talk_.stopped();
    keeping.save_last(result);
    return keeping.interrupted(result, *stop_, "");
  }

  /// All samples are there, and saved; the exit code.
  int stopped_in_denoising(const RenderResult& result, RenderKeeping& keeping) {
    talk_.stopped();
    return keeping.interrupted(result, *stop_, " while it was denoised");
  }

  void write(const RenderResult& result, RenderKeeping& keeping) {
    talk_.saving();
    if (makes_picture())
      write_pictures(outputs_, arguments_, {result.film, denoised_ ? &*denoised_ : nullptr}, notes_);
    else
      keeping.films()->write(outputs_.film, result, true);
    if (!outputs_.differences.empty())
      write_image(outputs_.differences, check_->picture(mean_image(result.film)),
                  metadata_showing("differences", notes_));
    talk_.saved();
  }

  /// From the samples to all that is asked for; the exit code.
  int finish(const RenderResult& result, const Accelerator& accelerator, RenderKeeping& keeping) {
    const bool is_saved = keeping.save_last(result);
    if (is_open_ended(arguments_.render)) {
      arguments_.render.samples = result.samples;
      set_value(notes_.metadata, "twinray:samples", fmt::format("{}", result.samples));
    }
    if (denoising_ && makes_picture() && !denoise(result)) return stopped_in_denoising(result, keeping);
    if (const std::string rejected = rejection_text(result.film, arguments_); !rejected.empty())
      console::warn(rejected);
    if (const std::string unread = unread_tiles_text(arguments_); !unread.empty()) console::warn(unread);
    std::optional<SceneCrosscheck> found;
    if (check_) found = check_->found(result.seconds);
    write(result, keeping);
    if (!outputs_.statistics.empty())
      write_file(outputs_.statistics,
                 statistics_json(arguments_, accelerator.stats(), result,
                                 {found ? check_->json(*found) : "", denoised_ ? &*denoised_ : nullptr}));
    talk_.finished(arguments_, accelerator.stats(), result);
    if (stop_ && stop_->is_made())
      console::print_error("{}: {} once all samples were there: all outputs are written\n",
                           console::speaker(), stop_->text());
    const int found_code = check_ ? check_->report(*found, outputs_.differences) : 0;
    return is_saved ? found_code : 1;
  }

  RenderArguments arguments_;
  const Words& words_;
  RenderTalk& talk_;
  const RenderOutputs outputs_, partial_;
  const InterruptGuard guard_;
  std::optional<StopRequest> stop_;
  PictureRequest request_;
  std::jthread codec_loader_;
  std::optional<Denoising> denoising_;
  PictureNotes notes_;
  std::optional<EngineCheck> check_;
  std::optional<MovingScene> moving_;
  std::optional<DenoisedPicture> denoised_;
};

bool renders(const RenderArguments& arguments) {
  return arguments.load.camera_name != "?" && !arguments.convert_textures && !arguments.replay;
}

int render_picture(const RenderArguments& arguments, const Words& words, RenderTalk& talk) {
  RenderRun run(arguments, words, talk);
  protect_the_machine(arguments, talk);
  for (const std::string& warning : arguments.without_effect) console::warn(warning);
  run.prepare();
  return run.run();
}

/// What else the options of a render ask for.
int answer(const RenderArguments& arguments, RenderTalk& talk) {
  protect_the_machine(arguments, talk);
  if (arguments.load.camera_name == "?") return list_cameras(arguments);
  for (const std::string& warning : arguments.without_effect) console::warn(warning);
  if (arguments.convert_textures) return convert_textures(arguments);
  return replay_command(arguments);
}

}  // namespace

int render_command(const RenderArguments& arguments, const std::vector<std::string>& words,
                   RenderTalk& talk) {
  if (!renders(arguments)) return answer(arguments, talk);
  std::vector<std::unique_ptr<StatusReporter>> reporters = status_reporters(arguments);
  if (reporters.empty()) return render_picture(arguments, words, talk);
  StatusTalk reporting(talk, std::move(reporters));
  return render_picture(arguments, words, reporting);
}

int render_command(const RenderArguments& arguments, const std::vector<std::string>& words) {
  const std::unique_ptr<RenderTalk> talk =
      arguments.quiet ? std::make_unique<RenderTalk>() : std::make_unique<StandardTalk>(arguments.progress);
  return render_command(arguments, words, *talk);
}

}  // namespace twinray
