// SPDX-License-Identifier: Apache-2.0
#include "integrators/path_options.h"

#include <fmt/format.h>

#include "core/error.h"

namespace twinray {

void check(const PathOptions& options) {
  if (options.max_depth < 0 || options.max_depth > 100)
    throw Error(fmt::format("the maximum depth is {}; it must lie in [0, 100]", options.max_depth));
  for (const int limit : {options.limits.diffuse, options.limits.glossy, options.limits.transmission})
    if (limit < 0 || limit > BounceLimits::most)
      throw Error(fmt::format("a limit of {} bounces; it must lie in [0, {}]", limit, BounceLimits::most));
  if (options.samples_per_light < 1 || options.samples_per_light > 65536)
    throw Error(fmt::format("{} samples per light; valid are 1 to 65536", options.samples_per_light));
  if (!(options.roulette.continuation >= 0 && options.roulette.continuation <= 1))
    throw Error(fmt::format("the probability of going on is {}; it must lie in (0, 1]",
                            options.roulette.continuation));
  if (!(options.clamp > 0)) throw Error(fmt::format("the clamp is {}; it must be > 0", options.clamp));
}

}  // namespace twinray
