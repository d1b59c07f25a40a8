// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "accel/engines.h"
#include "cli/camera_changes.h"
#include "cli/clock_time.h"
#include "cli/light_groups.h"
#include "cli/options/common.h"
#include "cli/options/environment.h"
#include "integrators/cost.h"
#include "integrators/path.h"
#include "integrators/render.h"
#include "io/display/display.h"
#include "io/network/network_address.h"
#include "io/picture/layered_image.h"
#include "io/scene_file.h"

namespace twinray {

enum class IntegratorKind { path, path_reference, direct, ambient_occlusion, furnace, normals, cost };
/// As --integrator takes it: "path", "path-reference", ...
std::string integrator_name(IntegratorKind kind);

/// Whether it makes samples of paths, which can be replayed.
inline bool traces_paths(IntegratorKind kind) {
  return kind == IntegratorKind::path || kind == IntegratorKind::path_reference ||
         kind == IntegratorKind::direct;
}

/// What takes the noise out of a picture.
enum class DenoiserKind {
  automatic,           ///< Open Image Denoise where it is found, else our own filter.
  open_image_denoise,  ///< As --denoise takes it: "oidn".
  own,
};

/// What says how far a render is, on standard error.
enum class ProgressKind { line, json, none };

/// The path of one sample, in place of a picture.
struct ReplayRequest {
  PixelSample sample;               ///< Of the full frame.
  std::string json_file, obj_file;  ///< Empty: none.
};

/// Pixels around the frame, on each side.
struct Overscan {
  double amount = 0;
  bool is_percent = false;  ///< Of the frame's width and height, not pixels.
};

/// What a render command line asks for.
/// Whether a soft sky and a light at the camera light the scene (cli/default_light.h).
enum class DefaultLight {
  none,
  if_dark,  ///< Where nothing else does.
  always,   ///< Beside what else does.
};

struct RenderArguments {
  std::string scene;
  std::string output = "twinray.png";
  ExrCompression compression = ExrCompression::zip;
  std::string stats_file;    ///< Empty: none.
  std::string metrics_file;  ///< Empty: none.
  ProgressKind progress = ProgressKind::line;
  std::string camera_file;  ///< Empty: the scene's own camera.
  View view = View::file;
  CameraChanges changes;             ///< Of the camera.
  std::string environment;           ///< Empty: none.
  EnvironmentPlacement placement;    ///< Of the environment.
  bool lenient_environment = false;  ///< Its pixels that are not radiance are black; else they are an error.
  LoadOptions load;
  /// When what moves is seen, in place of one moment; of a scene that is read, as the file has it where no
  /// time is asked for.
  std::optional<Shutter> shutter;
  std::uint32_t samples_per_moment = 0;  ///< While the shutter is open; 0: the scene decides (cli/shutter.h).
  DefaultLight default_light = DefaultLight::none;
  Backend backend = Backend::bvh;
  BuildOptions build;
  bool is_auto = false;       ///< The scene decides about backend and build: choose_engine().
  std::string engine_reason;  ///< Why that engine, in a clause.
  /// --accel=check: the engine that is asked for each ray of the bvh as well.
  std::optional<Engine> check_with;
  bool plant_difference = false;  ///< check_with breaks the promise of equal bits, and is held to it.
  IntegratorKind integrator = IntegratorKind::path;
  CostKind cost = CostKind::nodes;  ///< Of the integrator cost; something that the backend counts.
  /// Of the integrator ambient_occlusion, in scene units.
  double occlusion_distance = std::numeric_limits<double>::infinity();
  PathOptions path;
  /// Of all pictures but those that the scene wants without any; not set: each as the scene file says.
  std::optional<TextureFilter> texture_filter = TextureFilter::stochastic;
  std::optional<std::uint64_t>
      texture_bytes;              ///< Of memory for pictures on surfaces; not set: all there are.
  bool convert_textures = false;  ///< In place of a picture, pictures of surfaces are written in tiles.
  RenderOptions render;
  std::optional<WallTime> until;             ///< It ends by then; render.seconds allows for it.
  Display display;                           ///< Of pictures in formats of 8 bits.
  std::optional<DenoiserKind> denoiser;      ///< Of the picture, if it is to be denoised.
  std::vector<LightGroupRule> light_groups;  ///< Where render.light_groups are asked for.
  std::optional<ReplayRequest> replay;
  std::optional<NetworkAddress> viewer;      ///< tev, which shows the picture as it grows.
  std::optional<NetworkAddress> server;      ///< Where pages of browsers find it.
  std::string checkpoint;                    ///< Where the render is kept while it goes on; empty: nowhere.
  std::optional<double> checkpoint_seconds;  ///< Between two of them, if not the usual time.
  std::string resumed;                       ///< The film to go on with; empty: none.
  std::vector<int> crop;                     ///< X Y W H of render.window, as they were given; empty: none.
  std::optional<Overscan> overscan;
  /// What the process may reach is closed but for the render's files, its libraries and these further places
  /// to be read; not set: all stays open.
  std::optional<std::vector<std::string>> sandbox;
  ProcessLimits limits;
  bool quiet = false;
  std::vector<std::string> given;  ///< The long names of the options that were given.
  std::map<std::string, std::vector<std::string>> given_words;  ///< Their words, by the same names.
  std::vector<std::string> given_defaults;  ///< The names of those whose word is their default.
  std::vector<std::string> without_effect;  ///< Those that change nothing, each with the reason.
};

/// Whether scene and picture are those of CS184's program.
inline bool is_cs184(const RenderArguments& arguments) {
  return arguments.load.interpretation == Interpretation::cs184;
}

/// Whether the bvh runs the triangle test that has bits of its own; other engines have no choice of tests.
inline bool has_other_triangle_test(const RenderArguments& arguments) {
  return !arguments.is_auto && arguments.backend == Backend::bvh &&
         arguments.build.triangle_test == TriangleTest::moller_trumbore;
}
/// Whether the picture is another one with another engine.
inline bool depends_on_engine(const RenderArguments& arguments) {
  return arguments.integrator == IntegratorKind::cost || arguments.backend == Backend::embree_native ||
         has_other_triangle_test(arguments);
}

/// Shortens the seconds that the render has to those that are left until it is to end.
void heed_the_clock(RenderArguments& arguments);
/// That this time is over; empty where it is not.
std::string clock_warning(const RenderArguments& arguments);

/// Whether something else than the number of samples may end the render.
inline bool is_open_ended(const RenderOptions& render) { return render.seconds || render.noise_target; }

/// Whether an option was given, by its long name.
inline bool is_given(const char* option, const RenderArguments& arguments) {
  return std::find(arguments.given.begin(), arguments.given.end(), option) != arguments.given.end();
}

/// Where the scene is to decide: the fastest engine for it, by what benchmarks measured.
void choose_engine(const Geometry& geometry, RenderArguments& arguments);
/// The name of the engine that renders (accel/engines.h).
std::string engine_name(const RenderArguments& arguments);

}  // namespace twinray
