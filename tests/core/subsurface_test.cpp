// SPDX-License-Identifier: Apache-2.0
#include "core/subsurface.h"

#include <cmath>

#include "core/bsdf.h"
#include "core/scene.h"
#include "tests/support/catch.h"
#include "tests/support/error_text.h"
#include "tests/support/lobe_checks.h"
#include "tests/support/scenes.h"

namespace twinray::test {
namespace {

constexpr Rgb skin{0.8f, 0.5f, 0.2f};

/// A white base of which all light that is diffuse goes below.
Principled principled(float specular_roughness) {
  return {.subsurface_weight = 1, .subsurface_color = skin, .specular_roughness = specular_roughness};
}

std::vector<SurfaceModel> models_with_a_base() {
  Principled layered = principled(0.4f);
  layered.base_diffuse_roughness = 0.4f;
  layered.coat_weight = 0.7f, layered.coat_roughness = 0.2f;
  layered.fuzz_weight = 0.4f;
  Principled mixed = principled(0.3f);
  mixed.base_metalness = 0.4f, mixed.transmission_weight = 0.3f;
  mixed.thin_film_weight = 1;
  Principled part = principled(0.3f);
  part.subsurface_weight = 0.4f;
  return {CoatedDiffuse{skin, {}, 1.5f},
          CoatedDiffuse{skin, {0.3f, 0.3f}, 1.33f},
          CoatedDiffuse{skin, {}, 1},
          principled(0.3f),
          layered,
          mixed,
          part};
}

}  // namespace

TEST_CASE("the albedo of one scattering is that of the reflectance that it makes") {
  for (const float g : {-0.5f, 0.0f, 0.8f}) {
    CHECK(single_scattering_albedo(0, g) == 0);
    CHECK(single_scattering_albedo(1, g) == 1);
    for (float r = 0.05f; r < 1; r += 0.05f)
      CHECK(diffuse_reflectance(single_scattering_albedo(r, g), g) == Approx(r).epsilon(1e-5));
  }
  // Light that is turned less must be scattered more often to come back.
  CHECK(single_scattering_albedo(0.5f, 0.8f) > single_scattering_albedo(0.5f, 0));
  CHECK(single_scattering_albedo(0.5f, -0.5f) < single_scattering_albedo(0.5f, 0));
}

TEST_CASE("a medium below has the mean way between scatterings that was asked for") {
  const Interior medium = medium_below({{0.5f, 2, 1}, 0.3f}, {1, 0.5f, 0});
  CHECK(medium.extinction() == Rgb{2, 0.5f, 1});
  CHECK(medium.absorption.r == 0);
  CHECK(medium.scattering.b == 0);
  CHECK(medium.scattering.g == Approx(0.5f * single_scattering_albedo(0.5f, 0.3f)));
  CHECK(medium.anisotropy == 0.3f);
}

TEST_CASE("of light that has entered a coat, so much comes out as was asked for") {
  for (const float ior : {1.0f, 1.33f, 2.0f})
    for (const float alpha : {0.0f, 0.4f}) {
      const CoatedDiffuse model{.roughness = {alpha, alpha}, .ior = ior};
      const Rgb base = base_of_emerging(model, {0, 0.3f, 1});
      CHECK(base.r == 0);
      CHECK(base.b == Approx(1));
      CHECK(base.g >= 0.3f);
      CHECK(emerging_of_base(model, base).g == Approx(0.3f));
      // What the lobe's base gives of the light that passes the coat.
      CoatedDiffuse filled = model;
      filled.reflectance = base;
      const CoatedDiffuseLobe lobe = *Bsdf(filled).as<CoatedDiffuseLobe>();
      const Vec3 wo = direction_at(0.7f);
      CHECK(lobe.below(wo).albedo.g == Approx(0.3f * lobe.coat().transmittance(wo)).epsilon(1e-5));
    }
}

TEST_CASE("a matte base has the albedo of its own part of the scattering function") {
  for (const SurfaceModel& model : models_with_a_base()) {
    Bsdf bsdf(model);
    for (const float cosine : {0.2f, 0.6f, 1.0f}) {
      CAPTURE(model.index(), cosine);
      const Vec3 wo = direction_at(cosine);
      bsdf.look_from(wo);
      const BelowSurface base = bsdf.below(wo);
      CHECK(base.reflectance == skin);
      double r = 0, g = 0;
      bool is_part = true;
      SphereGrid::visit(8, [&](const Vec3& wi, double area, std::size_t) {
        const Rgb value = bsdf.of_below(wo, wi), all = bsdf.evaluate(wo, wi).value;
        is_part = is_part && value.g <= all.g * (1 + 1e-5f);
        r += double(value.r * std::fabs(wi.z)) * area, g += double(value.g * std::fabs(wi.z)) * area;
      });
      CHECK(is_part);
      // Fits of coats and fuzz, and of the mean of rough ones.
      CHECK(r == Approx(base.albedo.r).epsilon(0.03));
      CHECK(g == Approx(base.albedo.g).epsilon(0.03));
    }
  }
  CHECK(Bsdf(Lambert{}).below({0, 0, 1}).probability == 0);
  CHECK(is_black(Bsdf(Lambert{}).of_below({0, 0, 1}, {0, 0, 1})));
  CHECK(is_black(Bsdf(Lambert{}).from_below({0, 0, 1})));
}

TEST_CASE("a draw takes a direction from the matte base where the base says so, and a cosine's density") {
  for (const SurfaceModel& model : models_with_a_base()) {
    CAPTURE(model.index());
    Bsdf bsdf(model);
    const Vec3 wo = direction_at(0.6f);
    bsdf.look_from(wo);
    const BelowSurface base = bsdf.below(wo);
    CHECK(base.probability > 0.1f);
    const Vec2 u{0.3f, 0.7f};
    const Vec3 matte = bsdf.sample(wo, base.first + 0.5f * base.probability, u).wi;
    CHECK(bsdf.sample(wo, base.first + 0.001f, u).wi == matte);
    CHECK(bsdf.sample(wo, base.first + 0.999f * base.probability, u).wi == matte);
    CHECK(bsdf.sample(wo, base.first + 0.5f * base.probability, u).is_diffuse);
    if (base.first > 0.01f) {
      const BsdfSample before = bsdf.sample(wo, base.first - 0.001f, u);
      CHECK((before.wi != matte || before.is_diffuse));
    }
  }
}

TEST_CASE("all light from below leaves the surface, whatever its base reflects") {
  for (SurfaceModel model : models_with_a_base()) {
    CAPTURE(model.index());
    const auto leaving = [&] {
      const Bsdf bsdf(model);
      double sum = 0;
      SphereGrid::visit(8, [&](const Vec3& wi, double area, std::size_t) {
        sum += double(bsdf.from_below(wi).g * std::fabs(wi.z)) * area;
      });
      return sum;
    };
    const double all = leaving();
    CHECK(all == Approx(1).epsilon(0.03));
    if (auto* const coated = std::get_if<CoatedDiffuse>(&model)) coated->reflectance = {};
    if (auto* const layered = std::get_if<Principled>(&model)) layered->subsurface_color = {};
    CHECK(leaving() == all);
  }
}

TEST_CASE("what goes below is the subsurface's part of the base, and no metal") {
  Principled model = principled(0.3f);
  model.base_color = {0.1f, 0.1f, 0.9f};
  const Vec3 wo = direction_at(0.6f), wi = direction_at(0.3f);
  const auto value = [&] { return Bsdf(model).evaluate(wo, wi).value; };
  const auto of_below = [&] { return Bsdf(model).of_below(wo, wi); };
  // Alone, it is the base of that colour.
  Principled diffuse{.base_color = skin};
  CHECK(value().r == Approx(Bsdf(diffuse).evaluate(wo, wi).value.r));
  CHECK(of_below().b == Approx(Bsdf(diffuse).diffuse(wo, wi).b));
  model.subsurface_weight = 0;
  CHECK(is_black(of_below()));
  CHECK(Bsdf(model).below(wo).probability == 0);
  model.base_metalness = 1, model.subsurface_weight = 1;
  CHECK(is_black(of_below()));
  const Rgb metal = value();
  model.subsurface_weight = 0;
  CHECK(value() == metal);
  // Of two of one colour, so much of the light goes below as the weight says.
  const auto probability = [&](float weight) {
    Principled two = principled(0.3f);
    two.base_color = skin, two.subsurface_weight = weight;
    return Bsdf(two).below(wo).probability;
  };
  CHECK(probability(0.25f) == Approx(0.25f * probability(1)));
  // Its shape is Lambert's, however rough the rest is.
  Principled rough = principled(0.3f);
  rough.base_diffuse_roughness = 1;
  CHECK(Bsdf(rough).evaluate(wo, wi).value == Bsdf(principled(0.3f)).evaluate(wo, wi).value);
}

TEST_CASE("a subsurface that is out of range, or has no base above it, is refused") {
  Scene scene = ball_under_sky(CoatedDiffuse{});
  const auto complaint = [&](const Subsurface& below) {
    scene.materials.back().subsurface = below;
    return error_text([&] { check_scene(scene); });
  };
  CHECK(complaint({{1, 1, 1}}).empty());
  CHECK(complaint({{1, 0, 1}}) ==
        "material 0 has a subsurface of the radius 1 0 1; each must be finite and > 0");
  CHECK(complaint({{1, INFINITY, 1}}).find("each must be finite") != std::string::npos);
  CHECK(complaint({{1, 1, 1}, 0.995f}) ==
        "material 0 has a subsurface of the anisotropy 0.995; valid are -0.99 to 0.99");
  scene.materials.back().model = Lambert{};
  CHECK(complaint({{1, 1, 1}}) == "material 0 has a subsurface, and its model has no base above it");
  scene.materials.back().model = Principled{.geometry_thin_walled = true};
  CHECK(complaint({{1, 1, 1}}) == "material 0 has a subsurface, and its model has no base above it");
}

}  // namespace twinray::test
