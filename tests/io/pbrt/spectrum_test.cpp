// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/spectrum.h"

#include "tests/support/catch.h"
#include "tests/support/pbrt_text.h"

namespace twinray {
namespace {

/// CIE 1931 x and y of a linear sRGB color.
Vec2 chromaticity(const Rgb& c) {
  const float x = 0.4124564f * c.r + 0.3575761f * c.g + 0.1804375f * c.b;
  const float y = 0.2126729f * c.r + 0.7151522f * c.g + 0.0721750f * c.b;
  const float z = 0.0193339f * c.r + 0.1191920f * c.g + 0.9503041f * c.b;
  return {x / (x + y + z), y / (x + y + z)};
}

Rgb reflectance_at_normal(const Rgb& eta, const Rgb& k) {
  const auto f = [](float e, float a) { return ((e - 1) * (e - 1) + a * a) / ((e + 1) * (e + 1) + a * a); };
  return {f(eta.r, k.r), f(eta.g, k.g), f(eta.b, k.b)};
}

Spectrum constant(float value) { return {{300, 900}, {value, value}}; }

}  // namespace

TEST_CASE("a black body's color lies where the CIE has it") {
  constexpr float of_steps = 1e-4f;  // 5 nm, the constants of Planck's law, sRGB's matrix of 7 digits
  struct Known {
    double kelvin;
    Vec2 xy;  // Wyszecki and Stiles, "Color Science", the Planckian locus
  };
  for (const auto& [kelvin, xy] : {Known{2856, {0.4475f, 0.4075f}}, Known{5000, {0.3451f, 0.3516f}},
                                   Known{6500, {0.3135f, 0.3237f}}, Known{10000, {0.2807f, 0.2884f}}}) {
    const Vec2 found = chromaticity(blackbody_color(kelvin));
    INFO(kelvin << ": " << found.x << " " << found.y);
    CHECK(found.x == Approx(xy.x).margin(2 * of_steps));
    CHECK(found.y == Approx(xy.y).margin(2 * of_steps));
    CHECK(luminance(blackbody_color(kelvin)) == Approx(1).epsilon(1e-3));
  }
}

TEST_CASE("daylight's color lies where the CIE has it, and below 4000 K is a black body's") {
  struct Known {
    double kelvin;
    Vec2 xy;  // CIE 15, the illuminants D50, D55, D65 and D75; of 25000 K by its formula
  };
  for (const auto& [kelvin, xy] :
       {Known{5000, {0.3457f, 0.3585f}}, Known{5500, {0.3324f, 0.3474f}}, Known{6500, {0.3127f, 0.3290f}},
        Known{7500, {0.2990f, 0.3149f}}, Known{24986, {0.2499f, 0.2548f}}}) {
    const Vec2 found = chromaticity(daylight_color(kelvin));
    CAPTURE(kelvin, found.x, found.y);
    CHECK(found.x == Approx(xy.x).margin(2e-4));
    CHECK(found.y == Approx(xy.y).margin(2e-4));
    CHECK(luminance(daylight_color(kelvin)) == Approx(1).epsilon(1e-3));
  }
  CHECK(daylight_color(3000) == blackbody_color(3000));
  CHECK(daylight_color(4000) != blackbody_color(4000));
}

TEST_CASE("matter of a constant spectrum is that grey, and light of one has the white of equal energy") {
  CHECK(matter_color(constant(0.25f)).r == Approx(0.25).epsilon(1e-6));
  CHECK(matter_color(constant(0.25f)).b == Approx(0.25).epsilon(1e-6));
  CHECK(luminous_mean(constant(1.5f)) == Approx(1.5).epsilon(1e-6));
  const Vec2 converted = chromaticity(light_color(constant(3)));
  CHECK(converted.x == Approx(1.0 / 3).margin(3e-4));
  CHECK(converted.y == Approx(1.0 / 3).margin(3e-4));
}

TEST_CASE("gold, copper, silver and aluminium have their known colors where light falls straight on them") {
  // Linear sRGB of their reflectance spectra at normal incidence under D65; red of gold is out of the gamut.
  // Channels of eta and k do not give the integral of a curved function of them: up to 0.05 is left.
  constexpr double of_channels = 0.05;
  struct Known {
    std::string metal;
    Rgb color;
  };
  for (const auto& [metal, color] :
       {Known{"Au", {1.00f, 0.782f, 0.343f}}, Known{"Cu", {0.955f, 0.638f, 0.538f}},
        Known{"Ag", {0.972f, 0.960f, 0.915f}}, Known{"Al", {0.913f, 0.922f, 0.924f}}}) {
    const Rgb found = reflectance_at_normal(named_spectrum("metal-" + metal + "-eta")->color,
                                            named_spectrum("metal-" + metal + "-k")->color);
    INFO(metal << ": " << found.r << " " << found.g << " " << found.b);
    CHECK(found.r == Approx(color.r).margin(of_channels));
    CHECK(found.g == Approx(color.g).margin(of_channels));
    CHECK(found.b == Approx(color.b).margin(of_channels));
  }
}

TEST_CASE("glass has its known index, and daylight is white") {
  CHECK(named_spectrum("glass-BK7")->color.g == Approx(1.5168).margin(2e-3));  // at 588 nm
  CHECK(named_spectrum("glass-F11")->color.g == Approx(1.7847).margin(7e-3));
  CHECK(named_spectrum("stdillum-D65")->color == Rgb{1, 1, 1});
  CHECK_FALSE(named_spectrum("metal-Pb-eta"));
}

TEST_CASE("a spectrum is linear between its wavelengths, and 0 beyond, but for an index of refraction") {
  const Spectrum spectrum{{400, 500, 700}, {1, 3, 2}};
  CHECK(spectrum.at(399) == 0);
  CHECK(spectrum.at(400) == 1);
  CHECK(spectrum.at(450) == 2);
  CHECK(spectrum.at(600) == 2.5f);
  CHECK(spectrum.at(700) == 2);
  CHECK(spectrum.at(701) == 0);
  const Rgb green = light_color({{500, 600}, {1, 1}}), dull = matter_color({{450, 650}, {0.5f, 0.5f}});
  CHECK(green.r == Approx(0.365).margin(0.01));
  CHECK(green.g == Approx(1.301).margin(0.01));
  CHECK(green.b == 0);
  const Rgb sodium = light_color({{589, 590}, {1, 1}});
  CHECK(sodium.r == Approx(2.80).margin(0.03));
  CHECK(sodium.g == Approx(0.578).margin(0.01));
  CHECK(dull.r == Approx(0.423).margin(0.01));
  CHECK(dull.g == Approx(0.535).margin(0.01));
  CHECK(dull.b == Approx(0.257).margin(0.01));
  CHECK(luminous_mean({{550, 560}, {1.5f, 1.5f}}) == Approx(1.5));
}

TEST_CASE("spectra come from files and lists, and what is wrong with them is named") {
  const test::PbrtTexts files{{"a.spd", "# nm, value\n400 0.5\n700 0.5\n"}, {"b.spd", "400 1\n400 2\n"}};
  const auto reflectance = [&](const std::string& value) {
    const LoadedScene loaded =
        test::load_pbrt_world("Material \"diffuse\" \"spectrum reflectance\" " + value, files);
    return std::get<Lambert>(loaded.scene.materials[1].model).reflectance;
  };
  CHECK(reflectance("\"a.spd\"").g == Approx(0.5).epsilon(5e-3));
  CHECK(reflectance("[ 300 .2 900 .2 ]").g == Approx(0.2).epsilon(1e-6));
  CHECK_THROWS_WITH(reflectance("\"b.spd\""),
                    Catch::StartsWith("b.spd:1:1: the wavelengths of this spectrum must "
                                      "increase; number 2 is 400, after 400"));
  CHECK_THROWS_WITH(reflectance("[ 300 .2 500 -.1 900 .2 ]"),
                    Catch::Contains("the values of this spectrum must not be negative, but for noise of a "
                                    "hundredth of the largest; number 2 is -0.1"));
  CHECK(reflectance("[ 300 .2 301 -.001 302 .2 900 .2 ]").g == Approx(0.2).epsilon(1e-6));
  CHECK_THROWS_WITH(reflectance("[ 300 .2 900 ]"),
                    Catch::Contains("a spectrum of 3 numbers; it needs pairs"));
  CHECK_THROWS_WITH(
      reflectance("\"metal-Au-etta\""),
      Catch::Contains("there is no spectrum \"metal-Au-etta\"; the nearest one is \"metal-Au-eta\""));
}

TEST_CASE("a float that stands for a color is in its range") {
  const auto loaded = [](const std::string& words) { return test::load_pbrt_world(words); };
  const auto reflects = loaded("Material \"diffuse\" \"float reflectance\" .25");
  CHECK(std::get<Lambert>(reflects.scene.materials[1].model).reflectance == Rgb{0.25f, 0.25f, 0.25f});
  for (const char* wrong : {"5", "-1"})
    CHECK_THROWS_WITH(loaded(std::string("Material \"diffuse\" \"float reflectance\" ") + wrong),
                      Catch::Contains("each must lie in [0, 1]"));
  for (const char* wrong :
       {"LightSource \"infinite\" \"float L\" -1", "LightSource \"point\" \"float I\" -10",
        "Material \"conductor\" \"float eta\" -2 \"float k\" 1",
        "MakeNamedMedium \"m\" \"string type\" \"homogeneous\" \"float sigma_a\" -1"})
    CHECK_THROWS_WITH(loaded(wrong), Catch::Contains("each must be at least 0"));
}

TEST_CASE("rgb of other color spaces is turned into sRGB, and white stays white") {
  for (const PbrtColorSpace space :
       {PbrtColorSpace::dci_p3, PbrtColorSpace::rec2020, PbrtColorSpace::aces2065_1}) {
    const Rgb converted = to_srgb({1, 1, 1}, space);
    CHECK(converted.r == Approx(1).epsilon(1e-5));
    CHECK(converted.g == Approx(1).epsilon(1e-5));
    CHECK(converted.b == Approx(1).epsilon(1e-5));
  }
  CHECK(to_srgb({0, 1, 0}, PbrtColorSpace::rec2020).r == 0);  // beyond what sRGB can give
  CHECK(color_space_named("REC2020") == PbrtColorSpace::rec2020);
  CHECK_FALSE(color_space_named("xyz"));
}

TEST_CASE("an Attribute's rgb is of the color space in which it stands, whatever comes later") {
  const auto reflectance = [](const std::string& text) {
    const LoadedScene loaded = test::load_pbrt_world(text + " Material \"diffuse\"");
    return std::get<Lambert>(loaded.scene.materials.at(1).model).reflectance;
  };
  const std::string color = " Attribute \"material\" \"rgb reflectance\" [ .3 .4 .5 ] ",
                    more = " Attribute \"material\" \"bool remaproughness\" false ",
                    wide = " ColorSpace \"rec2020\" ", srgb = " ColorSpace \"srgb\" ";
  CHECK(reflectance(color + wide) == Rgb{0.3f, 0.4f, 0.5f});
  CHECK(reflectance(color + wide + more) == Rgb{0.3f, 0.4f, 0.5f});
  CHECK(reflectance(wide + color + srgb) == to_srgb({0.3f, 0.4f, 0.5f}, PbrtColorSpace::rec2020));
  CHECK(reflectance(wide + color + srgb + more) == to_srgb({0.3f, 0.4f, 0.5f}, PbrtColorSpace::rec2020));
}

}  // namespace twinray
