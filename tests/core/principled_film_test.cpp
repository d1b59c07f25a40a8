// SPDX-License-Identifier: Apache-2.0
// Thin films on a principled surface.
#include <cmath>

#include "core/bsdf.h"
#include "core/lobes/principled.h"
#include "core/thin_film.h"
#include "tests/support/lobe_checks.h"
#include "tests/support/principled_models.h"

namespace twinray::test {

TEST_CASE("a film of no thickness changes nothing") {
  Principled varnished_oil = oiled();  // A coat that is denser than the film.
  varnished_oil.coat_weight = 1;
  varnished_oil.thin_film_ior = 1.4f;
  for (Principled filmed : {oiled(), anodised(), varnished_oil, iridescent()}) {
    filmed.thin_film_thickness = 0;
    Principled bare = filmed;
    bare.thin_film_weight = 0;
    const PrincipledLobe with(filmed, false), without(bare, false);
    CHECK(with.albedo().g == Approx(without.albedo().g).epsilon(0.02));
    for (const float cosine : {1.0f, 0.7f, 0.3f, 0.1f}) {
      const Vec3 wo = direction_at(cosine), mirrored{-wo.x, -wo.y, wo.z};
      const Rgb a = with.evaluate(wo, mirrored).value, b = without.evaluate(wo, mirrored).value;
      CAPTURE(filmed.thin_film_ior, cosine);
      CHECK(a.r == Approx(b.r).epsilon(0.01).margin(1e-3));
      CHECK(a.b == Approx(b.b).epsilon(0.01).margin(1e-3));
    }
  }
}

TEST_CASE("a film is on all facets that light meets, and in the albedo") {
  Principled rough_metal =
      oiled();  // Its film lets nearly all green light in, and much meets several facets.
  rough_metal.base_color = {0.5f, 0.5f, 0.5f};
  rough_metal.base_metalness = 1;
  rough_metal.specular_roughness = 1;
  rough_metal.thin_film_ior = 2.2f;
  rough_metal.thin_film_thickness = 0.06f;
  Principled bare = rough_metal;
  bare.thin_film_weight = 0;
  Principled black = oiled();
  black.base_color = {};
  const auto scattered = [](const Principled& m) {
    constexpr int parts = 16;
    float sum = 0;
    for (int i = 0; i < parts; ++i) {
      const float cosine = std::sqrt((float(i) + 0.5f) / parts);
      sum += sampled_albedo(PrincipledLobe(m, false), direction_at(cosine), 20000).g / parts;
    }
    return sum;
  };
  // With light that meets several facets as if these had none it would be 0.38 of it.
  CHECK(scattered(rough_metal) < 0.15f * scattered(bare));
  CHECK(PrincipledLobe(black, false).albedo().g == Approx(scattered(black)).epsilon(0.05));
}

TEST_CASE("a film on what is half a metal is half of that on metal and half of that on gloss") {
  const Vec3 normal{0, 0, 1};
  const auto value = [&](float metalness) {
    Principled m = oiled();
    m.base_metalness = metalness;
    return PrincipledLobe(m, false).evaluate(normal, normal).value.g;
  };
  CHECK(value(0.5f) == Approx((value(0) + value(1)) / 2).epsilon(1e-5));
}

TEST_CASE("no film reflects all light from air, however dense the coat above it") {
  Principled dark = oiled();
  dark.base_color = {};
  dark.thin_film_ior = 1.4f;
  dark.coat_weight = 1;
  dark.coat_ior = 2;
  Principled bare = dark;
  bare.thin_film_weight = 0;
  const auto albedo = [](const Principled& m) {
    return sampled_albedo(PrincipledLobe(m, false), direction_at(0.3f), 20000).g;
  };
  CHECK(albedo(dark) < albedo(bare) + 0.08f);  // It would be 0.17 above.
}

TEST_CASE("a film gives gloss, metals and sheets colours that change with the angle") {
  for (const Principled& model : {oiled(), anodised()}) {
    Principled bare = model;
    bare.thin_film_weight = 0;
    Principled half = model;
    half.thin_film_weight = model.thin_film_weight / 2;
    const Vec3 normal{0, 0, 1};
    const Rgb filmed = PrincipledLobe(model, false).evaluate(normal, normal).value;
    const Rgb plain = PrincipledLobe(bare, false).evaluate(normal, normal).value;
    CHECK(max_component(filmed - plain) > 0.02f * max_component(plain));
    const Rgb mean = (filmed + plain) / 2, mixed = PrincipledLobe(half, false).evaluate(normal, normal).value;
    CHECK(mixed.g == Approx(mean.g).epsilon(0.02));
    // From within there is no film.
    const Vec3 wo = direction_at(0.7f);
    CHECK(PrincipledLobe(model, true).evaluate(wo, wo).value ==
          PrincipledLobe(bare, true).evaluate(wo, wo).value);
  }
  // On a boundary that light goes through there is one, and from within it is the same.
  Principled glass = iridescent(), plain_glass = glass;
  plain_glass.thin_film_weight = 0;
  const Vec3 down{0, 0, -1}, up{0, 0, 1};
  for (const bool is_inside : {false, true}) {
    const Rgb filmed = PrincipledLobe(glass, is_inside).evaluate(up, down).value;
    const Rgb plain = PrincipledLobe(plain_glass, is_inside).evaluate(up, down).value;
    CHECK(filmed.g < 0.97f * plain.g);
    CHECK(filmed.b / filmed.g != Approx(plain.b / plain.g).epsilon(0.01));
  }
  // Air within and without: all that a bubble reflects its film does. Glass has two sides.
  const auto reflected = [](const Principled& model, float cosine) {
    const BsdfSample sample = PrincipledLobe(model, false).sample(direction_at(cosine), 0, {0.5f, 0.5f});
    REQUIRE(sample.wi.z > 0);
    return sample.value * sample.wi.z;
  };
  Principled pane = bubble();
  pane.specular_ior = 1.5f;
  const auto pane_of = [](float once) { return 2 * once / (1 + once); };
  for (const float cosine : {1.0f, 0.5f}) {
    const Rgb film = ThinFilm(350, 1.33f).reflectance(cosine, white), found = reflected(bubble(), cosine);
    CHECK(found.r == Approx(film.r).epsilon(1e-4));
    CHECK(found.b == Approx(film.b).epsilon(1e-4));
    const Rgb side = ThinFilm(350, 1.33f).reflectance(cosine, white * 1.5f);
    CHECK(reflected(pane, cosine).g == Approx(pane_of(side.g)).epsilon(1e-3));
  }
  Principled body = bubble();
  body.geometry_thin_walled = false;
  CHECK(reflected(body, 0.5f) == reflected(bubble(), 0.5f));
}

}  // namespace twinray::test
