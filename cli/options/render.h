// SPDX-License-Identifier: Apache-2.0
// The options of a render in groups, one file each. A group reads its words, and once all are read it says
// what they mean together.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "cli/options/options.h"
#include "cli/render_arguments.h"

namespace twinray {

/// What a render's command line says, word by word: options whose values are only understood together with
/// others stand beside the arguments.
struct RenderRequest {
  RenderArguments arguments;
  Words adaptive;  ///< Batch and tolerance; empty: none.
  std::optional<AdaptiveRule> adaptive_rule;
  std::string roulette = "throughput";
  std::string clamp = "off";
  std::string default_light;
  bool hemisphere = false;
  enum class Bounces { all, direct, indirect, last } bounces = Bounces::all;
  std::optional<CostKind> cost;
  std::optional<int> bvh_width;
  std::vector<std::uint32_t> replay;  ///< X Y INDEX; empty: none.
  std::string replay_json, replay_obj;
  std::string accel = "auto";  ///< Or a backend's name, or check.
  std::string check_with;      ///< Empty: the usual one.
  Words light_groups;          ///< NAME=LIGHT,... each.
  std::string tev;             ///< A viewer's address; empty: none.
  std::string serve;           ///< Where the picture is served; empty: nowhere.
  std::string sandbox;         ///< Further places, as PATH has them; empty: there is none.
  std::string denoise;         ///< What is to denoise; empty: nothing.
  bool denoise_light_groups = false;
  bool resume = false;              ///< From the checkpoint, if it is there.
  std::optional<std::uint32_t> of;  ///< Samples of the picture of which a part is rendered.
};

void add_picture_options(CLI::App& app, RenderRequest& request);
void add_display_options(CLI::App& app, RenderRequest& request);
void add_layer_options(CLI::App& app, RenderRequest& request);
void add_denoise_options(CLI::App& app, RenderRequest& request);
void add_light_options(CLI::App& app, RenderRequest& request);
void add_texture_options(CLI::App& app, RenderRequest& request);
void add_sampling_options(CLI::App& app, RenderRequest& request);
void add_engine_options(CLI::App& app, RenderRequest& request);
void add_film_options(CLI::App& app, RenderRequest& request);
void add_run_options(CLI::App& app, RenderRequest& request);
void add_replay_options(CLI::App& app, RenderRequest& request);

// The picture's group but for its file, and that of sampling but for the number of samples.

void add_frame_options(CLI::App& app, RenderRequest& request);
/// Those of the frame that say how the scene is seen.
void add_camera_options(CLI::App& app, RenderRequest& request);
void add_sampler_options(CLI::App& app, RenderRequest& request);

// Of the same groups the options without a letter: CS184's program has others with the letters.

void add_light_words(CLI::App& app, RenderRequest& request);
void add_sampling_words(CLI::App& app, RenderRequest& request);
void add_run_words(CLI::App& app, RenderRequest& request);

// Each throws UsageError where its options contradict each other.

void resolve_picture(RenderArguments& arguments);
void resolve_display(const RenderArguments& arguments);
void resolve_light(const RenderRequest& request, RenderArguments& arguments);
/// After the layers, which may name another file.
void resolve_overscan(const RenderArguments& arguments);
/// After the light, which decides what is known of layers.
void resolve_layers(const RenderRequest& request, RenderArguments& arguments);
void resolve_denoising(const RenderRequest& request, RenderArguments& arguments);
void resolve_sampling(const RenderRequest& request, RenderArguments& arguments);
/// After the others: the engine depends on what is computed. Where the scene decides, it is left to
/// choose_engine().
void resolve_engine(const RenderRequest& request, RenderArguments& arguments);
void resolve_replay(const RenderRequest& request, RenderArguments& arguments);
/// After all that says what a picture is made of.
void resolve_film(const RenderRequest& request, RenderArguments& arguments);
void resolve_run(const RenderRequest& request, RenderArguments& arguments);

/// Takes what a scene file says about its picture, where no option says something else, and the crop of the
/// command line, once the picture's size is known. Throws UsageError where they contradict each other.
void take_defaults(const RenderDefaults& defaults, RenderArguments& arguments);
/// The part of it that concerns the picture's frame, and that of paths.
void take_frame(const RenderDefaults& defaults, RenderArguments& arguments);
void take_depth(int max_depth, RenderArguments& arguments);

/// All of them; `given` are the long names of the options that were given. Throws UsageError, also for an
/// option without effect where these are errors.
RenderArguments resolved_render(const RenderRequest& request, const Words& given);

}  // namespace twinray
