// SPDX-License-Identifier: Apache-2.0
// What a display shows of the light: options for pictures of 8 bits.
#include <cstdlib>

#include "cli/options/render.h"
#include "io/picture/output_format.h"

namespace twinray {
namespace {

constexpr Range<double> stops{-64, 64};
constexpr Range<double> kelvins{least_white_kelvin, most_white_kelvin};

}  // namespace

void add_display_options(CLI::App& app, RenderRequest& request) {
  OptionGroup group(app, option_groups::picture);
  Display& display = request.arguments.display;
  group.add_number({"--exposure", "STOPS", "8-bit pictures: light times 2^STOPS"}, display.exposure_stops,
                   stops);
  group.add_number({"--white-balance", "KELVIN", "8-bit pictures: such a black body's light is white"},
                   display.white_kelvin, kelvins);
  group.add_choice<Tone>("--tone", display.tone, {{"srgb", Tone::srgb}, {"agx", Tone::agx}},
                         "8-bit pictures: as it is up to 1, or as film does");
  group.add_word({"--ocio-view", "VIEW", "8-bit pictures: a view of the configuration of $OCIO"},
                 display.ocio_view);
  group.add_word({"--ocio-display", "NAME", "Its display, if not the first one"}, display.ocio_display);
}

void resolve_display(const RenderArguments& arguments) {
  const Display& display = arguments.display;
  if (display.ocio_view.empty()) {
    if (!display.ocio_display.empty()) throw UsageError("--ocio-display goes with --ocio-view");
    return;
  }
  if (is_given("--tone", arguments)) throw UsageError("--tone and --ocio-view exclude each other");
  const char* const configuration = std::getenv("OCIO");
  if (!configuration || !*configuration)
    throw UsageError("--ocio-view: the environment variable OCIO names no configuration of OpenColorIO");
}

}  // namespace twinray
