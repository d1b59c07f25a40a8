// SPDX-License-Identifier: Apache-2.0
#include "io/measured/brdf_file.h"

#include "io/measured/tensor_file.h"
#include "io/measured/visible_spectrum.h"
#include "tests/support/catch.h"
#include "tests/support/error_text.h"
#include "tests/support/measured_facets.h"
#include "tests/support/random.h"
#include "tests/support/text.h"

namespace twinray::test {
namespace {

MeasuredBrdf some_brdf(const Rgb& color, std::size_t phis = 1) {
  return MeasuredBrdf(measured_facets(Ggx(0.4f, phis == 1 ? 0.4f : 0.2f), color, 3, phis, 4));
}

/// A file of tables of 2 x 2 nodes for one direction, each number 1, but for what a test changes.
struct BrdfFields {
  std::vector<float> phi{0}, theta{0}, wavelengths{400, 500, 600};
  TensorFile::Shape ndf{2, 2}, sigma{2, 2}, vndf{1, 1, 2, 2}, luminance{1, 1, 2, 2}, spectra{1, 1, 3, 2, 2};
  std::vector<float> values = std::vector<float>(12, 1.0f);
  const char* colors = "spectra";
  std::string negative = {};  ///< The table whose second number is -0.1.
  std::string_view jacobian{"\1", 1};

