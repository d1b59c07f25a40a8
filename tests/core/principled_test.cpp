// SPDX-License-Identifier: Apache-2.0
#include "core/lobes/principled.h"

#include <cmath>

#include "core/bsdf.h"
#include "core/lobes/coated_diffuse.h"
#include "core/shading_map.h"
#include "tests/support/lobe_checks.h"

namespace twinray {
namespace {

using test::direction_at;

const float cosines[] = {1.0f, 0.6f, 0.2f};

Principled varnished() {
  Principled m;
  m.base_color = {0.7f, 0.3f, 0.1f};
  m.base_diffuse_roughness = 0.4f;
  m.base_metalness = 0.3f;
  m.specular_roughness = 0.6f;
  m.specular_color = {0.9f, 0.8f, 1};
  m.coat_weight = 0.7f;
  m.coat_color = {1, 0.9f, 0.6f};
  m.coat_roughness = 0.5f;
  m.fuzz_weight = 0.5f;
  m.fuzz_color = {0.8f, 0.2f, 0.9f};
  return m;
}

Principled brushed() {
  Principled m;
  m.base_metalness = 1;
  m.specular_roughness = 0.6f;
  m.specular_roughness_anisotropy = 0.7f;
  return m;
}

Principled clear() {
  Principled m;
  m.transmission_weight = 0.8f;
  m.transmission_color = {0.5f, 0.9f, 0.7f};
  m.specular_roughness = 0.7f;
  m.coat_weight = 0.5f;
  m.coat_roughness = 0.6f;
  return m;
}

Principled sheet() {
  Principled m = clear();
  m.geometry_thin_walled = true;
  return m;
}

/// A film on gloss.
Principled oiled() {
  Principled m;
  m.base_color = {0.4f, 0.3f, 0.5f};
  m.specular_roughness = 0.5f;
  m.thin_film_weight = 1;
  m.thin_film_thickness = 0.35f;
  m.thin_film_ior = 1.8f;
  return m;
}

/// A film on a metal, below a coat.
Principled anodised() {
  Principled m = oiled();
  m.base_color = {0.8f, 0.7f, 0.6f};
  m.base_metalness = 1;
  m.thin_film_weight = 0.8f;
  m.coat_weight = 0.5f;
  m.coat_roughness = 0.5f;
  return m;
}

Principled bubble() {
  Principled m = oiled();
  m.specular_ior = 1;
  m.thin_film_ior = 1.33f;
  m.transmission_weight = 1;
  m.geometry_thin_walled = true;
  return m;
}

/// Denser than the tables of reflectances reach.
Principled dense() {
  Principled m;
  m.specular_ior = 10;
  m.specular_roughness = 0.7f;
  return m;
}

/// A film on the boundary of a clear body.
Principled iridescent() {
  Principled m = clear();
  m.thin_film_weight = 0.9f;
  m.thin_film_thickness = 0.35f;
  m.thin_film_ior = 2;
  return m;
}

/// Nothing of it absorbs.
Principled whitened(Principled m) {
  m.base_color = m.specular_color = m.transmission_color = m.coat_color = m.fuzz_color = white;
  return m;
}

}  // namespace

TEST_CASE("a principled surface is sampled with its density") {
  for (const Principled& m :
       {Principled{}, varnished(), brushed(), clear(), sheet(), oiled(), anodised(), iridescent()})
    for (const bool is_inside : {false, true})
      for (const float cosine : cosines) {
        CAPTURE(m.coat_weight, m.transmission_weight, is_inside, cosine);
        test::check_sampling(PrincipledLobe(m, is_inside), direction_at(cosine), 30, 24);
      }
}

TEST_CASE("what a principled surface reflects is reciprocal") {
  test::Random random(3);
  for (const Principled& m :
       {Principled{}, varnished(), brushed(), clear(), oiled(), anodised(), iridescent()}) {
    const PrincipledLobe lobe(m, false);
    for (int i = 0; i < 200; ++i) {
      Vec3 wo = normalize(random.in_ball()), wi = normalize(random.in_ball());
      wo.z = std::fabs(wo.z), wi.z = std::fabs(wi.z);
      const Rgb there = lobe.evaluate(wo, wi).value, back = lobe.evaluate(wi, wo).value;
      CHECK(there.g == Approx(back.g).epsilon(1e-4));
      CHECK(there.b == Approx(back.b).epsilon(1e-4));
    }
  }
}

TEST_CASE("a white principled surface passes the furnace within what its layers' fits lose") {
  Principled coated_metal = whitened(brushed());
  coated_metal.coat_weight = 1;
  struct Case {
    Principled model;
    double error;
  };
  const Case cases[] = {
      {whitened(Principled{}), 0.01}, {whitened(brushed()), 0.06},  {whitened(varnished()), 0.05},
      {whitened(clear()), 0.05},      {whitened(sheet()), 0.03},    {coated_metal, 0.08},
      {whitened(oiled()), 0.02},      {whitened(anodised()), 0.08}, {whitened(bubble()), 0.01},
      {whitened(iridescent()), 0.05}, {whitened(dense()), 0.03}};
  for (const Case& each : cases)
    for (const float cosine : cosines) {
      CAPTURE(each.error, cosine);
      const Rgb albedo = test::sampled_albedo(PrincipledLobe(each.model, false), direction_at(cosine));
      CHECK(std::fabs(albedo.r - 1) <= each.error);
      CHECK(std::fabs(albedo.g - 1) <= each.error);
      CHECK(std::fabs(albedo.b - 1) <= each.error);
    }
}

TEST_CASE("white mirrors, gloss and sheets pass the furnace below smooth layers") {
  Principled base;
  base.base_color = base.fuzz_color = white;
  base.specular_roughness = base.coat_roughness = 0;
  Principled metal = base, clear_sheet = base;
  metal.base_metalness = 1;
  clear_sheet.transmission_weight = 1;
  clear_sheet.geometry_thin_walled = true;
  for (Principled model : {base, metal, clear_sheet}) {
    Principled coated = model, dusty = model;
    coated.coat_weight = 1;
    coated.coat_ior = 1.3f;
    dusty.fuzz_weight = 0.7f;
    for (const Principled& layered : {coated, dusty})
      for (const float cosine : {1.0f, 0.6f, 0.3f, 0.1f})
        CHECK(test::sampled_albedo(PrincipledLobe(layered, false), direction_at(cosine)).g ==
              Approx(1).margin(0.015));
  }
}

TEST_CASE("no principled surface scatters more than arrives, nor stays black where it is not") {
  for (const Principled& m :
       {Principled{}, varnished(), brushed(), clear(), sheet(), oiled(), anodised(), iridescent()})
    for (const bool is_inside : {false, true})
      for (const float cosine : cosines) {
        CAPTURE(m.coat_weight, m.transmission_weight, is_inside, cosine);
        const PrincipledLobe lobe(m, is_inside);
        const Rgb albedo = test::sampled_albedo(lobe, direction_at(cosine), 40000);
        CHECK(max_component(albedo) < 1.03f);
        CHECK(max_component(albedo) > 0.2f);
        if (!is_inside && cosine == 0.6f) CHECK(lobe.albedo().g == Approx(albedo.g).epsilon(0.25));
      }
}

TEST_CASE("what a principled surface works out for one direction changes no bit, there or elsewhere") {
  test::Random random(11);
  for (const Principled& m :
       {Principled{}, varnished(), brushed(), clear(), sheet(), oiled(), anodised(), iridescent()})
    for (const bool is_inside : {false, true}) {
      const PrincipledLobe fresh(m, is_inside);
      PrincipledLobe looked = fresh;
      for (int i = 0; i < 50; ++i) {
        Vec3 wo = normalize(random.in_ball());
        if (i > 0) wo.z = std::fabs(wo.z);  // The first looks from behind.
        looked.look_from(wo);
        const Vec3 wi = normalize(random.in_ball());
        const Vec3 elsewhere{-wo.x, wo.y, std::fabs(wo.z)};
        const float lobe = random.unit();
        const Vec2 u{random.unit(), random.unit()};
        for (const Vec3& from : {wo, elsewhere}) {
          CAPTURE(i, is_inside, from.z);
          CHECK(looked.evaluate(from, wi).value == fresh.evaluate(from, wi).value);
          CHECK(looked.evaluate(from, wi).pdf == fresh.evaluate(from, wi).pdf);
          CHECK(looked.diffuse(from, wi) == fresh.diffuse(from, wi));
          const BsdfSample sample = fresh.sample(from, lobe, u), again = looked.sample(from, lobe, u);
          CHECK(again.wi == sample.wi);
          CHECK(again.value == sample.value);
          CHECK(again.pdf == sample.pdf);
        }
      }
    }
}

TEST_CASE("at the ends of its weights a principled surface is one of the simple models") {
  test::Random random(5);
  for (int i = 0; i < 100; ++i) {
    Vec3 wo = normalize(random.in_ball()), wi = normalize(random.in_ball());
    wo.z = std::fabs(wo.z), wi.z = std::fabs(wi.z);
    const auto same = [](const Rgb& a, const Rgb& b) {
      CHECK(a.r == Approx(b.r).epsilon(1e-4));
      CHECK(a.b == Approx(b.b).epsilon(1e-4));
    };
    Principled matte;
    matte.base_color = {0.2f, 0.4f, 0.6f};
    matte.specular_weight = 0;
    same(PrincipledLobe(matte, false).evaluate(wo, wi).value, matte.base_color * (1 / pi));
    matte.base_diffuse_roughness = 0.5f;
    same(PrincipledLobe(matte, false).evaluate(wo, wi).value,
         matte.base_color * RoughDiffuseLobe(white, 0.5f).evaluate(wo, wi).value);

    // Gloss over it, and the same as a coat.
    Principled glossy;
    glossy.base_color = matte.base_color;
    const Ggx facets(0.3f * 0.3f);
    same(PrincipledLobe(glossy, false).evaluate(wo, wi).value,
         CoatedDiffuseLobe(Coat(1.5f, facets), matte.base_color).evaluate(wo, wi).value);
    Principled coated = matte;
    coated.base_diffuse_roughness = 0;
    coated.coat_weight = 1;
    coated.coat_ior = 1.5f;
    coated.coat_roughness = 0.3f;
    same(PrincipledLobe(coated, false).evaluate(wo, wi).value,
         CoatedDiffuseLobe(Coat(1.5f, facets), matte.base_color).evaluate(wo, wi).value);

    Principled glass;
    glass.transmission_weight = 1;
    glass.transmission_color = {0.5f, 0.6f, 0.7f};
    const RoughDielectricLobe outside(facets, 1.5f, white, glass.transmission_color);
    const RoughDielectricLobe inside(facets, 1 / 1.5f, white, glass.transmission_color);
    for (const Vec3& w : {wi, test::flipped(wi)}) {
      same(PrincipledLobe(glass, false).evaluate(wo, w).value, outside.evaluate(wo, w).value);
      same(PrincipledLobe(glass, true).evaluate(wo, w).value, inside.evaluate(wo, w).value);
    }
  }
}

TEST_CASE("a principled metal has its colour along the normal and its tint near the rim") {
  const Rgb normal{0.9f, 0.5f, 0.2f}, rim{1, 0.5f, 0.8f};
  const TintedFresnel fresnel(normal, rim);
  CHECK(fresnel(1).g == Approx(0.5));
  CHECK(fresnel(0).g == Approx(1));
  constexpr float c = 1.0f / 7;
  const float schlick = 0.5f + 0.5f * std::pow(1 - c, 5.0f);
  CHECK(fresnel(c).g == Approx(0.5f * schlick));
  CHECK(fresnel(c).r == Approx(0.9f + 0.1f * std::pow(1 - c, 5.0f)));
  double sum = 0;
  for (int i = 0; i < 1000; ++i) {
    const float cosine = (float(i) + 0.5f) / 1000;
    sum += 2 * cosine * fresnel(cosine).b / 1000;
  }
  CHECK(fresnel.average().b == Approx(sum).epsilon(1e-3));
  CHECK(TintedFresnel({}, {}).average() == Rgb{});
}

TEST_CASE("gloss reflects by Fresnel's equations along the normal, however dense it is") {
  for (const float ior : {1.5f, 10.0f, 100.0f, 1000.0f}) {
    const Principled m{.base_color = {}, .specular_roughness = 0, .specular_ior = ior};
    const float root = (ior - 1) / (ior + 1);
    CHECK(test::sampled_albedo(PrincipledLobe(m, false), direction_at(1)).g ==
          Approx(root * root).epsilon(2e-3));
  }
}

TEST_CASE("weights of a principled surface do what they say") {
  const Vec3 wo = direction_at(0.7f);
  const auto albedo = [&](const Principled& m) { return test::sampled_albedo(PrincipledLobe(m, false), wo); };
  Principled m;
  m.base_color = {0.4f, 0.4f, 0.4f};
  Principled darker = m, lacquered = m, dusty = m;
  darker.base_weight = 0.5f;
  CHECK(albedo(darker).g < 0.75f * albedo(m).g);
  lacquered.coat_weight = 1;
  lacquered.coat_color = {1, 0.5f, 0.5f};
  CHECK(albedo(lacquered).g < 0.7f * albedo(lacquered).r);
  Principled undarkened = lacquered;
  undarkened.coat_darkening = 0;
  CHECK(albedo(undarkened).r > 1.05f * albedo(lacquered).r);
  dusty.fuzz_weight = 1;
  dusty.fuzz_color = {0, 1, 0};
  CHECK(albedo(dusty).g > albedo(dusty).r + 0.1f);
}

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
      sum += test::sampled_albedo(PrincipledLobe(m, false), direction_at(cosine), 20000).g / parts;
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
    return test::sampled_albedo(PrincipledLobe(m, false), direction_at(0.3f), 20000).g;
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

TEST_CASE("the facets of a brushed principled surface have a direction") {
  CHECK(is_anisotropic(brushed()));
  CHECK_FALSE(is_anisotropic(clear()));
}

TEST_CASE("a principled surface lets light in where it transmits, is no metal and no sheet") {
  Principled m;
  CHECK_FALSE(lets_light_in(m));
  m.transmission_weight = 0.5f;
  CHECK(lets_light_in(m));
  m.geometry_thin_walled = true;
  CHECK_FALSE(lets_light_in(m));
  m.geometry_thin_walled = false;
  m.base_metalness = 1;
  CHECK_FALSE(lets_light_in(m));
}

}  // namespace twinray
