// SPDX-License-Identifier: Apache-2.0
#include "io/three_mf/package.h"

#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/text.h"
#include "tests/support/three_mf_text.h"

namespace twinray {
namespace {

using test::contains;
std::string package_error(const std::string& bytes) {
  const test::TemporaryFolder folder;
  test::write_text(folder.file("a.3mf"), bytes);
  try {
    ThreeMfPackage(folder.file("a.3mf")).model();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a 3MF package begins where its relations say, whatever the case of names") {
  const test::TemporaryFolder folder;
  test::write_text(folder.file("a.3mf"),
                   test::three_mf_package("<model/>", {{"3D/b.model", "<model x=\"1\"/>"}}));
  ThreeMfPackage package(folder.file("a.3mf"));
  const XmlElement model = package.model().root();
  CHECK(model.name() == "model");
  CHECK(&package.part("3d/MODEL.model", model.place()) == &package.model());
  const XmlDocument& other = package.part("/3D/B.model", model.place());
  CHECK(other.root().attribute("x") == "1");
  CHECK(other.file() == folder.file("a.3mf") + "/3D/b.model");
}

TEST_CASE("a 3MF package that does not say where its model is is refused") {
  CHECK(contains(package_error(test::zip_text({{"3D/a.model", "<model/>"}})),
                 "a.3mf: the package has no _rels/.rels, which says where its model is"));
  CHECK(contains(package_error(test::zip_text(
                     {{"_rels/.rels", "<Relationships><Relationship Type=\"a\"/></Relationships>"}})),
                 "no <Relationship> is of the type .../3dmodel, which says where the model is"));
  CHECK(contains(package_error(test::zip_text(
                     {{"_rels/.rels", "<R><Relationship Type=\"/3dmodel\" Target=\"/b\"/></R>"}})),
                 "the package has no part \"/b\""));
  CHECK(contains(package_error("no archive"), "a.3mf"));
}

TEST_CASE("names without their prefixes are the same under any") {
  CHECK(local_name("m:colorgroup") == "colorgroup");
  CHECK(local_name("colorgroup") == "colorgroup");
  const auto document = XmlDocument::parse("<a id=\"1\" prod:path=\"/b\"/>", "a.model");
  CHECK(local_attribute(document->root(), "path") == "/b");
  CHECK(local_attribute(document->root(), "id") == "1");
  CHECK_FALSE(local_attribute(document->root(), "name"));
}

}  // namespace twinray
