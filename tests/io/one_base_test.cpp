// SPDX-License-Identifier: Apache-2.0
#include "io/one_base.h"

#include "core/textured_material.h"
#include "tests/support/catch.h"

namespace twinray::test {

TEST_CASE("the one base of a material is the larger part of what is diffuse, with its textures") {
  Principled both{.base_weight = 0.5f, .base_color = {1, 0, 0}, .subsurface_color = {0, 1, 0}};
  Material material{.name = "skin", .subsurface = {{1, 2, 3}}};
  material.textures = {{MaterialInput::reflectance, 0},
                       {MaterialInput::base_weight, 1},
                       {MaterialInput::subsurface_color, 2},
                       {MaterialInput::subsurface_weight, 3},
                       {MaterialInput::roughness, 4}};
  Losses losses;
  const auto one = [&](float weight) {
    both.subsurface_weight = weight;
    material.model = both;
    return with_one_base(material, losses);
  };
  const Material below = one(0.5f);
  CHECK(std::get<Principled>(below.model).base_color == Rgb{0, 1, 0});
  CHECK(std::get<Principled>(below.model).base_weight == 1);
  CHECK(std::get<Principled>(below.model).subsurface_weight == 0);
  CHECK(below.subsurface == material.subsurface);
  REQUIRE(below.textures.size() == 2);
  CHECK(texture_use(below, MaterialInput::reflectance)->texture == 2);
  CHECK(texture_use(below, MaterialInput::roughness)->texture == 4);
  const Material above = one(0.4f);
  CHECK(std::get<Principled>(above.model).base_color == Rgb{1, 0, 0});
  CHECK(std::get<Principled>(above.model).base_weight == 0.5f);
  CHECK_FALSE(has_subsurface(above));
  REQUIRE(above.textures.size() == 3);
  CHECK(texture_use(above, MaterialInput::reflectance)->texture == 0);
  CHECK(losses.lines("a").at(0) == "a: the lesser of the two diffuse parts of 2 materials is left out");
  // Others have one.
  material.model = CoatedDiffuse{};
  losses = {};
  CHECK(with_one_base(material, losses).subsurface == material.subsurface);
  CHECK(with_one_base(material, losses).textures.size() == material.textures.size());
}

}  // namespace twinray::test
