// SPDX-License-Identifier: Apache-2.0
#include "cli/error/command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/console.h"
#include "cli/error/page.h"
#include "cli/error/reference_file.h"
#include "cli/error/tables.h"
#include "cli/interrupt.h"
#include "cli/outputs.h"
#include "cli/picture_metadata.h"
#include "cli/progress.h"
#include "cli/resources.h"
#include "cli/shell_text.h"
#include "io/destination.h"
#include "io/output_file.h"
#include "io/picture/image_codec.h"

namespace twinray {
namespace {

using error::Measurement;
using error::Subject;

/// The reference's seed is that far from those of the pictures that are compared with it.
constexpr std::uint64_t reference_seed_offset = 1'000'000;

struct OutputNames {
  std::string csv, html;
};

/// What there is after an interruption goes beside the files that it does not complete.
OutputNames partial_names(const OutputNames& names) {
  const auto partial = [](const std::string& name) {
    return !name.empty() && destination_of(name).kind == Destination::Kind::file ? partial_name(name) : "";
  };
  return {partial(names.csv), partial(names.html)};
}

FramePart frame_part(const RenderOptions& options) {
  return {window_of(options), options.width, options.height};
}

/// Beside one picture at a time: what is kept of each pixel.
std::vector<MemoryNeed> memory_needs(const ErrorArguments& arguments) {
  std::vector<MemoryNeed> needs = memory_needs(arguments.common.arguments.render);
  const PixelRect window = window_of(arguments.common.arguments.render);
  const std::uint64_t points = arguments.sets.size() * arguments.rounds.samples.size();
  const std::uint64_t pixels = std::uint64_t(window.width()) * std::uint64_t(window.height());
  needs.push_back({fmt::format("means and variances for {} points of curves", points), 16 * points * pixels});
  return needs;
}

/// One error command: its subjects, what it says while it works, and what it leaves.
class ErrorRun {
 public:
  ErrorRun(const ErrorArguments& arguments, const Words& words)
      : arguments_(arguments),
        words_(words),
        names_{arguments.csv_file, arguments.html_file},
        partial_(partial_names(names_)),
        guard_(all_outputs()),
        line_(progress_line(!arguments.quiet)) {}

  int run() {
    if (!arguments_.save_reference.empty()) error::check_reference_name(arguments_.save_reference);
    prepare_outputs(given_names({names_.csv, names_.html, arguments_.save_reference, saved_noise()}),
                    {arguments_.common.arguments.scene, arguments_.reference});
    check_memory(memory_needs(arguments_));
    warn_of_options();
    if (codec_reads(arguments_.reference) || codec_writes(arguments_.save_reference))
      codec_loader_ = load_image_codec_early();
    if (!arguments_.converges)
      measurement_.converged =
          error::read_reference(arguments_.reference, frame_part(arguments_.common.arguments.render));
    for (const error::OptionSet& set : arguments_.sets) subjects_.emplace_back(set);
    return measure();
  }

 private:
  std::string saved_noise() const {
    return arguments_.save_reference.empty() ? "" : error::noise_name(arguments_.save_reference);
  }
  std::vector<std::string> all_outputs() const {
    return given_names(
        {names_.csv, names_.html, partial_.csv, partial_.html, arguments_.save_reference, saved_noise()});
  }
  void warn_of_options() const {
    for (const error::OptionSet& set : arguments_.sets)
      for (const std::string& warning : set.arguments.without_effect)
        console::warn(set.options.empty() ? warning : fmt::format("{}: {}", set.name, warning));
    if (const std::string fewer = thread_warning(arguments_.common.arguments.render.threads); !fewer.empty())
      console::warn(fewer);
  }

  int measure() {
    const StopRequest stop;
    const error::Watch watch{[&stop] { return stop.is_made(); },
                             [this](const std::string& doing, std::uint64_t done, std::uint64_t total) {
                               show(doing, done, total);
                             }};
    if (arguments_.converges && !converge(watch)) return stopped(stop);
    measurement_.mask = arguments_.leaves_out_emitters
                            ? subjects_.front().without_emitters(watch.is_stopped)
                            : PixelMask(measurement_.converged.mean.pixels.size(), 1);
    line_ = progress_line(!arguments_.quiet);
    const bool is_complete = error::measure(subjects_, arguments_.rounds, watch, measurement_);
    line_.finish();
    if (!is_complete) return stopped(stop);
    write(names_);
    return 0;
  }

