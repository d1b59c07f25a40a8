// SPDX-License-Identifier: Apache-2.0
#include "cli/options/render.h"

namespace twinray {
namespace {

constexpr Range<std::uint32_t> places{0, std::uint32_t(frame_sides.most) - 1},
    indices{0, Film::max_samples - 1};

}  // namespace

void add_replay_options(CLI::App& app, RenderRequest& request) {
  OptionGroup group(app, option_groups::run);
  group.add_words({"--replay", "X Y INDEX", "Print the path of one sample of a pixel, and render nothing"}, 3,
                  [&request](const Words& words) {
                    request.replay = {parse_number("--replay", words[0], places),
                                      parse_number("--replay", words[1], places),
                                      parse_number("--replay", words[2], indices)};
                  });
  group.add_word({"--replay-json", "FILE", "Write that path as JSON"}, request.replay_json);
  group.add_word({"--replay-obj", "FILE", "Write it as lines that Blender and MeshLab show"},
                 request.replay_obj);
}

void resolve_replay(const RenderRequest& request, RenderArguments& arguments) {
  if (request.replay.empty()) return;
  if (!traces_paths(arguments.integrator))
    throw UsageError("--replay: --integrator=path, path-reference and direct alone trace paths");
  if (arguments.check_with)
    throw UsageError("--replay asks one engine alone; it does not go with --accel=check");
  const auto& words = request.replay;
  arguments.replay = {{int(words[0]), int(words[1]), words[2]}, request.replay_json, request.replay_obj};
}

}  // namespace twinray
