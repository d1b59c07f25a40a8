// SPDX-License-Identifier: Apache-2.0
#include "core/thin_film.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>

#include "core/elementary.h"
#include "core/observer.h"

namespace twinray {
namespace {

constexpr float step = 5;  // of the table, in nm
constexpr std::size_t steps = std::size_t(film_coherence / step);
using Interference = std::array<Rgb, steps + 1>;

Rgb interference_at(double detour) {
  Xyz waves, all;
  for (const Observed& o : observer()) {
    const double turns = detour / o.wavelength;
    const double wave = double(sincos_turns(float(turns - std::floor(turns))).cos) * o.daylight;
    waves.x += o.x * wave, waves.y += o.y * wave, waves.z += o.z * wave;
    all.x += o.x * o.daylight, all.y += o.y * o.daylight, all.z += o.z * o.daylight;
  }
  const auto part = to_rgb(waves), whole = to_rgb(all);
  return {float(part[0] / whole[0]), float(part[1] / whole[1]), float(part[2] / whole[2])};
}

const Interference& interference_table() {
  static const auto waves = [] {
    auto made = std::make_unique<Interference>();
    for (std::size_t i = 0; i <= steps; ++i) (*made)[i] = interference_at(double(i) * double(step));
    return made;
  }();
  return *waves;
}

/// What a boundary reflects of the amplitudes of both polarisations.
struct Amplitudes {
  float across, along;
};
Amplitudes amplitudes(float cos_i, float cos_t, float eta) {
  return {(cos_i - eta * cos_t) / (cos_i + eta * cos_t), (eta * cos_i - cos_t) / (eta * cos_i + cos_t)};
}

/// What a channel lets through of one polarisation: the factor of the header's series, and -q.
struct Series {
  float whole, ratio;

  Series(float first, float second) {
    const float q = first * second, rest = 1 - q * q;
    whole = rest > 0 ? (1 - first * first) * (1 - second * second) / rest : 0;
    ratio = rest > 0 ? -q : 0;
  }
};

}  // namespace

Rgb mean_interference(float detour) {
  const float place = detour / step;
  if (!(place < float(steps))) return {};
  const Interference& table = interference_table();
  const auto i = std::size_t(place);
  return table[i] + (table[i + 1] - table[i]) * (place - float(i));
}

ThinFilm::ThinFilm(float thickness, float ior, float above)
    : detour_(2 * ior * thickness), eta_(ior / above) {}

Rgb ThinFilm::reflectance(float cosine, const Rgb& base_ior) const {
  const float within = refracted_cosine(cosine, eta_);
  const Amplitudes first = amplitudes(cosine, within, eta_);
  const auto series_of = [&](float base) {
    const float below = refracted_cosine(cosine, base);
    const Amplitudes second = amplitudes(within, below, base / eta_);
    return std::array{Series(first.across, second.across), Series(first.along, second.along)};
  };
  const std::array<Series, 2> r = series_of(base_ior.r), g = series_of(base_ior.g), b = series_of(base_ior.b);
  Rgb through;
  for (std::size_t k = 0; k < 2; ++k) {
    const Rgb whole{r[k].whole, g[k].whole, b[k].whole}, ratio{r[k].ratio, g[k].ratio, b[k].ratio};
    Rgb sum{1, 1, 1}, power{2, 2, 2};
    constexpr int most = 200;
    for (int m = 1; m <= most; ++m) {
      power = power * ratio;
      const float detour = float(m) * detour_ * within;
      const float size = std::max({std::fabs(power.r), std::fabs(power.g), std::fabs(power.b)});
      if (size < 1e-4f || detour >= film_coherence) break;
      sum = sum + power * mean_interference(detour);
    }
    through = through + whole * sum * 0.5f;
  }
  return within_unit(Rgb{1, 1, 1} - through);
}

Rgb PartialFilm::reflectance(float cosine, float eta) const {
  const Rgb bare = white * fresnel_dielectric(cosine, eta);
  const float above = is_below ? refracted_cosine(cosine, eta) : cosine;
  if (is_below && above == 0) return bare;  // Totally, whatever lies beyond.
  // The boundary without a film is seen as if the coat did not refract; the film adds its change to that.
  const float bent = below_coat(above), base = is_below ? 1 / eta : eta;
  const Rgb change = film.reflectance(bent, white * base) - white * fresnel_dielectric(bent, base);
  return within_unit(bare + change * weight);
}

Rgb index_of_reflectance(const Rgb& reflectance) {
  const auto channel = [](float r) {
    const float root = std::sqrt(std::clamp(r, 0.0f, 0.999f));
    return (1 + root) / (1 - root);
  };
  return {channel(reflectance.r), channel(reflectance.g), channel(reflectance.b)};
}

}  // namespace twinray
