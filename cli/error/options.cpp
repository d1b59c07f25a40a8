// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>

#include "cli/error/command.h"
#include "cli/options/render.h"

namespace twinray {
namespace {

/// Of the largest number of samples: its own error is then a sixteenth of the least one measured.
constexpr std::uint32_t usual_reference_factor = 16;
constexpr Range<int> seed_counts{1, 1000};
constexpr Range<std::uint32_t> reference_counts{2, Film::max_samples};
constexpr Range<double> rmses{1e-9, 1e9};

/// The options as they are read.
struct ErrorRequest {
  ErrorArguments arguments;
  RenderRequest common;
  Words settings;
  std::string samples = "4,16,64", targets = "0.005";
  std::uint32_t reference_samples = 0;  ///< 0: the usual factor.
};

template <typename T>
std::vector<T> parse_list(const std::string& option, const std::string& text, const Range<T>& range) {
  std::vector<T> values;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    values.push_back(parse_number(option, text.substr(begin, end - begin), range));
    begin = end + 1;
  }
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

void add_measured_options(CLI::App& app, ErrorRequest& request) {
  ErrorArguments& arguments = request.arguments;
  OptionGroup group(app, "Measurement");
  group.add_repeated({"--settings", "NAME:OPTIONS",
                      "A set of render's options; again for each other set (those common to all)"},
                     request.settings);
  group.add_word({"-s,--samples", "A,B,...", fmt::format("Samples per pixel ({})", request.samples)},
                 request.samples);
  group.add_number({"--repeats", "N", "Pictures of other seeds for each"}, arguments.rounds.seeds,
                   seed_counts);
  group.add_choice<bool>("--mask", arguments.leaves_out_emitters, {{"emitters", true}, {"none", false}},
                         "Pixels left out: those that see an emitter");
  group.add_word(
      {"--target-rmse", "A,B,...", fmt::format("What each set takes to this error ({})", request.targets)},
      request.targets);
  group.add_word({"--csv", "FILE", "Write the table for other programs"}, arguments.csv_file);
  group.add_word({"--html", "FILE", "Write a page with tables and plots"}, arguments.html_file);
}

void add_reference_options(CLI::App& app, ErrorRequest& request) {
  ErrorArguments& arguments = request.arguments;
  OptionGroup group(app, "Reference: one of the first two is needed");
  group.add_word({"--reference", "FILE", "A converged picture of this frame (.exr)"}, arguments.reference);
  group.add_flag("--converge", arguments.converges, "Render it, by the options common to all sets");
  group.add_words(
      {"--reference-samples", "N",
       fmt::format("Its samples per pixel ({} times the most of --samples)", usual_reference_factor)},
      1, [&request](const Words& words) {
        request.reference_samples = parse_number("--reference-samples", words.front(), reference_counts);
      });
  group.add_word({"--save-reference", "FILE", "Keep it (.exr), and its noise in a second file"},
                 arguments.save_reference);
}

void add_options(CLI::App& app, ErrorRequest& request) {
  add_scene(app, request.common.arguments.scene);
  add_measured_options(app, request);
  add_reference_options(app, request);
  add_frame_options(app, request.common);
  add_light_options(app, request.common);
  add_texture_options(app, request.common);
  add_sampler_options(app, request.common);
  add_engine_options(app, request.common);
  OptionGroup group(app, option_groups::run);
  add_threads(group, request.common.arguments.render.threads);
  group.add_flag("--strict", request.common.arguments.load.strict,
                 "What a scene file or an option says must have an effect");
  group.add_flag("-q,--quiet", request.arguments.quiet, "No table, no progress");
}

void check_reference(const ErrorArguments& arguments, const ErrorRequest& request) {
  if (arguments.reference.empty() == !arguments.converges)
    throw UsageError(arguments.converges
                         ? "--reference and --converge exclude each other"
                         : "a reference is missing: --reference FILE, or --converge to render it");
  if (arguments.converges) return;
  if (!arguments.save_reference.empty()) throw UsageError("--save-reference goes with --converge");
  if (request.reference_samples > 0) throw UsageError("--reference-samples goes with --converge");
}

void read_sets(const RenderRequest& common, const Words& given, const Words& settings,
               ErrorArguments& arguments) {
  arguments.common = {.name = "default", .options = {}, .arguments = {}};
  error::read_options(common, given, arguments.common);
  for (const std::string& text : settings) {
    error::OptionSet set = error::parse_option_set(text);
    for (const error::OptionSet& other : arguments.sets)
      if (other.name == set.name)
        throw UsageError(fmt::format("--settings: two sets are called {}", set.name));
    error::read_options(common, given, set);
    arguments.sets.push_back(std::move(set));
  }
  if (arguments.sets.empty()) arguments.sets.push_back(arguments.common);
  for (const error::OptionSet& set : arguments.sets) {
    if (set.arguments.check_with) throw UsageError("--accel=check goes with render; error takes one engine");
    if (set.arguments.convert_textures)
      throw UsageError("--convert-textures goes with render; what renders nothing has no error");
  }
}

std::uint32_t usual_reference_samples(std::uint32_t most) {
  return std::min(usual_reference_factor * most, Film::max_samples);  // 2^26 at most
}

/// Both halves have as many; the most possible is even.
std::uint32_t rounded_up_to_even(std::uint32_t samples) { return samples + samples % 2; }

ErrorArguments resolved(const ErrorRequest& request, const Words& given) {
  ErrorArguments arguments = request.arguments;
  arguments.rounds.samples = parse_list("--samples", request.samples, sample_counts);
  arguments.targets = parse_list("--target-rmse", request.targets, rmses);
  const std::uint32_t most = arguments.rounds.samples.back();
  RenderRequest common = request.common;
  common.arguments.render.samples = most;
  read_sets(common, given, request.settings, arguments);
  check_reference(arguments, request);
  arguments.rounds.first_seed = arguments.common.arguments.render.seed;
  arguments.reference_samples = rounded_up_to_even(
      request.reference_samples > 0 ? request.reference_samples : usual_reference_samples(most));
  return arguments;
}

}  // namespace

std::function<ErrorArguments()> add_error_options(CLI::App& app) {
  const auto request = std::make_shared<ErrorRequest>();
  add_options(app, *request);
  return [request, &app] { return resolved(*request, given_options(app)); };
}

}  // namespace twinray
