// SPDX-License-Identifier: Apache-2.0
#include "cli/cs184/options.h"

#include <CLI/CLI.hpp>
#include <limits>
#include <memory>

#include "cli/no_effect.h"
#include "cli/options/render.h"
#include "cli/render_command_line.h"
#include "cli/version.h"
#include "io/cs184/picture.h"

namespace twinray {
namespace {

constexpr Range<int> any_depth{0, std::numeric_limits<int>::max()};
constexpr Range<int> cell_numbers{0, 65536};
constexpr Range<std::uint32_t> batches{1, Film::max_samples};
constexpr Range<double> tolerances{0, 1e6}, lens_lengths{0, 1e9};
constexpr int most_bounces = 100;

/// A command line of CS184's program.
struct Cs184Request {
  RenderRequest render;
  std::vector<int> cell;  ///< -p: X Y DX DY, from the bottom left pixel; empty: the whole frame.
  Words adaptive{"32", "0.05"};
  bool accumulates = true;  ///< -o
  double lens_radius = 0, focal_distance = 4.7;

  Cs184Request() {
    RenderArguments& arguments = render.arguments;
    arguments.load.interpretation = Interpretation::cs184;
    arguments.quiet = true;
    arguments.output.clear();
    arguments.render.width = 800;
    arguments.render.height = 600;
    arguments.render.samples = 1;
    arguments.render.threads = 1;
    arguments.render.counting = true;
    arguments.path.max_depth = 1;
    arguments.path.direct = DirectMethod::lights;
    arguments.path.many_lights = ManyLights::all;
    render.roulette = "0.7";
    render.accel = "bvh";
  }
};

void add_sampling_letters(OptionGroup& group, Cs184Request& request) {
  RenderArguments& arguments = request.render.arguments;
  group.add_number({"-s", "INT", ""}, arguments.render.samples, sample_counts);
  group.add_number({"-l", "INT", ""}, arguments.path.samples_per_light, light_sample_counts);
  group.add_number({"-t", "INT", ""}, arguments.render.threads, thread_counts);
  group.add_words({"-a", "INT FLOAT", ""}, 2, [&request](const Words& words) { request.adaptive = words; });
  group.add_flag("-H", request.render.hemisphere, "");
}

void add_bounce_letters(OptionGroup& group, Cs184Request& request) {
  group.add_number({"-m", "INT", ""}, request.render.arguments.path.max_depth, any_depth);
  group.add_choice<bool>("-o", request.accumulates, {{"0", false}, {"1", true}}, "");
}

void add_picture_letters(OptionGroup& group, Cs184Request& request) {
  RenderArguments& arguments = request.render.arguments;
  group.add_pair({"-r", "INT INT", ""}, arguments.render.width, arguments.render.height, frame_sides);
  group.add_numbers({"-p", "INT INT INT INT", ""}, 4, request.cell, cell_numbers);
  group.add_number({"-b", "FLOAT", ""}, request.lens_radius, lens_lengths);
  group.add_number({"-d", "FLOAT", ""}, request.focal_distance, lens_lengths);
  group.add_word({"-c", "PATH", ""}, arguments.camera_file);
  group.add_word({"-e", "PATH", ""}, arguments.environment);
  group.add_word({"-f", "FILENAME", ""}, arguments.output);
}

void add_options(CLI::App& app, Cs184Request& request) {
  app.set_version_flag("--version", version_text());
  add_scene(app, request.render.arguments.scene);
  OptionGroup group(app, "CS184");
  add_sampling_letters(group, request);
  add_bounce_letters(group, request);
  add_picture_letters(group, request);
  add_light_words(app, request.render);
  add_sampling_words(app, request.render);
  add_engine_options(app, request.render);
  add_replay_options(app, request.render);
  add_run_words(app, request.render);
}

PixelRect window_of(const std::vector<int>& cell, int width, int height) {
  const int x = cell[0], y = cell[1], w = cell[2], h = cell[3];
  if (w < 1 || h < 1 || w > width || h > height || x > width - w || y > height - h)
    throw UsageError(fmt::format("-p: {} {} {} {} (X Y DX DY) is not a part of {} x {} pixels", x, y, w, h,
                                 width, height));
  return cs184_cell(x, y, w, h, height);
}

void resolve_adaptive(const Cs184Request& request, RenderArguments& arguments) {
  AdaptiveSampling& adaptive = arguments.render.adaptive.emplace();
  adaptive.batch = parse_number("-a", request.adaptive[0], batches);
  adaptive.tolerance = parse_number("-a", request.adaptive[1], tolerances);
  adaptive.rule = request.render.adaptive_rule.value_or(AdaptiveRule::cs184);
}

void resolve_lens(const Cs184Request& request, RenderArguments& arguments) {
  if (request.lens_radius > 0 && !(request.focal_distance > 0))
    throw UsageError("-d: behind a lens (-b) something is in focus at a distance greater than 0 only");
  arguments.changes.lens = Lens{float(request.lens_radius), float(request.focal_distance)};
}

/// Paths of CS184's program may have any depth. Beyond the most bounces nothing is left: roulette at 0.7 lets
/// one path in 10^15 come so far.
std::string shorten_paths(PathOptions& path) {
  if (path.max_depth <= most_bounces) return "";
  const int asked = std::exchange(path.max_depth, most_bounces);
  return fmt::format("-m: paths end after {} bounces, not after {}", most_bounces, asked);
}

RenderArguments resolved(const Cs184Request& asked, const Words& given) {
  RenderRequest request = asked.render;
  const std::string shorter = shorten_paths(request.arguments.path);
  RenderArguments arguments = request.arguments;
  arguments.given = given;
  if (!asked.accumulates && is_given("--bounces", arguments))
    throw UsageError("-o 0 is --bounces=last, and --bounces says it, too, or another thing");
  if (!asked.accumulates) request.bounces = RenderRequest::Bounces::last;
  resolve_picture(arguments);
  if (!asked.cell.empty())
    arguments.render.window = window_of(asked.cell, arguments.render.width, arguments.render.height);
  resolve_adaptive(asked, arguments);
  resolve_lens(asked, arguments);
  resolve_light(request, arguments);
  arguments.load.surfaces_only = arguments.integrator == IntegratorKind::normals;
  // Who leaves the choice of the engine to the program wants the fastest one.
  if (request.accel == "auto") arguments.render.counting = false;
  resolve_engine(request, arguments);
  resolve_replay(request, arguments);
  resolve_run(request, arguments);
  arguments.without_effect = options_without_effect(request, arguments);
  if (!shorter.empty()) arguments.without_effect.push_back(shorter);
  refuse_if_strict(arguments.without_effect, arguments);
  return arguments;
}

std::function<RenderArguments()> add_cs184_options(CLI::App& app) {
  const auto request = std::make_shared<Cs184Request>();
  add_options(app, *request);
  return [request, &app] { return resolved(*request, given_options(app)); };
}

}  // namespace

RenderArguments parse_cs184_arguments(const Words& words) {
  return parse_alone<RenderArguments>(add_cs184_options, words);
}

std::string cs184_usage(const std::string& path) {
  return fmt::format(
      "Usage: {} [options] <scenefile>\n"
      "Program Options:\n"
      "  -s  <INT>        Number of camera rays per pixel\n"
      "  -l  <INT>        Number of samples per area light\n"
      "  -t  <INT>        Number of render threads\n"
      "  -m  <INT>        Maximum ray depth\n"
      "  -o  <INT>        Accumulate Bounces of Light \n"
      "  -e  <PATH>       Path to environment map\n"
      "  -b  <FLOAT>      The size of the aperture\n"
      "  -d  <FLOAT>      The focal distance\n"
      "  -f  <FILENAME>   Image (.png) file to save output to in windowless mode\n"
      "  -r  <INT> <INT>  Width and height of output image (if windowless)\n"
      "  -a  <INT> <FLOAT>  Samples per batch and tolerance of adaptive sampling\n"
      "  -p  <INT> <INT> <INT> <INT>  Cell to render: x y width height, from the bottom left\n"
      "  -c  <PATH>       Path to camera settings file\n"
      "  -H               Sample direct light by directions of the hemisphere\n"
      "  -h               Print this help message\n"
      "  --accel=NAME, --integrator=normals and other long options of twinray, for light, engines, "
      "--sampler,\n"
      "  --seed, --adaptive-rule, --replay, --stats, --tev, --instances and --strict\n"
      "\n",
      path);
}

}  // namespace twinray