  void show(const std::string& doing, std::uint64_t done, std::uint64_t total) {
    if (!line_.is_due()) return;
    const double part = double(done) / double(total), seconds = line_.elapsed_seconds();
    std::string text = fmt::format("{:3.0f} % | {} | {}", 100 * part, doing, duration_text(seconds));
    if (part > 0.01) text += fmt::format(", {} left", duration_text(seconds * (1 - part) / part));
    line_.show(text);
  }

  /// Renders the reference, and saves it at once. False where it was stopped.
  bool converge(const error::Watch& watch) {
    std::optional<Subject> own;
    const Subject* subject = &subjects_.front();
    if (!subject->set().options.empty()) subject = &own.emplace(arguments_.common);
    auto converged = error::render_converged(*subject, arguments_.reference_samples, reference_seed(), watch);
    line_.finish();
    if (!converged) return false;
    measurement_.converged = std::move(*converged);
    if (!arguments_.save_reference.empty())
      error::write_reference(arguments_.save_reference, measurement_.converged, metadata(*subject), frame());
    return true;
  }
  std::uint64_t reference_seed() const { return arguments_.rounds.first_seed + reference_seed_offset; }
  ImageMetadata metadata(const Subject& subject) const {
    RenderArguments arguments = subject.set().arguments;
    arguments.render.samples = arguments_.reference_samples;
    arguments.render.seed = reference_seed();
    return picture_metadata(arguments, words_);
  }
  ImageFrame frame() const {
    const RenderOptions& options = arguments_.common.arguments.render;
    const PixelRect window = window_of(options);
    return {window.x0, window.y0, options.width, options.height};
  }

  int stopped(const StopRequest& stop) {
    line_.finish();
    if (measurement_.curves.empty() || measurement_.curves.front().points.front().errors.empty()) {
      console::write_error(fmt::format("{}: {} before the first picture; nothing is written\n",
                                       console::speaker(), stop.text()));
      return stop.exit_code();
    }
    write(partial_);
    console::write_error(fmt::format("{}: {}{}\n", console::speaker(), stop.text(), holders()));
    return stop.exit_code();
  }
  /// "; the table, a_partial.csv hold what there is"
  std::string holders() const {
    std::vector<std::string> names = given_names({partial_.csv, partial_.html});
    if (!arguments_.quiet) names.insert(names.begin(), "the table");
    if (names.empty()) return "";
    return fmt::format("; {} {} what there is", fmt::join(names, ", "), names.size() == 1 ? "holds" : "hold");
  }

  void write(const OutputNames& names) const {
    const error::Summary summary = error::summary_of(measurement_, arguments_.targets);
    const Image& picture = measurement_.converged.mean;
    const error::Heading heading{arguments_.common.arguments.scene, picture.width, picture.height,
                                 arguments_.leaves_out_emitters, reference_origin()};
    if (const std::string warning = error::reference_warning(summary); !warning.empty())
      console::warn(warning);
    if (!names.csv.empty()) write_file(names.csv, error::csv_table(summary));
    if (!names.html.empty())
      write_file(names.html, error::error_page(heading, summary, "twinray error " + shell_text(words_)));
    if (!arguments_.quiet) console::write(error::text_table(heading, summary));
  }
  std::string reference_origin() const {
    if (!arguments_.converges) return arguments_.reference;
    return fmt::format("2 x {} samples per pixel, --seed={} and the next", arguments_.reference_samples / 2,
                       reference_seed());
  }

  const ErrorArguments& arguments_;
  const Words& words_;
  OutputNames names_, partial_;
  InterruptGuard guard_;
  std::jthread codec_loader_;
  ProgressLine line_;
  std::vector<Subject> subjects_;
  Measurement measurement_;
};

}  // namespace

int error_command(const ErrorArguments& arguments, const Words& words) {
  return ErrorRun(arguments, words).run();
}

}  // namespace twinray
