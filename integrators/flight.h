// SPDX-License-Identifier: Apache-2.0
// How far a path goes through media before it is scattered in one.
#pragma once
#include "core/material.h"
#include "core/rgb.h"
#include "integrators/medium_column.h"

namespace twinray {

/// The way of a path from one vertex to the next through media that scatter. Its optical depth, the integral
/// of the extinction, is drawn once for the whole way: by e^-depth, in one of the three channels. The path is
/// weighted by the mean of the densities that the channels would have had (the one-sample estimator with the
/// balance heuristic of Wilkie et al., "Hero Wavelength Spectral Sampling", 2014), so that no channel has
/// large weights where another one was chosen.
class Flight {
 public:
  /// Channels are chosen by the path's throughput where the way begins, not black. u in [0, 1).
  Flight(const Rgb& throughput, float u);

  /// How much of a medium the path goes through before it is scattered, where that does not end before;
  /// infinite where the channel is not dimmed.
  float reach(const Interior& medium) const;
  /// Goes on through a medium that scatters. Whether the path is scattered before the column's end; then the
  /// flight ends there.
  bool ends_within(const Interior& medium, const MediumColumn& column);
  /// Whether it has gone through any.
  bool has_begun() const { return has_begun_; }
  /// How far behind the beginning of the last medium it has ended.
  float distance() const { return distance_; }

  /// What the way leaves of the path's throughput, over the probability of the way; where the flight has
  /// ended, what is scattered there, over its density.
  Rgb weight() const;

 private:
  Rgb chance_;         ///< That a channel is chosen; they sum up to 1.
  int channel_ = 0;    ///< The one that was,
  float depth_;        ///< and what is left of its optical depth.
  Rgb left_{1, 1, 1};  ///< Of light on the way.
  float distance_ = 0;
  bool has_begun_ = false, has_ended_ = false;
  Interior medium_;  ///< In which it has.
};

}  // namespace twinray
