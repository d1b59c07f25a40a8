// SPDX-License-Identifier: Apache-2.0
#include "io/measured/brdf_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/error.h"
#include "io/measured/tensor_file.h"
#include "io/measured/visible_spectrum.h"

namespace twinray {
namespace {

using Shape = TensorFile::Shape;

constexpr std::uint64_t most_wavelengths = 4096;

/// The tables of one file.
class Reader {
 public:
  explicit Reader(const TensorFile& file) : file_(file) {}

  MeasuredBrdf read() const {
    const std::vector<float> phi = list("phi_i"), theta = list("theta_i");
    const std::uint64_t phis = phi.size(), thetas = theta.size();
    return MeasuredBrdf({.phi = phi,
                         .theta = theta,
                         .ndf = table("ndf", file_.shape("ndf", 2)),
                         .sigma = table("sigma", file_.shape("sigma", 2)),
                         .vndf = table("vndf", slices("vndf", 4, phis, thetas)),
                         .luminance = table("luminance", slices("luminance", 4, phis, thetas)),
                         .reflected = file_.has("rgb") ? colors(phis, thetas) : spectra(phis, thetas),
                         .is_relative_to_facets = file_.byte("jacobian") != 0});
  }

 private:
  std::vector<float> list(const std::string& field) const {
    file_.shape(field, 1);
    return file_.floats(field);
  }

  /// A shape that begins with the numbers of angles.
  const Shape& slices(const std::string& field, std::size_t dimensions, std::uint64_t phis,
                      std::uint64_t thetas) const {
    const Shape& shape = file_.shape(field, dimensions);
    if (shape[0] != phis || shape[1] != thetas)
      file_.fail(field, fmt::format("has tables for {} x {} directions; there are {} x {}", shape[0],
                                    shape[1], phis, thetas));
    return shape;
  }

  SquareTable<float> table(const std::string& field, const Shape& shape) const {
    std::vector<float> values = file_.floats(field);
    for (float& value : values)
      if (value < 0) value = 0;
    return make_table(field, shape, std::move(values));
  }
  template <typename Value>
  SquareTable<Value> make_table(const std::string& field, const Shape& shape,
                                std::vector<Value> values) const {
    const std::uint64_t height = shape[shape.size() - 2], width = shape.back();
    if (height < 2 || width < 2) file_.fail(field, "needs two rows and two columns at least");
    return {width, height, std::move(values)};
  }

  SquareTable<Rgb> colors(std::uint64_t phis, std::uint64_t thetas) const {
    const Shape& shape = slices("rgb", 5, phis, thetas);
    if (shape[2] != 3) file_.fail("rgb", fmt::format("has {} channels; it needs 3", shape[2]));
    return weighted("rgb", shape, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  }

  SquareTable<Rgb> spectra(std::uint64_t phis, std::uint64_t thetas) const {
    const Shape& shape = slices("spectra", 5, phis, thetas);
    const std::vector<float> wavelengths = list("wavelengths");
    if (shape[2] != wavelengths.size())
      file_.fail("spectra",
                 fmt::format("has {} wavelengths; \"wavelengths\" lists {}", shape[2], wavelengths.size()));
    if (wavelengths.size() > most_wavelengths)
      file_.fail("wavelengths",
                 fmt::format("has {}; at most {} are read", wavelengths.size(), most_wavelengths));
    for (std::size_t i = 0; i < wavelengths.size(); ++i)
      if (!(wavelengths[i] > 0) || (i > 0 && !(wavelengths[i - 1] < wavelengths[i])))
        file_.fail("wavelengths", "must increase, and be above 0");
    return weighted("spectra", shape, reflectance_weights(wavelengths));
  }

  /// Slices of each direction's channels, summed up with a color for each of them.
  SquareTable<Rgb> weighted(const std::string& field, const Shape& shape,
                            const std::vector<std::array<double, 3>>& weights) const {
    const std::vector<float> values = file_.floats(field);
    const std::size_t nodes = shape[3] * shape[4], channels = shape[2];
    std::vector<Rgb> sums;
    sums.reserve(values.size() / channels);
    for (std::size_t slice = 0; slice < values.size() / (nodes * channels); ++slice)
      for (std::size_t node = 0; node < nodes; ++node) {
        std::array<double, 3> sum{};
        for (std::size_t c = 0; c < channels; ++c)
          if (const float value = values[(slice * channels + c) * nodes + node]; value > 0) {
            if (std::isinf(value)) file_.fail(field, "has a number that is infinite");
            for (std::size_t k = 0; k < 3; ++k) sum[k] += weights[c][k] * double(value);
          }
        const auto positive = [](double x) { return x > 0 ? float(x) : 0.0f; };
        sums.push_back({positive(sum[0]), positive(sum[1]), positive(sum[2])});
      }
    return make_table(field, shape, std::move(sums));
  }

  const TensorFile& file_;
};

template <typename Value>
Shape shape_of(const SquareTable<Value>& table, Shape shape) {
  shape.push_back(table.height());
  shape.push_back(table.width());
  return shape;
}

/// Of each slice one channel after the other, each in proportion to weights of the three colors.
std::vector<float> channels_of(const SquareTable<Rgb>& table, const std::vector<Rgb>& weights) {
  const std::size_t nodes = table.width() * table.height();
  std::vector<float> values;
  values.reserve(table.values().size() * weights.size());
  for (std::size_t slice = 0; slice < table.slices(); ++slice)
    for (const Rgb& weight : weights)
      for (std::size_t node = 0; node < nodes; ++node) {
        const Rgb parts = table.values()[slice * nodes + node] * weight;
        values.push_back(parts.r + parts.g + parts.b);
      }
  return values;
}

}  // namespace

MeasuredBrdf read_brdf_file(std::string_view bytes, const std::string& name) {
  const TensorFile file(bytes, name);
  try {
    return Reader(file).read();
  } catch (const Error& error) {
    const std::string what = error.what();
    throw Error(what.starts_with(name) ? what : name + ": " + what);
  }
}

std::string brdf_file_bytes(const MeasuredBrdf& brdf, BrdfColors colors) {
  const std::uint64_t phis = brdf.phi().size(), thetas = brdf.theta().size();
  TensorFileWriter file;
  file.add("description", "written by twinray");
  file.add("phi_i", {phis}, brdf.phi());
  file.add("theta_i", {thetas}, brdf.theta());
  file.add("ndf", shape_of(brdf.ndf(), {}), brdf.ndf().values());
  file.add("sigma", shape_of(brdf.sigma(), {}), brdf.sigma().values());
  file.add("vndf", shape_of(brdf.vndf(), {phis, thetas}), brdf.vndf().values());
  file.add("luminance", shape_of(brdf.luminance(), {phis, thetas}), brdf.luminance().values());
  const SquareTable<Rgb>& reflected = brdf.reflected();
  if (colors == BrdfColors::rgb) {
    file.add("rgb", shape_of(reflected, {phis, thetas, 3}),
             channels_of(reflected, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
  } else {
    const PrimarySpectra primaries = primary_spectra();
    file.add("wavelengths", {primaries.wavelengths.size()}, primaries.wavelengths);
    file.add("spectra", shape_of(reflected, {phis, thetas, primaries.wavelengths.size()}),
             channels_of(reflected, primaries.values));
  }
  file.add("jacobian", std::string_view(brdf.is_relative_to_facets() ? "\1" : "\0", 1));
  return file.bytes();
}

}  // namespace twinray
