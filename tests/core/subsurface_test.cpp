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

std::vector<SurfaceModel> models_with_a_base() {
  Principled layered{.base_color = skin, .base_diffuse_roughness = 0.4f, .specular_roughness = 0.4f};
  layered.coat_weight = 0.7f, layered.coat_roughness = 0.2f;
  layered.fuzz_weight = 0.4f;
  Principled mixed{.base_color = skin, .base_metalness = 0.4f, .transmission_weight = 0.3f};
  mixed.thin_film_weight = 1;
  return {CoatedDiffuse{skin, {}, 1.5f},
          CoatedDiffuse{skin, {0.3f, 0.3f}, 1.33f},
          CoatedDiffuse{skin, {}, 1},
          Principled{.base_color = skin},
          layered,
          mixed};
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
      CHECK(lobe.matte_base(wo).albedo.g == Approx(0.3f * lobe.coat().transmittance(wo)).epsilon(1e-5));
    }
}

TEST_CASE("a matte base has the albedo of its own part of the scattering function") {
  for (const SurfaceModel& model : models_with_a_base()) {
    Bsdf bsdf(model);
    for (const float cosine : {0.2f, 0.6f, 1.0f}) {
      CAPTURE(model.index(), cosine);
      const Vec3 wo = direction_at(cosine);
      bsdf.look_from(wo);
      const MatteBase base = bsdf.matte_base(wo);
      CHECK(base.reflectance == skin);
      double r = 0, g = 0;
      bool is_part = true;
      SphereGrid::visit(8, [&](const Vec3& wi, double area, std::size_t) {
        const Rgb value = bsdf.of_matte_base(wo, wi), all = bsdf.evaluate(wo, wi).value;
        is_part = is_part && value.g <= all.g * (1 + 1e-5f);
        r += double(value.r * std::fabs(wi.z)) * area, g += double(value.g * std::fabs(wi.z)) * area;
      });
      CHECK(is_part);
      // Fits of coats and fuzz, and of the mean of rough ones.
      CHECK(r == Approx(base.albedo.r).epsilon(0.03));
      CHECK(g == Approx(base.albedo.g).epsilon(0.03));
    }
  }
  CHECK(Bsdf(Lambert{}).matte_base({0, 0, 1}).probability == 0);
  CHECK(is_black(Bsdf(Lambert{}).of_matte_base({0, 0, 1}, {0, 0, 1})));
}

TEST_CASE("a draw takes a direction from the matte base where the base says so, and a cosine's density") {
  for (const SurfaceModel& model : models_with_a_base()) {
    CAPTURE(model.index());
    Bsdf bsdf(model);
    const Vec3 wo = direction_at(0.6f);
    bsdf.look_from(wo);
    const MatteBase base = bsdf.matte_base(wo);
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
  CHECK(complaint({{1, 1, 1}, 0, 1.5f}) == "material 0 has a subsurface of the weight 1.5; valid are 0 to 1");
  scene.materials.back().model = Lambert{};
  CHECK(complaint({{1, 1, 1}}) == "material 0 has a subsurface, and its model has no base above it");
  scene.materials.back().model = Principled{.geometry_thin_walled = true};
  CHECK(complaint({{1, 1, 1}}) == "material 0 has a subsurface, and its model has no base above it");
}

}  // namespace twinray::test
