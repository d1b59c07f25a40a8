// SPDX-License-Identifier: Apache-2.0
#include "tests/support/measured_facets.h"

#include <cmath>

namespace twinray::test {
namespace {

Vec3 direction(double theta, double phi) {
  return {float(std::sin(theta) * std::cos(phi)), float(std::sin(theta) * std::sin(phi)),
          float(std::cos(theta))};
}

/// Angles of a place in the square, as the tables have them.
double theta_of(double x) { return M_PI / 2 * x * x; }
double phi_of(double y) { return (2 * y - 1) * M_PI; }

/// Area that facets show to a direction, per area of the surface.
double shown_area(const Ggx& facets, const Vec3& w) {
  return w.z * (1 + double(facets.lambda({w.x, w.y, std::max(w.z, 1e-4f)})));
}

/// The values of f(x, y) at the nodes of the square.
template <typename Value, typename F>
std::vector<Value> nodes_of(std::size_t nodes, const F& f) {
  std::vector<Value> values;
  for (std::size_t j = 0; j < nodes; ++j)
    for (std::size_t i = 0; i < nodes; ++i)
      values.push_back(Value(f(double(i) / double(nodes - 1), double(j) / double(nodes - 1))));
  return values;
}

}  // namespace

Rgb facets_value(const Ggx& facets, const Rgb& color, const Vec3& wo, const Vec3& wi) {
  return color * facets.reflection(wo, wi).value;
}

BrdfMeasurement measured_facets(const Ggx& facets, const Rgb& color, std::size_t thetas, std::size_t phis,
                                std::size_t nodes, int folds) {
  const bool is_even = phis == 1;
  std::vector<float> phi{0}, theta;
  if (!is_even) phi.clear();
  for (std::size_t i = 0; i < thetas; ++i)
    theta.push_back(float(0.49 * M_PI * double(i) / double(thetas - 1)));
  for (std::size_t i = 0; i < phis && !is_even; ++i)
    phi.push_back(float(-M_PI + 2 * M_PI / folds * double(i) / double(phis - 1)));
  const auto at = [](double x, double y) { return direction(theta_of(x), phi_of(y)); };
  const SquareTable<float> ndf(
      nodes, nodes, nodes_of<float>(nodes, [&](double x, double y) { return facets.density(at(x, y)); }));
  const SquareTable<float> sigma(
      nodes, nodes, nodes_of<float>(nodes, [&](double x, double y) { return shown_area(facets, at(x, y)); }));
  std::vector<float> vndf, luminance;
  std::vector<Rgb> reflected;
  for (const float p : phi)
    for (const float t : theta) {
      const Vec3 wo = direction(double(t), double(p));
      const std::vector<float> visible = nodes_of<float>(nodes, [&](double x, double y) {
        const Vec3 m = at(x, y);
        return facets.density(m) * std::max(0.0f, dot(wo, m)) * float(x * std::sin(theta_of(x)));
      });
      vndf.insert(vndf.end(), visible.begin(), visible.end());
      const SquareDensity density(SquareTable<float>(nodes, nodes, visible));
      const std::vector<float> parts = nodes_of<float>(nodes, [&](double x, double y) {
        const Vec2 place = density.sample({float(x), float(y)}, {}).point;
        const Vec3 wi = twinray::reflected(wo, at(double(place.x), double(place.y)));
        if (!(wi.z > 0)) return 0.0f;
        return facets.shadowing_masking(wo, wi) / facets.masking(wo);
      });
      luminance.insert(luminance.end(), parts.begin(), parts.end());
      for (const float part : parts) reflected.push_back(color * part);
    }
  return {.phi = phi,
          .theta = theta,
          .ndf = ndf,
          .sigma = sigma,
          .vndf = SquareTable<float>(nodes, nodes, vndf),
          .luminance = SquareTable<float>(nodes, nodes, luminance),
          .reflected = SquareTable<Rgb>(nodes, nodes, reflected)};
}

Measured measured_material(const Rgb& color, std::size_t phis) {
  const Ggx facets = phis == 1 ? Ggx(0.4f) : Ggx(0.2f, 0.5f);
  return {std::make_shared<const MeasuredBrdf>(measured_facets(facets, color, 6, phis, 16))};
}

}  // namespace twinray::test
