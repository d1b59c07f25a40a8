// SPDX-License-Identifier: Apache-2.0
// One picture, made twice from halves of its samples: what a filter knows of the noise (F. Rousselle, C.
// Knaus and M. Zwicker, "Adaptive Rendering with Non-Local Means Filtering", SIGGRAPH Asia 2012).
#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/film.h"
#include "core/plane.h"
#include "integrators/denoise/color_planes.h"
#include "integrators/half_films.h"

namespace twinray {

/// Means over one half of the samples: colours in three planes, and features, which say where the picture's
/// edges are.
struct HalfPicture {
  Color color;
  std::vector<Plane> features;
};

/// Both halves, and how they are put together: the picture is (1 - weight) a + weight b, pixel by pixel.
struct HalfPictures {
  int width = 0, height = 0;
  std::array<HalfPicture, 2> halves;
  Plane second_weight;  ///< The second half's share of a pixel's samples, in [0, 1].
};

/// What a filter makes of the colours of both halves.
using FilteredHalves = std::array<Color, 2>;

/// The colours of both films and the layers that they have. A half without samples of a pixel has there what
/// the other has.
HalfPictures half_pictures(const HalfFilms& films);
/// Gives the pictures of films the colours of one of the light groups that these have.
void take_light_group(const HalfFilms& films, std::size_t group, HalfPictures& pictures);

/// (1 - weight) a + weight b.
Plane mean_of_halves(const Plane& a, const Plane& b, const Plane& second_weight);
/// The same plane by plane, of as many in each half.
std::vector<Plane> means_of_halves(std::span<const Plane> a, std::span<const Plane> b,
                                   const Plane& second_weight);

/// Of the mean of both halves, by their difference alone: the variance of a pixel, which is right on average
/// where the halves are independent, and too large where stratified samples make them differ more than that.
Plane half_variance(const Plane& a, const Plane& b, const Plane& second_weight);

/// The root of the relative mean squared error (check/picture_error.h) that the picture has by its halves.
double estimated_relative_error(const HalfPictures& pictures);

}  // namespace twinray
