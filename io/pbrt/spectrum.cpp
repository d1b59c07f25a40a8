// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/spectrum.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/blackbody.h"
#include "core/observer.h"

namespace twinray {
namespace {

/// What the observer sees of daylight itself.
const Xyz& daylight() {
  static const Xyz light = seen([](const Observed& o) { return o.daylight; });
  return light;
}

Rgb clipped(const std::array<double, 3>& c) {
  return {float(std::max(0.0, c[0])), float(std::max(0.0, c[1])), float(std::max(0.0, c[2]))};
}

Rgb unit_luminance(const Xyz& c) { return c.y > 0 ? clipped(to_rgb({c.x / c.y, 1, c.z / c.y})) : Rgb{}; }

struct ListedSpectrum {
  Spectrum spectrum;
  std::size_t fault;  ///< The index of a wavelength that does not increase; the size where all do.
};

ListedSpectrum from_pairs(std::span<const float> pairs) {
  ListedSpectrum listed{{}, pairs.size() / 2};
  for (std::size_t i = 0; i + 1 < pairs.size(); i += 2) {
    if (i > 0 && !(pairs[i] > pairs[i - 2])) listed.fault = std::min(listed.fault, i / 2);
    listed.spectrum.wavelengths.push_back(pairs[i]);
    listed.spectrum.values.push_back(pairs[i + 1]);
  }
  return listed;
}

void check_pairs(const PbrtPlace& place, std::span<const float> pairs, std::size_t fault) {
  if (pairs.empty() || pairs.size() % 2 != 0)
    place.fail(fmt::format("a spectrum of {} numbers; it needs pairs of a wavelength in nm and a value",
                           pairs.size()));
  if (fault < pairs.size() / 2)
    place.fail(fmt::format("the wavelengths of this spectrum must increase; number {} is {:g}, after {:g}",
                           fault + 1, pairs[2 * fault], pairs[2 * fault - 2]));
  std::size_t least = 0;
  float largest = 0;
  for (std::size_t i = 0; i < pairs.size() / 2; ++i) {
    if (pairs[2 * i + 1] < pairs[2 * least + 1]) least = i;
    largest = std::max(largest, pairs[2 * i + 1]);
  }
  constexpr float noise = 0.01f;
  if (const float value = pairs[2 * least + 1]; value < 0 && -value > noise * largest)
    place.fail(
        fmt::format("the values of this spectrum must not be negative, but for noise of a hundredth of "
                    "the largest; number {} is {:g}",
                    least + 1, value));
}

Rgb color_of_spectrum(const Spectrum& spectrum, ColorRole role) {
  return role == ColorRole::light ? light_color(spectrum) : matter_color(spectrum);
}

/// A spectrum by name or from a file.
Rgb color_of_text(const std::string& text, const PbrtPlace& place, ColorRole role, const PbrtFiles& files) {
  if (const auto named = named_spectrum(text)) return named->color;
  const bool is_like_a_name = text.find('.') == std::string::npos && text.find('/') == std::string::npos;
  if (is_like_a_name) {
    const std::string nearest = nearest_name(text, named_spectra());
    place.fail(fmt::format("there is no spectrum \"{}\"{}", text,
                           nearest.empty() ? "; valid are names such as \"metal-Au-eta\", and files"
                                           : fmt::format("; the nearest one is \"{}\"", nearest)));
  }
  const std::string path = files.path(place, text);
  return color_of_spectrum(parse_spectrum({path, files.bytes(place, path)}), role);
}

bool is_in(const Rgb& c, float most) {
  return c.r >= 0 && c.g >= 0 && c.b >= 0 && c.r <= most && c.g <= most && c.b <= most;
}

void check_range(const Rgb& color, const PbrtParameter& parameter, ColorRole role) {
  const float most = role == ColorRole::reflectance ? 1.0f : 3e38f;
  if (!is_in(color, most))
    parameter.place.fail(fmt::format("\"{}\" is {:g} {:g} {:g}; each must {}", parameter.name, color.r,
                                     color.g, color.b,
                                     role == ColorRole::reflectance ? "lie in [0, 1]" : "be at least 0"));
}

Rgb clamped(const Rgb& c, float most) {
  return {std::clamp(c.r, 0.0f, most), std::clamp(c.g, 0.0f, most), std::clamp(c.b, 0.0f, most)};
}

}  // namespace

float Spectrum::at(float wavelength) const {
  const auto above = std::upper_bound(wavelengths.begin(), wavelengths.end(), wavelength);
  if (above == wavelengths.begin()) return 0;
  if (above == wavelengths.end()) return wavelength == wavelengths.back() ? values.back() : 0;
  const std::size_t i = std::size_t(above - wavelengths.begin());
  const float part = (wavelength - wavelengths[i - 1]) / (wavelengths[i] - wavelengths[i - 1]);
  return values[i - 1] + part * (values[i] - values[i - 1]);
}

Rgb light_color(const Spectrum& spectrum) {
  return unit_luminance(seen([&](const Observed& o) { return double(spectrum.at(float(o.wavelength))); }));
}

Rgb blackbody_color(double kelvin) {
  return unit_luminance(seen([&](const Observed& o) { return planck(o.wavelength, kelvin); }));
}

Rgb daylight_color(double kelvin) {
  // By the constant of radiation that the series was made with.
  const double t = kelvin * 1.4388 / 1.4380;
  if (t < 4000) return blackbody_color(kelvin);
  const double x = t <= 7000 ? -4.6070e9 / (t * t * t) + 2.9678e6 / (t * t) + 0.09911e3 / t + 0.244063
                             : -2.0064e9 / (t * t * t) + 1.9018e6 / (t * t) + 0.24748e3 / t + 0.237040;
  const double y = -3 * x * x + 2.870 * x - 0.275;
  return clipped(to_rgb({x / y, 1, (1 - x - y) / y}));
}

Rgb matter_color(const Spectrum& spectrum) {
  const auto lit =
      to_rgb(seen([&](const Observed& o) { return o.daylight * double(spectrum.at(float(o.wavelength))); }));
  const auto light = to_rgb(daylight());
  return clipped({lit[0] / light[0], lit[1] / light[1], lit[2] / light[2]});
}

float luminous_mean(const Spectrum& spectrum) {
  const auto at = [&](const Observed& o) {
    return spectrum.at(
        std::clamp(float(o.wavelength), spectrum.wavelengths.front(), spectrum.wavelengths.back()));
  };
  const double lit = seen([&](const Observed& o) { return o.daylight * double(at(o)); }).y;
  return float(lit / daylight().y);
}

Spectrum parse_spectrum(const PbrtFile& file) {
  std::vector<float> numbers;
  PbrtLexer lexer(file);
  while (lexer.next().kind != PbrtToken::Kind::end) numbers.push_back(lexer.take().real());
  ListedSpectrum listed = from_pairs(numbers);
  check_pairs({&file}, numbers, listed.fault);
  return std::move(listed.spectrum);
}

Rgb color_of(const PbrtParameters& parameters, const PbrtParameter& parameter, ColorRole role,
             const PbrtFiles& files) {
  const float most = role == ColorRole::reflectance ? 1.0f : 3e38f;
  if (parameter.type == PbrtType::spectrum && parameter.has_strings)
    return clamped(color_of_text(parameters.text(parameter), parameter.place, role, files), most);
  const bool is_color = parameter.type == PbrtType::rgb || parameter.type == PbrtType::blackbody ||
                        parameter.type == PbrtType::spectrum || parameter.type == PbrtType::real;
  if (!is_color)
    parameter.place.fail(fmt::format("\"{}\" is of type {} here; valid is rgb, spectrum, blackbody or float",
                                     parameter.name, PbrtParameters::type_name(parameter.type)));
  const std::span<const float> values = parameters.reals(parameter);
  if (parameter.type == PbrtType::spectrum) {
    const ListedSpectrum listed = from_pairs(values);
    check_pairs(parameter.place, values, listed.fault);
    return clamped(color_of_spectrum(listed.spectrum, role), most);
  }
  if (values.size() != (parameter.type == PbrtType::rgb ? 3 : 1))
    parameter.place.fail(
        fmt::format("\"{}\" has {} numbers; it needs one color", parameter.name, values.size()));
  if (parameter.type == PbrtType::real) {
    const Rgb grey{values[0], values[0], values[0]};
    check_range(grey, parameter, role);
    return grey;
  }
  if (parameter.type == PbrtType::blackbody) {
    if (!(values[0] >= 100 && values[0] <= 1e6))
      parameter.place.fail(
          fmt::format("\"{}\" is {:g} kelvin; it must lie in [100, 1e+06]", parameter.name, values[0]));
    return clamped(blackbody_color(values[0]), most);
  }
  const Rgb color{values[0], values[1], values[2]};
  check_range(color, parameter, role);
  return clamped(to_srgb(color, parameter.color_space.value_or(parameters.color_space)), most);
}

Rgb color_of(const PbrtParameters& parameters, const char* name, const Rgb& fallback, ColorRole role,
             const PbrtFiles& files) {
  const PbrtParameter* found = parameters.find(name);
  return found ? color_of(parameters, *found, role, files) : fallback;
}

}  // namespace twinray