  std::string bytes() const {
    const auto ones = [&](const char* table, const TensorFile::Shape& shape) {
      std::uint64_t size = 1;
      for (const std::uint64_t each : shape) size *= each;
      std::vector<float> numbers(size, 1.0f);
      if (negative == table) numbers[1] = -0.1f;
      return numbers;
    };
    TensorFileWriter file;
    file.add("phi_i", {phi.size()}, phi);
    file.add("theta_i", {theta.size()}, theta);
    file.add("ndf", ndf, ones("ndf", ndf));
    file.add("sigma", sigma, ones("sigma", sigma));
    file.add("vndf", vndf, ones("vndf", vndf));
    file.add("luminance", luminance, ones("luminance", luminance));
    file.add(colors, spectra, values);
    file.add("wavelengths", {wavelengths.size()}, wavelengths);
    file.add("jacobian", jacobian);
    return file.bytes();
  }
};

std::string brdf_error(const BrdfFields& fields) {
  return error_text([&] { read_brdf_file(fields.bytes(), "a.bsdf"); });
}

Rgb only_color(const BrdfFields& fields) {
  return read_brdf_file(fields.bytes(), "a.bsdf").reflected().node(0, 0, 0);
}

void check_color(const Rgb& found, const Rgb& wanted, double margin) {
  CHECK(found.r == Approx(wanted.r).margin(margin));
  CHECK(found.g == Approx(wanted.g).margin(margin));
  CHECK(found.b == Approx(wanted.b).margin(margin));
}

}  // namespace

TEST_CASE("a measured material that was written with colors comes back with each bit") {
  for (const std::size_t phis : {1, 5}) {
    const MeasuredBrdf brdf = some_brdf({0.9f, 0.5f, 0.1f}, phis);
    const MeasuredBrdf read = read_brdf_file(brdf_file_bytes(brdf, BrdfColors::rgb), "a.bsdf");
    CHECK(read.phi() == brdf.phi());
    CHECK(read.theta() == brdf.theta());
    CHECK(read.reflected().values() == brdf.reflected().values());
    CHECK(read.is_relative_to_facets());
    Random random(3);
    for (int i = 0; i < 50; ++i) {
      Vec3 wo = normalize(random.in_ball()), wi = normalize(random.in_ball());
      wo.z = std::fabs(wo.z), wi.z = std::fabs(wi.z);
      CHECK(read.evaluate(wo, wi).value == brdf.evaluate(wo, wi).value);
      CHECK(read.evaluate(wo, wi).pdf == brdf.evaluate(wo, wi).pdf);
    }
  }
  BrdfMeasurement plain = measured_facets(Ggx(0.4f), white, 3, 1, 4);
  plain.is_relative_to_facets = false;
  const MeasuredBrdf brdf(plain);
  CHECK_FALSE(read_brdf_file(brdf_file_bytes(brdf, BrdfColors::rgb), "a.bsdf").is_relative_to_facets());
}

TEST_CASE("a measured material that was written with spectra has the same colors") {
  for (const Rgb& color : {Rgb{1, 0, 0}, Rgb{0, 1, 0}, Rgb{0, 0, 1}, Rgb{0.2f, 0.5f, 0.9f}}) {
    const MeasuredBrdf brdf = some_brdf(color);
    const MeasuredBrdf read = read_brdf_file(brdf_file_bytes(brdf, BrdfColors::spectra), "a.bsdf");
    for (std::size_t i = 0; i < brdf.reflected().values().size(); i += 5)
      check_color(read.reflected().values()[i], brdf.reflected().values()[i], 3e-4);
  }
}

TEST_CASE("spectra are colors under daylight: a constant one is its number, and more than one is kept") {
  BrdfFields fields;
  check_color(only_color(fields), {1, 1, 1}, 1e-6);
  for (float& value : fields.values) value = 2.5f;
  check_color(only_color(fields), {2.5f, 2.5f, 2.5f}, 1e-5);
  // Of 400, 500 and 600 nm: blue, green and red.
  for (std::size_t i = 0; i < fields.values.size(); ++i) fields.values[i] = i / 4 == 2 ? 1.0f : 0.0f;
  const Rgb red = only_color(fields);
  CHECK((red.r > 0.7f && red.r > 3 * red.g && red.r > 10 * red.b));
  for (std::size_t i = 0; i < fields.values.size(); ++i) fields.values[i] = i / 4 == 0 ? 1.0f : 0.0f;
  const Rgb blue = only_color(fields);
  CHECK((blue.b > 0.4f && blue.b > 10 * std::fabs(blue.g)));
  CHECK(blue.g >= 0);  // A color that sRGB does not have.
  // What noise made negative is 0 at its wavelength, and so is what is no number.
  for (const float nothing : {-0.5f, NAN}) {
    for (std::size_t i = 0; i < fields.values.size(); ++i) fields.values[i] = i / 4 == 2 ? 1.0f : nothing;
    CHECK(only_color(fields) == red);
  }
}

TEST_CASE("numbers of tables that noise made negative are 0") {
  for (const char* table : {"ndf", "sigma", "vndf", "luminance"}) {
    BrdfFields fields;
    fields.negative = table;
    const MeasuredBrdf brdf = read_brdf_file(fields.bytes(), "a.bsdf");
    int zeros = 0;
    for (const SquareTable<float>* each : {&brdf.ndf(), &brdf.sigma(), &brdf.vndf(), &brdf.luminance()})
      zeros += each->node(0, 1, 0) == 0;
    CHECK(zeros == 1);
  }
}

TEST_CASE("weights of wavelengths sum up to one in each channel, of one wavelength alone, too") {
  for (const std::vector<float>& wavelengths :
       {std::vector<float>{550}, {360, 830}, {200, 300, 900, 1000}, {400, 410, 420, 700}}) {
    std::array<double, 3> sum{};
    for (const std::array<double, 3>& weight : reflectance_weights(wavelengths))
      for (std::size_t k = 0; k < 3; ++k) sum[k] += weight[k];
    for (const double channel : sum) CHECK(channel == Approx(1).epsilon(1e-9));
  }
}

TEST_CASE("a file of a measured material that cannot be is refused with what is wrong") {
  CHECK(brdf_error({}) == "");
  CHECK(error_text([] { read_brdf_file("no tensors", "a.bsdf"); }) ==
        "a.bsdf: is not a tensor file, as measured materials are");
  CHECK(brdf_error({.ndf = {2, 1}}) == "a.bsdf: the field \"ndf\" needs two rows and two columns at least");
  CHECK(brdf_error({.sigma = {1, 2, 2}}) == "a.bsdf: the field \"sigma\" has 3 dimensions; it needs 2");
  CHECK(brdf_error({.vndf = {2, 1, 2, 2}}) ==
        "a.bsdf: the field \"vndf\" has tables for 2 x 1 directions; there are 1 x 1");
  CHECK(brdf_error({.wavelengths = {400, 500}}) ==
        "a.bsdf: the field \"spectra\" has 3 wavelengths; \"wavelengths\" lists 2");
  CHECK(brdf_error({.wavelengths = {400, 600, 500}}) ==
        "a.bsdf: the field \"wavelengths\" must increase, and be above 0");
  CHECK(brdf_error({.wavelengths = {-1, 600, 700}}) ==
        "a.bsdf: the field \"wavelengths\" must increase, and be above 0");
  CHECK(brdf_error({.spectra = {1, 1, 2, 2, 3}, .colors = "rgb"}) ==
        "a.bsdf: the field \"rgb\" has 2 channels; it needs 3");
  CHECK(brdf_error({.colors = "colours"}) == "a.bsdf: the field \"spectra\" is missing");
  CHECK(brdf_error({.jacobian = "ab"}) == "a.bsdf: the field \"jacobian\" must be one byte");
  CHECK(brdf_error({.values = std::vector<float>(12, INFINITY)}) ==
        "a.bsdf: the field \"spectra\" has a number that is infinite");
  CHECK(brdf_error({.theta = {2}}) ==
        "a.bsdf: the angles of a measurement's theta do not increase within their range");
  std::vector<float> many(4097);
  for (std::size_t i = 0; i < many.size(); ++i) many[i] = float(i + 1);
  CHECK(brdf_error(
            {.wavelengths = many, .spectra = {1, 1, 4097, 2, 2}, .values = std::vector<float>(4097 * 4)}) ==
        "a.bsdf: the field \"wavelengths\" has 4097; at most 4096 are read");
}

TEST_CASE("a file of a measured material that is cut off or damaged is refused, or is another material") {
  const std::string bytes = brdf_file_bytes(some_brdf(white), BrdfColors::rgb);
  for (std::size_t size = 0; size < bytes.size(); size += 7) {
    const std::string error = error_text([&] { read_brdf_file(bytes.substr(0, size), "a.bsdf"); });
    CHECK(error.starts_with("a.bsdf: "));
  }
  Random random(4);
  int refused = 0;
  for (int i = 0; i < 2000; ++i) {
    std::string damaged = bytes;
    damaged[std::size_t(random.below(int(bytes.size())))] ^= char(1 << random.below(8));
    const std::string error = error_text([&] { read_brdf_file(damaged, "a.bsdf"); });
    refused += error != "";
    CHECK((error.empty() || error.starts_with("a.bsdf: ")));
  }
  CHECK(refused > 20);
}

}  // namespace twinray::test
