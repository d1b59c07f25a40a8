// SPDX-License-Identifier: Apache-2.0
#include "core/interiors.h"

#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/scene.h"
#include "tests/support/catch.h"

namespace twinray::test {
namespace {

Interiors within(std::initializer_list<std::uint32_t> materials) {
  Interiors interiors;
  for (const std::uint32_t material : materials) interiors.enter(material);
  return interiors;
}

Material glass(float ior, int priority, const Rgb& absorption = {}) {
  Material material{"glass", Dielectric{ior}};
  material.interior = {absorption, priority};
  return material;
}

}  // namespace

TEST_CASE("interiors are left in whatever order, and where they were not entered nothing happens") {
  Interiors interiors = within({3, 0, 7});
  interiors.leave(3);
  CHECK(interiors.bits() == within({0, 7}).bits());
  interiors.leave(5);
  CHECK(interiors.bits() == within({0, 7}).bits());
  interiors.leave(7);
  interiors.leave(0);
  CHECK(interiors.empty());
  // Two bodies of one material overlap: one of them is left.
  interiors = within({4, 2, 4});
  interiors.leave(4);
  CHECK(interiors.bits() == within({4, 2}).bits());
  // The first one of five is forgotten.
  CHECK(within({1, 2, 3, 4, 5}).bits() == within({2, 3, 4, 5}).bits());
  interiors = within({65534, 9, 65534, 8});
  interiors.leave(65534);
  CHECK(interiors.bits() == within({65534, 9, 8}).bits());
}

TEST_CASE("what is shared with other interiors keeps the order in which it was entered") {
  CHECK(within({1, 2, 3}).shared_with(within({3, 4, 1})).bits() == within({1, 3}).bits());
  CHECK(within({3, 4, 1}).shared_with(within({1, 2, 3})).bits() == within({3, 1}).bits());
  CHECK(within({5, 1, 5}).shared_with(within({5, 5, 2})).bits() == within({5, 5}).bits());
  CHECK(within({5, 1, 5}).shared_with(within({2, 5})).bits() == within({5}).bits());
}

TEST_CASE("of a mix that part was entered which was entered last") {
  const std::vector<Material> materials{
      glass(1.5f, 1), glass(1.5f, 1), {"mix", Mix{0, 1, 0.5f}}, glass(1.5f, 1), {"mix", Mix{3, 2, 0.5f}}};
  CHECK(within({}).entered(2, materials) == Interiors::none);
  CHECK(within({3}).entered(2, materials) == Interiors::none);
  CHECK(within({0, 1, 3}).entered(2, materials) == 1);
  CHECK(within({1, 0}).entered(4, materials) == 0);
  CHECK(within({0, 3}).entered(4, materials) == 3);
  CHECK(within({0, 3}).entered(0, materials) == 0);
}

TEST_CASE("of several interiors that of the highest priority is there, of equals the last") {
  const std::vector<Material> materials{glass(1.5f, 1), glass(1.3f, 3), glass(1.4f, 1), glass(1.2f, 0)};
  CHECK(within({}).prevailing(materials) == Interiors::none);
  CHECK(within({0}).prevailing(materials) == 0);
  CHECK(within({0, 2}).prevailing(materials) == 2);
  CHECK(within({2, 0}).prevailing(materials) == 0);
  CHECK(within({0, 1, 2}).prevailing(materials) == 1);
  CHECK(within({1, 3}).prevailing(materials) == 1);
}

TEST_CASE("light fades exponentially in what prevails, channel by channel") {
  const std::vector<Material> materials{glass(1.5f, 1, {0, 1, 2}), glass(1.5f, 2, {0.5f, 0, 0})};
  const auto infinity = std::numeric_limits<float>::infinity();
  CHECK(transmittance(materials, {}, infinity) == Rgb{1, 1, 1});
  const Rgb left = transmittance(materials, within({0}), 1.5f);
  CHECK(left.r == 1);
  CHECK(left.g == Approx(std::exp(-1.5)).epsilon(1e-6));
  CHECK(left.b == Approx(std::exp(-3.0)).epsilon(1e-6));
  CHECK(transmittance(materials, within({0}), infinity) == Rgb{1, 0, 0});
  CHECK(transmittance(materials, within({1, 0}), infinity) == Rgb{0, 1, 1});
}

TEST_CASE("a surface in something of a higher priority is hidden, in something lower a boundary to it") {
  const std::vector<Material> materials{
      glass(1.5f, 2), glass(1.33f, 1), glass(1.2f, 0), {"gold", Conductor{}}, {"plain", Dielectric{}}};
  const auto around = [&](std::uint32_t material, bool is_inside, const Interiors& interiors) {
    return surroundings_of(materials, material, is_inside, interiors);
  };
  CHECK_FALSE(around(0, false, {}).is_hidden);
  CHECK(around(0, false, {}).ior == 1);
  // Into the glass, out of water; into the water, within the glass.
  CHECK_FALSE(around(0, false, within({1})).is_hidden);
  CHECK(around(0, false, within({1})).ior == 1.33f);
  CHECK(around(1, false, within({0})).is_hidden);
  // Out of them: what is around is what else the path is in.
  CHECK_FALSE(around(0, true, within({1, 0})).is_hidden);
  CHECK(around(0, true, within({1, 0})).ior == 1.33f);
  CHECK(around(1, true, within({1, 0})).is_hidden);
  CHECK_FALSE(around(1, true, within({1})).is_hidden);
  CHECK(around(1, true, within({1})).ior == 1);
  // A body of the same priority is a boundary.
  CHECK_FALSE(around(0, false, within({0})).is_hidden);
  // Others are never hidden; metals feel what they are in, glass of no priority is as its scene says.
  CHECK_FALSE(around(3, false, within({1})).is_hidden);
  CHECK(around(3, false, within({1})).ior == 1.33f);
  CHECK_FALSE(around(2, false, within({0})).is_hidden);
  CHECK(around(2, false, within({0})).ior == 1);
  CHECK(around(4, false, within({0})).ior == 1);
  CHECK(around(0, false, within({2})).ior == 1);
}

TEST_CASE("within something denser, indices of refraction are smaller") {
  CHECK(std::get<Dielectric>(immersed(Dielectric{1.5f}, 1.25f)).ior == Approx(1.2));
  CHECK(std::get<Glass>(immersed(Glass{.ior = 1.5f}, 1.25f)).ior == Approx(1.2));
  const auto metal = std::get<Conductor>(immersed(Conductor{{1, 2, 3}, {4, 5, 6}}, 2));
  CHECK(metal.eta == Rgb{0.5f, 1, 1.5f});
  CHECK(metal.k == Rgb{2, 2.5f, 3});
  const auto coated = std::get<CoatedConductor>(immersed(CoatedConductor{.coat_ior = 1.5f}, 1.25f));
  CHECK(coated.coat_ior == Approx(1.2));
  CHECK(std::get<Lambert>(immersed(Lambert{}, 2)).reflectance == Lambert{}.reflectance);
}

TEST_CASE("what is clear is remembered where anything absorbs light or has a priority, and else not") {
  Material clear = glass(1.5f, 0);
  clear.interior.is_clear = true;
  const auto is_remembered = [&](const Material& other) {
    std::vector<Material> materials{clear, other};
    forget_clear_interiors(materials);
    return materials[0].interior.is_clear;
  };
  CHECK(is_remembered(glass(1.5f, 0, {0, 0.1f, 0})));
  CHECK(is_remembered({"milk", Dielectric{}, {}, {.scattering = {0, 0, 1}}}));
  CHECK(is_remembered(glass(1.5f, 1)));
  CHECK_FALSE(is_remembered(clear));
  CHECK_FALSE(is_remembered({"chalk"}));
}

TEST_CASE("a medium that scatters dims what goes straight on, and is found where it is") {
  std::vector<Material> materials{glass(1.5f, 0, {1, 0, 0.5f}), glass(1.5f, 1)};
  Interiors inside;
  CHECK(medium_in(materials, inside) == nullptr);
  inside.enter(0);
  CHECK(medium_in(materials, inside) == &materials[0].interior);
  CHECK_FALSE(scatters(*medium_in(materials, inside)));
  CHECK_FALSE(has_flights(materials));
  materials[1].interior.density = 0;
  CHECK(has_flights(materials));
  materials[1].interior.density = no_density;
  materials[0].interior.scattering = {1, 3, 0};
  CHECK(has_flights(materials));
  CHECK(scatters(*medium_in(materials, inside)));
  const Rgb left = transmittance(materials, inside, 0.5f);
  CHECK(left.r == Approx(std::exp(-1.0)));
  CHECK(left.g == Approx(std::exp(-1.5)));
  CHECK(left.b == Approx(std::exp(-0.25)));
  // Something of a higher priority is there instead.
  inside.enter(1);
  CHECK(medium_in(materials, inside) == &materials[1].interior);
}

TEST_CASE("so much of a medium leaves nothing that it dims, and less leaves something") {
  const Rgb extinction{0.5f, 0, 2};
  const float most = opaque_amount(extinction);
  CHECK(transmittance(extinction, most) == Rgb{0, 1, 0});
  CHECK(transmittance(extinction, 0.98f * most).r > 0);
  CHECK(opaque_amount({}) == 0);
}

TEST_CASE("a medium emits what it absorbs, and no more") {
  std::vector<Material> materials{glass(1.5f, 0, {1, 0, 0.5f})};
  CHECK_FALSE(has_glow(materials));
  materials[0].interior.glow.radiance = {0, 5, 0};
  CHECK_FALSE(has_glow(materials));
  materials[0].interior.glow.radiance = {2, 5, 3};
  CHECK(has_glow(materials));
  CHECK(materials[0].interior.emission() == Rgb{2, 0, 1.5f});
  CHECK_FALSE(has_uneven_glow(materials));
  materials[0].interior.glow.temperature = 0;
  CHECK(has_uneven_glow(materials));
}

TEST_CASE("light of media is refused that is of no group, where there are groups") {
  Scene scene;
  scene.materials.push_back(glass(1.5f, 0, {1, 1, 1}));
  scene.materials[0].interior.glow.radiance = {1, 1, 1};
  CHECK_NOTHROW(check_scene(scene));
  scene.light_groups = {"media"};
  CHECK_THROWS_AS(check_scene(scene), Error);
  scene.media_group = 0;
  CHECK_NOTHROW(check_scene(scene));
}

TEST_CASE("interiors that cannot be are refused") {
  const auto error_of = [](const Material& material) {
    Scene scene;
    scene.materials.push_back(material);
    try {
      check_scene(scene);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(error_of(glass(1.5f, 1, {1, 2, 3})).empty());
  CHECK(error_of(glass(1.5f, -1)) == "material 0 has the priority -1; it must be >= 0");
  CHECK(error_of(glass(1.5f, 0, {0, -1, 0})) ==
        "material 0 has an absorption of 0 -1 0; each must be finite and >= 0");
  CHECK(error_of(glass(1.5f, 0, {NAN, 0, 0})).find("must be finite") != std::string::npos);
  const auto filled = [](const Interior& interior) { return Material{"milk", Dielectric{}, {}, interior}; };
  CHECK(error_of(filled({.scattering = {1, 2, 3}, .anisotropy = -0.99f})).empty());
  CHECK(error_of(filled({.scattering = {0, 0, -1}})) ==
        "material 0 has a scattering of 0 0 -1; each must be finite and >= 0");
  CHECK(error_of(filled({.scattering = {0, INFINITY, 0}})).find("must be finite") != std::string::npos);
  CHECK(error_of(filled({.absorption = {0, 3e38f, 0}, .scattering = {0, 3e38f, 0}})) ==
        "material 0 absorbs and scatters more than a number can say");
  CHECK(error_of(filled({.anisotropy = 1})) == "material 0 has an anisotropy of 1; valid are -0.99 to 0.99");
  CHECK(error_of(filled({.density = 0})) == "material 0 names density 0; there are 0");
  CHECK(error_of(filled({.anisotropy = NAN})).find("anisotropy") != std::string::npos);
  // A texture may say that what is metal by its number is none.
  Material metal{"metal", Principled{.base_metalness = 1, .transmission_weight = 1}};
  metal.interior.priority = 1;
  CHECK(error_of(metal) == "material 0 has an interior, and its surface lets no light in");
  metal.textures = {{MaterialInput::base_metalness, 0}};
  CHECK(lets_light_in(metal));
  Material chalk{"chalk"};
  chalk.interior.priority = 1;
  CHECK(error_of(chalk) == "material 0 has an interior, and its surface lets no light in");
  Scene scene;
  scene.materials.resize(Interiors::most_materials);
  scene.materials.push_back(glass(1.5f, 1));
  CHECK_THROWS_AS(check_scene(scene), Error);
}

}  // namespace twinray::test
