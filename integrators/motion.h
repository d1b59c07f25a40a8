// SPDX-License-Identifier: Apache-2.0
// What moves while the shutter is open (docs/motion.md): a few samples of each pixel at one moment, at which
// all stands still, the next few at another.
#pragma once
#include <cstdint>
#include <functional>

#include "integrators/traced_scene.h"

namespace twinray {

/// The scene of a picture in which something moves. A ray has no time: all rays of a sample belong to one
/// moment, and so do whole passes.
struct Motion {
  std::uint32_t samples_per_moment = 4;  ///< >= 1.
  /// The scene at a part, in [0, 1), of the time that the shutter is open. Asked from one thread; an answer
  /// holds until the next. May throw Error.
  std::function<TracedScene(double part)> at;

  std::uint32_t moment_of(std::uint32_t sample) const { return sample / samples_per_moment; }
  /// The first sample of the moment after that of a sample.
  std::uint32_t end_of_moment(std::uint32_t sample) const {
    return (moment_of(sample) + 1) * samples_per_moment;
  }
};

/// When a moment is, in [0, 1) of the time that the shutter is open: the radical inverse in base 2, moved by
/// a part that the seed draws, around the end. So of any 2^k moments that begin at a multiple of 2^k, one
/// lies in each 2^k-th part of the time; over all seeds, each moment is uniform.
double shutter_part(std::uint32_t moment, std::uint64_t seed);

}  // namespace twinray
