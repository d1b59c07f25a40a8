// SPDX-License-Identifier: Apache-2.0
#include "cli/compare/command.h"

#include <fmt/format.h>

#include <memory>

#include "cli/compare/page.h"
#include "cli/compare/table.h"
#include "cli/console.h"
#include "cli/interrupt.h"
#include "cli/outputs.h"
#include "cli/shell_text.h"
#include "io/output_file.h"

namespace twinray {
namespace {

using compare::Comparison;
using compare::Measure;

constexpr Range<double> limits{0, 1e30};

const Choices<Measure>& measures() {
  static const Choices<Measure> all{{"mse", Measure::mse},
                                    {"rmse", Measure::rmse},
                                    {"relative-mse", Measure::relative_mse},
                                    {"flip", Measure::flip}};
  return all;
}

std::string name_of(Measure measure) {
  for (const auto& [name, one] : measures())
    if (one == measure) return name;
  return "";
}

/// The options as they are read.
struct CompareRequest {
  CompareArguments arguments;
  Words limits;
};

void add_options(CLI::App& app, CompareRequest& request) {
  CompareArguments& arguments = request.arguments;
  add_file(app, "PICTURE", arguments.picture, "The picture: .exr, .hdr, .png, .jpg, .pfm, .tga or .webp");
  add_file(app, "REFERENCE", arguments.reference, "What it is compared with, of the same size");
  OptionGroup group(app, "Options");
  group.add_word({"--html", "FILE", "Write a page with a slider, maps and tables"}, arguments.html_file);
  group.add_repeated({"--fail-above", "[MEASURE:]X", "Exit code 1 if mse, or this measure, is above X"},
                     request.limits);
  group.add_flag("-q,--quiet", arguments.quiet, "No table");
}

/// Says which limits are exceeded; whether any is.
bool exceeds_limits(const Comparison& comparison, const std::vector<CompareLimit>& all) {
  bool exceeds = false;
  for (const auto& [measure, most] : all) {
    const double value = value_of(comparison, measure);
    if (value <= most) continue;
    exceeds = true;
    console::write_error(
        fmt::format("{}: {} is {:.4g}, above {:g}\n", console::speaker(), name_of(measure), value, most));
  }
  return exceeds;
}

}  // namespace

CompareLimit parse_limit(const std::string& text) {
  const std::string option = "--fail-above";
  const std::size_t colon = text.find(':');
  if (colon == text.npos) return {Measure::mse, parse_number(option, text, limits)};
  for (const auto& [name, measure] : measures())
    if (text.substr(0, colon) == name) return {measure, parse_number(option, text.substr(colon + 1), limits)};
  throw UsageError(fmt::format("{}: there is no \"{}\"; valid are {}", option, text.substr(0, colon),
                               words_of(measures(), ", ")));
}

std::function<CompareArguments()> add_compare_options(CLI::App& app) {
  const auto request = std::make_shared<CompareRequest>();
  add_options(app, *request);
  return [request] {
    CompareArguments arguments = request->arguments;
    for (const std::string& text : request->limits) arguments.limits.push_back(parse_limit(text));
    return arguments;
  };
}

int compare_command(const CompareArguments& arguments, const Words& words) {
  const std::vector<std::string> outputs = given_names({arguments.html_file});
  const InterruptGuard guard(outputs);
  prepare_outputs(outputs, {arguments.picture, arguments.reference});
  const Comparison comparison = compare::compare(arguments.picture, arguments.reference);
  if (!arguments.html_file.empty())
    write_file(arguments.html_file,
               compare::compare_page(comparison, "twinray compare " + shell_text(words)));
  if (!arguments.quiet) console::write(compare::text_table(comparison));
  return exceeds_limits(comparison, arguments.limits) ? 1 : 0;
}

}  // namespace twinray
