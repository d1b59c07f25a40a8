// SPDX-License-Identifier: Apache-2.0
#include "io/three_mf/properties.h"

#include "io/picture/srgb.h"
#include "tests/support/catch.h"
#include "tests/support/text.h"

namespace twinray {
namespace {

using test::contains;
const std::string groups =
    "<resources><basematerials id=\"1\"><base name=\"a\" displaycolor=\"#204080\"/></basematerials>"
    "<m:colorgroup id=\"2\"><m:color color=\"#ff00Ff7F\"/></m:colorgroup>"
    "<m:multiproperties id=\"3\"/></resources>";

std::string property_error(const std::string& text) {
  try {
    WarningList warnings(false);
    const auto document = XmlDocument::parse(text, "a.model");
    const ThreeMfProperties properties(document->root(), warnings);
    properties.find(document->root(), {1, 1});
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("materials and colours of 3MF are decoded from sRGB, without their alpha") {
  WarningList warnings(false);
  const auto document = XmlDocument::parse(groups, "a.model");
  const ThreeMfProperties properties(document->root(), warnings);
  const auto material = properties.find(document->root(), {1, 0});
  REQUIRE(material);
  CHECK(material->name == "a");
  CHECK(material->color ==
        Rgb{decode_srgb(32.0f / 255), decode_srgb(64.0f / 255), decode_srgb(128.0f / 255)});
  const auto color = properties.find(document->root(), {2, 0});
  REQUIRE(color);
  CHECK(color->name == "#ff00Ff");
  CHECK(color->color == Rgb{1, 0, 1});
  CHECK_FALSE(properties.find(document->root(), {3, 7}));
  CHECK(warnings.items().size() == 1);
}

TEST_CASE("colours of 3MF that are none, and properties that are not there, are refused") {
  CHECK(contains(property_error(groups), "the index 1 is out of range; the group 1 has 1"));
  CHECK(contains(property_error("<resources/>"), "<resources> has no materials or colours with the id 1"));
  for (const char* const color :
       {"", "red", "#12345", "#1234567", "#12345g", "#-12345", "123456", "#1234567890"})
    CHECK(contains(property_error("<r><basematerials id=\"1\"><base displaycolor=\"" + std::string(color) +
                                  "\"/></basematerials></r>"),
                   *color ? "is no colour; valid are \"#RRGGBB\" and \"#RRGGBBAA\"" : "displaycolor"));
}

}  // namespace twinray
