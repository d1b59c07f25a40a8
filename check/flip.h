// SPDX-License-Identifier: Apache-2.0
// FLIP: how much of a difference people see who switch between two pictures (P. Andersson, J. Nilsson, T.
// Akenine-Moeller, M. Oskarsson, K. Astrom and M. D. Fairchild, "FLIP: A Difference Evaluator for Alternating
// Images", HPG 2020).
//
// Each picture is blurred as the eye blurs it at some distance, each opponent colour by its own filter, and
// the colours that are left are compared. Where edges or points differ, too, the difference counts more.
#pragma once
#include "core/image.h"
#include "core/plane.h"

namespace twinray {

/// For each pixel from 0 (nobody sees a difference) to 1.
using FlipMap = Plane;

double mean_of(const FlipMap& map);

/// Of a picture's width per degree of the field of view: 3840 pixels on a display that is 0.7 m wide, seen
/// from 0.7 m.
inline constexpr double usual_pixels_per_degree = 67.0206433;

/// Of what a display shows: linear colours, clipped to [0, 1]. Throws Error unless both have the same size.
FlipMap ldr_flip(const Image& picture, const Image& reference,
                 double pixels_per_degree = usual_pixels_per_degree);

/// From the exposure at which the reference's brightest pixel is bright, to that at which half of all are.
struct FlipExposures {
  double first = 0, last = 0;  ///< Powers of 2.
  int count = 1;               ///< A step at most between two of them.
};
FlipExposures flip_exposures(const Image& reference);

/// Of radiance: the most of what is seen at any of the reference's exposures (P. Andersson, J. Nilsson, P.
/// Shirley and T. Akenine-Moeller, "Visualizing Errors in Rendered High Dynamic Range Images", Eurographics
/// 2021). Negative channels count as 0. Throws Error unless both have the same size.
FlipMap hdr_flip(const Image& picture, const Image& reference,
                 double pixels_per_degree = usual_pixels_per_degree);

}  // namespace twinray
