// SPDX-License-Identifier: Apache-2.0
#include "check/flip_filters.h"

#include <cmath>
#include <numbers>

#include "core/elementary.h"

namespace twinray::flip {
namespace {

double square(double x) { return x * x; }

double exp_double(double x) { return exp2_of(x * std::numbers::log2e); }

/// A Gaussian of weight a and spread b as a function of degrees: a sqrt(pi / b) exp(-pi^2 x^2 / b).
struct Gaussian {
  double a, b;
};

/// What the eye passes of brightness, red against green, and yellow against blue: the last is a sum of two.
constexpr Gaussian of_brightness{1, 0.0047}, of_red_green{1, 0.0053};
constexpr Gaussian of_yellow_blue{34.1, 0.04}, of_yellow_blue_too{13.5, 0.025};

int contrast_radius(double pixels_per_degree) {
  const double deviation = std::sqrt(of_yellow_blue.b / 2) / std::numbers::pi;  // the widest
  return int(std::ceil(3 * deviation * pixels_per_degree));
}

double sum_of(const Kernel& kernel) {
  double sum = 0;
  for (const float weight : kernel) sum += weight;
  return sum;
}

void scale(Kernel& kernel, double factor) {
  for (float& weight : kernel) weight = float(weight * factor);
}

/// exp(-x^2 falloff), not normalised.
Kernel bell(double falloff, int radius) {
  Kernel kernel;
  for (int x = -radius; x <= radius; ++x) kernel.push_back(float(exp_double(-falloff * x * x)));
  return kernel;
}

Kernel contrast_bell(const Gaussian& gaussian, double pixels_per_degree) {
  const double pi = std::numbers::pi;
  return bell(pi * pi / (gaussian.b * pixels_per_degree * pixels_per_degree),
              contrast_radius(pixels_per_degree));
}

/// The Gaussian's weight in a sum of several, all pixels together.
double weight_of(const Gaussian& gaussian, const Kernel& bell) {
  return gaussian.a * std::sqrt(std::numbers::pi / gaussian.b) * sum_of(bell) * sum_of(bell);
}

Plane blurred(const Plane& plane, const Gaussian& gaussian, double pixels_per_degree) {
  Kernel kernel = contrast_bell(gaussian, pixels_per_degree);
  scale(kernel, 1 / sum_of(kernel));
  return filtered(plane, kernel, kernel);
}

/// Weights above and below 0 add up to 1 and -1.
void balance(Kernel& kernel) {
  double above = 0, below = 0;
  for (const float weight : kernel) (weight > 0 ? above : below) += weight;
  for (float& weight : kernel) weight = float(weight > 0 ? weight / above : -weight / below);
}

/// A Gaussian as wide as the edges that the eye detects.
struct FeatureBell {
  explicit FeatureBell(double pixels_per_degree)
      : variance(square(0.5 * 0.082 * pixels_per_degree)),
        radius(int(std::ceil(3 * std::sqrt(variance)))),
        kernel(bell(0.5 / variance, radius)) {}

  double variance;  ///< In pixels.
  int radius;
  Kernel kernel;
};

/// The bell, times `factor` of the pixels from the middle on.
template <class Factor>
Kernel derivative(const FeatureBell& bell, const Factor& factor) {
  Kernel kernel = bell.kernel;
  for (int x = -bell.radius; x <= bell.radius; ++x)
    kernel[std::size_t(x + bell.radius)] *= float(factor(double(x)));
  balance(kernel);
  return kernel;
}

/// How strong a feature is whose kernel is this one in one direction, and the bell in the other.
Plane strength(const Plane& brightness, const Kernel& feature, Kernel smooth) {
  scale(smooth, 1 / sum_of(smooth));
  Plane length = filtered(brightness, feature, smooth);
  const Plane down = filtered(brightness, smooth, feature);
  for (std::size_t i = 0; i < length.values.size(); ++i)
    length.values[i] = std::sqrt(length.values[i] * length.values[i] + down.values[i] * down.values[i]);
  return length;
}

}  // namespace

Plane blurred_brightness(const Plane& plane, double pixels_per_degree) {
  return blurred(plane, of_brightness, pixels_per_degree);
}

Plane blurred_red_green(const Plane& plane, double pixels_per_degree) {
  return blurred(plane, of_red_green, pixels_per_degree);
}

Plane blurred_yellow_blue(const Plane& plane, double pixels_per_degree) {
  const double wide = weight_of(of_yellow_blue, contrast_bell(of_yellow_blue, pixels_per_degree));
  const double narrow = weight_of(of_yellow_blue_too, contrast_bell(of_yellow_blue_too, pixels_per_degree));
  Plane sum = blurred(plane, of_yellow_blue, pixels_per_degree);
  const Plane other = blurred(plane, of_yellow_blue_too, pixels_per_degree);
  const auto share = float(wide / (wide + narrow));
  for (std::size_t i = 0; i < sum.values.size(); ++i)
    sum.values[i] = share * sum.values[i] + (1 - share) * other.values[i];
  return sum;
}

Plane edge_strength(const Plane& brightness, double pixels_per_degree) {
  const FeatureBell bell(pixels_per_degree);
  return strength(brightness, derivative(bell, [](double x) { return -x; }), bell.kernel);
}

Plane point_strength(const Plane& brightness, double pixels_per_degree) {
  const FeatureBell bell(pixels_per_degree);
  const Kernel point = derivative(bell, [&](double x) { return x * x / bell.variance - 1; });
  return strength(brightness, point, bell.kernel);
}

}  // namespace twinray::flip
