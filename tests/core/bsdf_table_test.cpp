// SPDX-License-Identifier: Apache-2.0
#include "core/bsdf_table.h"

#include <memory>

#include "tests/support/catch.h"
#include "tests/support/random.h"

namespace twinray::test {
namespace {

constexpr Side sides[] = {Side::outside, Side::inside};
constexpr Materials all_materials[] = {Materials::exact, Materials::regularized};

Scene scene_with_materials(std::vector<Material> materials) {
  Scene scene;
  scene.materials = std::move(materials);
  return scene;
}

SurfacePoint point_of(Vec2 uv) {
  SurfacePoint point;
  point.uv = uv;
  return point;
}

/// Whether they scatter alike, as far as one sample and what it says can tell.
bool are_alike(const Bsdf& a, const Bsdf& b, Random& random) {
  const Vec3 up = normalize(random.in_ball());
  const Vec3 wo = up.z > 0 ? up : -up;
  const float lobe = random.unit(), x = random.unit(), y = random.unit();
  const BsdfSample first = a.sample(wo, lobe, {x, y}), second = b.sample(wo, lobe, {x, y});
  return first.wi == second.wi && first.value == second.value && first.pdf == second.pdf &&
         first.eta == second.eta && a.evaluate(wo, first.wi).value == b.evaluate(wo, first.wi).value &&
         a.evaluate(wo, first.wi).pdf == b.evaluate(wo, first.wi).pdf && a.albedo() == b.albedo();
}

}  // namespace

TEST_CASE("a table has the scattering function of each material, side and kind") {
  const Scene scene = scene_with_materials({{"chalk", Lambert{}},
                                            {"glass", Glass{}},
                                            {"frosted", Dielectric{.roughness = {0.2f, 0.3f}}},
                                            {"gold", Conductor{}},
                                            {"varnish", CoatedDiffuse{}}});
  const BsdfTable table(scene);
  Random random(1);
  for (std::uint32_t material = 0; material < scene.materials.size(); ++material)
    for (const Side side : sides)
      for (const Materials materials : all_materials) {
        const SurfaceModel& model = scene.materials[material].model;
        const Bsdf expected(materials == Materials::exact ? model : regularized(model), side);
        CAPTURE(material, int(side), int(materials));
        for (int i = 0; i < 20; ++i)
          CHECK(are_alike(*table.at(material, {}, side, {materials}), expected, random));
      }
}

TEST_CASE("a function that looks from a direction scatters as before, and so does what it was copied to") {
  const Scene scene =
      scene_with_materials({{"gold", Conductor{}}, {"paint", Principled{.coat_weight = 0.5f}}});
  const BsdfTable table(scene);
  Random random(2);
  for (std::uint32_t material = 0; material < scene.materials.size(); ++material) {
    const Bsdf expected(scene.materials[material].model);
    BsdfAt looking = table.at(material, {}, Side::outside);
    for (int i = 0; i < 20; ++i) {
      looking.look_from(normalize(Vec3{random.unit(), random.unit(), 0.1f}));
      const BsdfAt copy = looking;
      CHECK(are_alike(*looking, expected, random));
      CHECK(are_alike(*copy, expected, random));
    }
  }
}

TEST_CASE("a function of a table is kept where the table goes") {
  const Scene scene = scene_with_materials({{"gold", Conductor{}}});
  auto table = std::make_unique<BsdfTable>(scene);
  BsdfAt kept = table->at(0, {}, Side::outside);
  CHECK(&*kept == &*table->at(0, {}, Side::outside));
  kept.keep();
  CHECK(&*kept != &*table->at(0, {}, Side::outside));
  table.reset();
  Random random(3);
  for (int i = 0; i < 20; ++i) CHECK(are_alike(*kept, Bsdf(Conductor{}), random));
}

TEST_CASE("where a texture has a part in a material, its function is that of the point") {
  Scene scene = scene_with_materials({{"squares", CoatedDiffuse{}}});
  const Rgb red{1, 0, 0}, blue{0, 0, 1};
  scene.textures = {{"", ConstantTexture{red}}, {"", ConstantTexture{blue}}, {"", CheckerboardTexture{0, 1}}};
  scene.materials[0].textures = {{MaterialInput::reflectance, 2}};
  const BsdfTable table(scene);
  Random random(2);
  for (const Side side : sides)
    for (const Materials materials : all_materials)
      for (const auto& [u, color] : {std::pair{0.5f, red}, {1.5f, blue}}) {
        const SurfaceModel model = CoatedDiffuse{.reflectance = color};
        const Bsdf expected(materials == Materials::exact ? model : regularized(model), side);
        CHECK(are_alike(*table.at(0, point_of({u, 0.5f}), side, {materials}), expected, random));
      }
}

TEST_CASE("within something else, the function is that of a boundary to it, or of none") {
  Scene scene = scene_with_materials({{"glass", Glass{.ior = 1.5f}}, {"water", Glass{.ior = 1.25f}}});
  scene.materials[0].interior.priority = 1;
  scene.materials[1].interior.priority = 2;
  const BsdfTable table(scene);
  Random random(3);
  Viewing viewing;
  viewing.interiors.enter(1);
  for (int i = 0; i < 20; ++i) {
    CHECK(are_alike(*table.at(0, {}, Side::outside, viewing), Bsdf(Interface{}), random));
    CHECK(
        are_alike(*table.at(1, {}, Side::inside, viewing), Bsdf(Glass{.ior = 1.25f}, Side::inside), random));
  }
  viewing.interiors = {};
  viewing.interiors.enter(0);
  for (const Materials materials : all_materials) {
    viewing.materials = materials;
    const SurfaceModel model = Glass{.ior = 1.25f / 1.5f};
    const Bsdf expected(materials == Materials::exact ? model : regularized(model), Side::outside);
    for (int i = 0; i < 20; ++i) CHECK(are_alike(*table.at(1, {}, Side::outside, viewing), expected, random));
  }
}

}  // namespace twinray::test
