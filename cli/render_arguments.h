// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "accel/engines.h"
#include "core/image.h"
#include "integrators/cost.h"
#include "integrators/path.h"
#include "integrators/render.h"
#include "io/scene_file.h"

namespace twinray {

/// Where the picture is seen from.
enum class View {
  file,   ///< The scene file's camera, or that of a camera settings file.
  whole,  ///< The same direction and field of view, from where the whole scene is seen.
};

enum class IntegratorKind { path, direct, normals, cost };

/// What a render command line asks for.
struct RenderArguments {
  std::string scene;
  std::string output = "twinray.png";
  std::string stats_file;   ///< Empty: none.
  std::string camera_file;  ///< Empty: the scene's own camera.
  View view = View::file;
  std::string environment;  ///< Empty: none.
  LoadOptions load;
  Backend backend = default_backend();
  BuildOptions build;
  /// --accel=check: the engine that is asked for each ray of the bvh as well.
  std::optional<Engine> check_with;
  bool plant_difference = false;  ///< check_with breaks the promise of equal bits, and is held to it.
  IntegratorKind integrator = IntegratorKind::path;
  CostKind cost = CostKind::nodes;  ///< Of the integrator cost; something that the backend counts.
  PathOptions path;
  RenderOptions render;
  ToneCurve tone_curve = ToneCurve::srgb;
  bool quiet = false;
};

/// Reads the words after the program's name (and the subcommand's). None: the help or the version was
/// printed, and that is all. Throws UsageError with the reason.
std::optional<RenderArguments> parse_render_arguments(const std::vector<std::string>& words);

/// One line: how the program is called.
std::string usage_line();

}  // namespace twinray
