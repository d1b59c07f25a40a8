// SPDX-License-Identifier: Apache-2.0
#include "cli/replay/command.h"

#include "cli/console.h"
#include "cli/interrupt.h"
#include "cli/moving_scene.h"
#include "cli/outputs.h"
#include "cli/render_scene.h"
#include "cli/replay/lines.h"
#include "cli/replay/report.h"
#include "cli/replay/text.h"
#include "integrators/replay.h"
#include "io/obj/lines.h"
#include "io/output_file.h"

namespace twinray {
namespace {

/// Throws UsageError unless the picture has this sample: once its size is known, which the scene may state.
void check_sample(const PixelSample& sample, const RenderOptions& render) {
  if (sample.x >= render.width || sample.y >= render.height)
    throw UsageError(
        fmt::format("--replay: pixel {} {} is not in the picture of {} x {} pixels; the last is {} {}",
                    sample.x, sample.y, render.width, render.height, render.width - 1, render.height - 1));
  const bool is_spread = render.allocation == Allocation::error && render.samples > SampleAllocation::pilot;
  const std::uint32_t samples = is_spread ? Film::max_samples : render.samples;  // A pixel may have more.
  if (sample.index >= samples)
    throw UsageError(
        fmt::format("--replay: sample {} is not in the picture: of {} samples a pixel the last is {}",
                    sample.index, samples, samples - 1));
}

void write(const ReplayRequest& asked, const ReplayedSample& replayed) {
  if (!asked.json_file.empty()) write_file(asked.json_file, replay_json(replayed));
  if (!asked.obj_file.empty()) write_file(asked.obj_file, obj_text(replay_lines(replayed)));
}

}  // namespace

int replay_command(const RenderArguments& asked) {
  RenderArguments arguments = asked;
  const ReplayRequest& request = *arguments.replay;
  const std::vector<std::string> outputs = given_names({request.json_file, request.obj_file});
  const InterruptGuard guard(outputs);
  prepare_outputs(outputs, {arguments.scene, arguments.environment, arguments.camera_file});
  arguments.load.files = std::make_shared<std::vector<std::string>>();
  RenderTalk silence;
  const LoadedScene loaded = load_for_render(arguments, silence);
  check_not_read(outputs, *arguments.load.files);
  check_sample(request.sample, arguments.render);
  choose_engine(*loaded.scene.geometry, arguments);
  const auto integrator = make_integrator(arguments, loaded.scene);
  const auto accelerator = build_accelerator(arguments.backend, loaded.scene.geometry, arguments.build);
  MovingScene moving(arguments, loaded);
  const TracedScene seen = arguments.shutter ? moving.of_sample(request.sample.index)
                                             : TracedScene{loaded.scene, *accelerator, *integrator};
  const Replay made = replay(seen, arguments.path, arguments.render, request.sample);
  ReplayedSample replayed{arguments, seen.scene, made};
  if (arguments.shutter) replayed.time = moving.time_of(request.sample.index);
  write(request, replayed);
  if (!arguments.quiet || outputs.empty()) console::write(replay_text(replayed));
  if (same_bits(made.path.sum(), made.radiance)) return 0;
  console::print_error(
      "twinray: the sample that is rendered is not the path's sum: an error of this program\n");
  return 1;
}

}  // namespace twinray
