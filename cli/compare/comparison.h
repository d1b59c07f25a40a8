// SPDX-License-Identifier: Apache-2.0
// What `twinray compare` measures of two pictures.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "check/bias.h"
#include "check/flip.h"
#include "check/picture_difference.h"

namespace twinray::compare {

/// Two pictures of one size, and how they differ.
struct Comparison {
  std::string picture_name, reference_name;
  Image picture, reference;
  /// Whether both hold radiance; else at least one holds what a display shows, and both are taken as that.
  bool is_radiance = false;
  PictureDifference difference;
  std::vector<TileDifference> tiles;  ///< Those that differ most.
  std::optional<double> psnr;         ///< In decibels, of 8 bits; none for radiance and for equal pictures.
  FlipMap flip;
  double mean_flip = 0, largest_flip = 0;
  std::optional<BiasTest> test;  ///< Whether more than noise differs: where both have their variances.
};

/// Reads and compares. Throws Error for pictures that cannot be compared.
Comparison compare(const std::string& picture, const std::string& reference);

/// The measures that a limit may stand for.
enum class Measure { mse, rmse, relative_mse, flip };

double value_of(const Comparison& comparison, Measure measure);

}  // namespace twinray::compare
