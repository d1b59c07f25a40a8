// SPDX-License-Identifier: Apache-2.0
#include "core/lobes/principled.h"

#include <cmath>

#include "core/bsdf.h"
#include "core/lobes/coated_diffuse.h"
#include "core/shading_map.h"
#include "tests/support/lobe_checks.h"
#include "tests/support/principled_models.h"

namespace twinray::test {
namespace {

const float cosines[] = {1.0f, 0.6f, 0.2f};

}  // namespace

TEST_CASE("a principled surface is sampled with its density") {
  for (const Principled& m :
       {Principled{}, varnished(), brushed(), clear(), sheet(), oiled(), anodised(), iridescent()})
    for (const bool is_inside : {false, true})
      for (const float cosine : cosines) {
        CAPTURE(m.coat_weight, m.transmission_weight, is_inside, cosine);
        check_sampling(PrincipledLobe(m, is_inside), direction_at(cosine), 30, 16);
      }
}

TEST_CASE("what a principled surface reflects is reciprocal") {
  Random random(3);
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
      const Rgb albedo = sampled_albedo(PrincipledLobe(each.model, false), direction_at(cosine));
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
        CHECK(sampled_albedo(PrincipledLobe(layered, false), direction_at(cosine)).g ==
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
        const Rgb albedo = sampled_albedo(lobe, direction_at(cosine), 40000);
        CHECK(max_component(albedo) < 1.03f);
        CHECK(max_component(albedo) > 0.2f);
        if (!is_inside && cosine == 0.6f) CHECK(lobe.albedo().g == Approx(albedo.g).epsilon(0.25));
      }
}

TEST_CASE("what a principled surface works out for one direction changes no bit, there or elsewhere") {
  Random random(11);
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

TEST_CASE("what a smooth coat mirrors passes the fuzz above it once, along its angle") {
  Principled dark;
  dark.base_weight = dark.specular_weight = 0;
  dark.coat_weight = dark.fuzz_weight = 1;
  dark.coat_roughness = 0;
  const Coat coat(dark.coat_ior, Ggx(least_alpha));
  const Fuzz fuzz(dark.fuzz_roughness);
  for (const float cosine : cosines) {
    const float scattered = fuzz.reflectance(cosine);
    const float expected = scattered + (1 - scattered) * coat.reflectance(cosine);
    CAPTURE(cosine, scattered);
    CHECK(sampled_albedo(PrincipledLobe(dark, false), direction_at(cosine)).g ==
          Approx(expected).margin(0.01));
  }
}

TEST_CASE("light that goes through a coated body passes the coat once") {
  Principled bare;
  bare.transmission_weight = 1;
  Principled coated = bare;
  coated.specular_roughness = coated.coat_roughness = 0.3f;
  coated.coat_weight = 1, coated.coat_ior = 1.5f, coated.coat_darkening = 0;
  // As rough as the coat makes it.
  bare.specular_roughness = std::pow(std::pow(0.3f, 4.0f) * 3, 0.25f);
  const Coat coat(1.5f, Ggx(0.3f * 0.3f));
  for (const float cosine : cosines) {
    const Vec3 wo = direction_at(cosine), wi = flipped(direction_at(0.8f));
    const Rgb through = PrincipledLobe(coated, false).evaluate(wo, wi).value;
    const Rgb expected = PrincipledLobe(bare, false).evaluate(wo, wi).value * coat.transmittance(wo);
    CHECK(through.g > 0);
    CHECK(through.g == Approx(expected.g).epsilon(1e-4));
  }
}

TEST_CASE("at the ends of its weights a principled surface is one of the simple models") {
  Random random(5);
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
    for (const Vec3& w : {wi, flipped(wi)}) {
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
    CHECK(sampled_albedo(PrincipledLobe(m, false), direction_at(1)).g == Approx(root * root).epsilon(2e-3));
  }
}

TEST_CASE("weights of a principled surface do what they say") {
  const Vec3 wo = direction_at(0.7f);
  const auto albedo = [&](const Principled& m) { return sampled_albedo(PrincipledLobe(m, false), wo); };
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

}  // namespace twinray::test
