// SPDX-License-Identifier: Apache-2.0
// Skins and morphs as they stand in the file.
#include <algorithm>

#include "io/collada/joints.h"
#include "tests/support/catch.h"
#include "tests/support/collada_text.h"

namespace twinray {
namespace {

constexpr float skin_tolerance = 1e-5f;

std::string plain_source(const std::string& id, int count, int stride, const std::string& array) {
  return "<source id=\"" + id + "\">" + array + "<technique_common><accessor source=\"#" + id +
         "-array\" count=\"" + std::to_string(count) + "\" stride=\"" + std::to_string(stride) +
         "\"><param name=\"A\"/></accessor></technique_common></source>\n";
}

std::string floats(const std::string& id, int count, int stride, const std::string& numbers) {
  return plain_source(id, count, stride,
                      "<float_array id=\"" + id + "-array\" count=\"" + std::to_string(count * stride) +
                          "\">" + numbers + "</float_array>");
}

std::string names(const std::string& id, int count, const std::string& array, const std::string& text) {
  return plain_source(id, count, 1,
                      "<" + array + " id=\"" + id + "-array\" count=\"" + std::to_string(count) + "\">" +
                          text + "</" + array + ">");
}

/// A skin of the triangle, by two joints that were bound at the origin and at (1, 0, 0).
struct SkinText {
  std::string shape = "<bind_shape_matrix>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</bind_shape_matrix>";
  std::string joints = names("joints", 2, "Name_array", "base tip");
  std::string counts = "1 1 2", influences = "0 0 1 0 0 1 1 1", weights = "1 0.5";
  std::string source = "#shape";

  std::string text() const {
    return "<controller id=\"c\"><skin source=\"" + source + "\">" + shape + joints +
           floats("binds", 2, 16, "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 1 0 0 -1 0 1 0 0 0 0 1 0 0 0 0 1") +
           floats("weights", 2, 1, weights) +
           "<joints><input semantic=\"JOINT\" source=\"#joints\"/>"
           "<input semantic=\"INV_BIND_MATRIX\" source=\"#binds\"/></joints>"
           "<vertex_weights count=\"3\"><input semantic=\"JOINT\" source=\"#joints\" offset=\"0\"/>"
           "<input semantic=\"WEIGHT\" source=\"#weights\" offset=\"1\"/><vcount>" +
           counts + "</vcount><v>" + influences + "</v></vertex_weights></skin></controller>";
  }
};

/// The tip has moved 2 up.
const std::string joint_nodes =
    "<node id=\"root\" sid=\"base\"><node id=\"end\" sid=\"tip\"><translate>1 2 0</translate></node></node>";

std::string controller_instance(const std::string& skeleton = "", const std::string& transform = "") {
  return "<node>" + transform + "<instance_controller url=\"#c\">" + skeleton +
         "</instance_controller></node>";
}

LoadedScene load(const std::string& controllers, const std::string& nodes,
                 const std::string& libraries = "") {
  return load_collada(collada_text(
      collada_triangle() + libraries + "<library_controllers>" + controllers + "</library_controllers>",
      nodes));
}

LoadedScene load_skin(const SkinText& skin, const std::string& nodes = controller_instance() + joint_nodes) {
  return load(skin.text(), nodes);
}

void check_positions(const LoadedScene& loaded, const std::vector<Vec3>& expected) {
  const auto& positions = mesh_of(loaded).positions;
  REQUIRE(positions.size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    CAPTURE(i, positions[i].x, positions[i].y, positions[i].z);
    CHECK(max_abs(positions[i] - expected[i]) <= skin_tolerance);
  }
}

const std::vector<std::string> skin_stands{
    "<skin> stands as its joints do in the file; animations do not move them"};
const std::vector<std::string> morph_stands{
    "<morph> has the weights of the file; animations do not change them"};

/// A further geometry, like the triangle, with these positions and what else its mesh has.
std::string target(const std::string& id, int count, const std::string& positions,
                   const std::string& rest = "") {
  return "<library_geometries><geometry id=\"" + id + "\"><mesh>" +
         collada_source(id + "-positions", count, positions) + "<vertices id=\"" + id +
         "-vertices\"><input semantic=\"POSITION\" source=\"#" + id + "-positions\"/></vertices>" + rest +
         "</mesh></geometry></library_geometries>\n";
}

std::string morph(const std::string& targets, const std::string& weights, const std::string& attributes = "",
                  const std::string& id = "c") {
  const int count = 1 + int(std::count(targets.begin(), targets.end(), ' '));
  const int weight_count = 1 + int(std::count(weights.begin(), weights.end(), ' '));
  return "<controller id=\"" + id + "\"><morph source=\"#shape\" " + attributes + ">" +
         names(id + "-targets", count, "IDREF_array", targets) +
         floats(id + "-weights", weight_count, 1, weights) +
         "<targets><input semantic=\"MORPH_TARGET\" source=\"#" + id +
         "-targets\"/><input semantic=\"MORPH_WEIGHT\" source=\"#" + id +
         "-weights\"/></targets></morph></controller>";
}

const std::string lifted = target("lifted", 3, "0 0 4 1 0 4 0 1 4");

}  // namespace

TEST_CASE("a skin's vertices go where its joints take them, each by its weights") {
  const LoadedScene loaded = load_skin({});
  check_positions(loaded, {{0, 0, 0}, {1, 2, 0}, {0, 2, 0}});
  CHECK(messages(loaded) == skin_stands);
}

TEST_CASE("a skin is moved by its node after its joints, and turned with the scene's axis") {
  const std::string nodes = controller_instance("", "<translate>0 0 7</translate>") + joint_nodes;
  check_positions(load_skin({}, nodes), {{0, 0, 7}, {1, 2, 7}, {0, 2, 7}});
  const std::string library = "<library_controllers>" + SkinText{}.text() + "</library_controllers>";
  check_positions(load_collada(collada_text(collada_triangle() + library, nodes, "Z_UP")),
                  {{0, 7, 0}, {-1, 7, 2}, {0, 7, 2}});
}

TEST_CASE("a skin's vertices take their bind shape before the joints") {
  SkinText skin;
  skin.shape = "<bind_shape_matrix>1 0 0 0 0 1 0 0 0 0 1 3 0 0 0 1</bind_shape_matrix>";
  check_positions(load_skin(skin), {{0, 0, 3}, {1, 2, 3}, {0, 2, 3}});
}

TEST_CASE("weights count by their sum, and the joint -1 is the bind shape") {
  SkinText skin;
  skin.weights = "2 0.25";
  check_positions(load_skin(skin), {{0, 0, 0}, {1, 2, 0}, {0, 2, 0}});
  skin = {};
  skin.counts = "1 1 0";
  skin.influences = "0 0 -1 0";
  check_positions(load_skin(skin), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
}

TEST_CASE("a joint is the first node of its sid below the skeleton") {
  const std::string other =
      "<node id=\"other\" sid=\"base\"><node sid=\"tip\"><translate>1 0 5</translate></node></node>";
  const auto load_below = [&](const std::string& skeleton) {
    return load_skin({}, controller_instance("<skeleton>#" + skeleton + "</skeleton>") + other + joint_nodes);
  };
  check_positions(load_below("root"), {{0, 0, 0}, {1, 2, 0}, {0, 2, 0}});
  check_positions(load_below("other"), {{0, 0, 0}, {1, 0, 5}, {0, 1, 2.5}});
  check_positions(load_below("world"), {{0, 0, 0}, {1, 0, 5}, {0, 1, 2.5}});
}

TEST_CASE("a joint may be named by its id, and stand in a library of nodes or behind an instance") {
  SkinText skin;
  skin.joints = names("joints", 2, "IDREF_array", "root end");
  check_positions(load_skin(skin), {{0, 0, 0}, {1, 2, 0}, {0, 2, 0}});
  skin.joints = names("joints", 2, "Name_array", "root end");
  check_positions(load_skin(skin), {{0, 0, 0}, {1, 2, 0}, {0, 2, 0}});
  const std::string library = "<library_nodes>" + joint_nodes + "</library_nodes>";
  check_positions(load(skin.text(), controller_instance(), library), {{0, 0, 0}, {1, 2, 0}, {0, 2, 0}});
  const std::string placed = "<node><translate>0 0 6</translate><instance_node url=\"#root\"/></node>";
  check_positions(load(skin.text(), controller_instance() + placed, library),
                  {{0, 0, 6}, {1, 2, 6}, {0, 2, 6}});
}

TEST_CASE("a skin's normals turn with their joints") {
  const std::string geometry = collada_mesh(
      3, "0 0 0 1 0 0 0 1 0",
      collada_source("normals", 1, "0 0 1") +
          "<triangles count=\"1\"><input semantic=\"VERTEX\" source=\"#vertices\" offset=\"0\"/><input "
          "semantic=\"NORMAL\" source=\"#normals\" offset=\"1\"/><p>0 0 1 0 2 0</p></triangles>");
  const std::string nodes =
      controller_instance() +
      "<node sid=\"base\"/><node sid=\"tip\"><translate>1 0 0</translate><rotate>0 1 0 90</rotate></node>";
  SkinText skin;
  skin.counts = "1 1 1";
  skin.influences = "0 0 1 0 0 0";
  const LoadedScene loaded = load_collada(
      collada_text(geometry + "<library_controllers>" + skin.text() + "</library_controllers>", nodes));
  const Mesh& mesh = mesh_of(loaded);
  const Triangle& normals = mesh.normal_indices.at(0);
  CHECK(max_abs(mesh.normals[normals[0]] - Vec3{0, 0, 1}) <= skin_tolerance);
  CHECK(max_abs(mesh.normals[normals[1]] - Vec3{1, 0, 0}) <= skin_tolerance);
}

TEST_CASE("a skin whose joints or numbers are missing stands in its bind pose, with the reason") {
  const auto warning = [](const SkinText& skin, const std::string& nodes) {
    const LoadedScene loaded = load_skin(skin, nodes);
    check_positions(loaded, {{5, 0, 0}, {6, 0, 0}, {5, 1, 0}});
    REQUIRE(loaded.warnings.size() == 1);
    return loaded.warnings[0].message;
  };
  const std::string pose = "; this <skin> is rendered in its bind pose",
                    all = controller_instance() + joint_nodes;
  SkinText skin;
  skin.shape = "<bind_shape_matrix>1 0 0 5 0 1 0 0 0 0 1 0 0 0 0 1</bind_shape_matrix>";
  CHECK(warning(skin, controller_instance()) == "no <node> of the scene is the joint \"base\"" + pose);
  SkinText broken = skin;
  broken.influences = "0 0 1 0 0 1 2 1";
  CHECK(warning(broken, all) == "2 is not the index of a joint; there are 2, numbered from 0" + pose);
  broken.influences = "0 0 1 0 0 1 1 7";
  CHECK(warning(broken, all) == "7 is not the index of a weight; there are 2, numbered from 0" + pose);
  broken.influences = "0 0 1 0";
  CHECK(warning(broken, all) == "<vcount> asks for 4 joints of 2 indices, and <v> has 4 indices" + pose);
  broken = skin;
  broken.counts = "1 1";
  CHECK(warning(broken, all) == "<vcount> has 2 numbers, and there are 3 vertices" + pose);
  broken = skin;
  broken.joints = names("joints", 3, "Name_array", "base tip tip");
  CHECK(warning(broken, all) == "there are 3 joints, and 2 inverse bind matrices" + pose);
}

TEST_CASE("a normalized morph goes from its base towards its targets by their weights") {
  const std::string wide = target("wide", 3, "0 0 0 5 0 0 0 1 0");
  const LoadedScene one =
      load(morph("lifted", "0.75"), controller_instance("", "<translate>0 9 0</translate>"), lifted);
  check_positions(one, {{0, 9, 3}, {1, 9, 3}, {0, 10, 3}});
  CHECK(messages(one) == morph_stands);
  check_positions(load(morph("lifted wide", "0.5 0.25"), controller_instance(), lifted + wide),
                  {{0, 0, 2}, {2, 0, 2}, {0, 1, 2}});
}

TEST_CASE("a relative morph adds its targets to its base") {
  check_positions(load(morph("lifted", "0.5", "method=\"RELATIVE\""), controller_instance(), lifted),
                  {{0, 0, 2}, {1.5f, 0, 2}, {0, 1.5f, 2}});
}

TEST_CASE("a morph blends the normals of its targets, and shades flat where one has none like them") {
  const auto primitives = [](const std::string& id, const std::string& normal) {
    return collada_source(id + "-normals", 1, normal) +
           "<triangles count=\"1\"><input semantic=\"VERTEX\" source=\"#" + id +
           "vertices\" offset=\"0\"/><input semantic=\"NORMAL\" source=\"#" + id +
           "-normals\" offset=\"1\"/><p>0 0 1 0 2 0</p></triangles>";
  };
  const auto load_with = [&](const std::string& further) {
    return load_collada(collada_text(collada_mesh(3, "0 0 0 1 0 0 0 1 0", primitives("", "0 0 1")) + further +
                                         "<library_controllers>" + morph("t", "0.5") +
                                         "</library_controllers>",
                                     controller_instance()));
  };
  const LoadedScene blended = load_with(target("t", 3, "0 0 0 1 0 0 0 1 2", primitives("t-", "1 0 0")));
  const Vec3 normal = mesh_of(blended).normals.at(0);
  CHECK(max_abs(normal - Vec3{0.70710678f, 0, 0.70710678f}) <= skin_tolerance);
  CHECK(mesh_of(load_with(target("t", 3, "0 0 0 1 0 0 0 1 2"))).normals.empty());
}

TEST_CASE("a morph that does not fit is its base mesh, with the reason") {
  const auto warning = [](const std::string& controller, const std::string& libraries) {
    const LoadedScene loaded = load(controller, controller_instance(), libraries);
    check_positions(loaded, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    REQUIRE(loaded.warnings.size() == 1);
    return loaded.warnings[0].message;
  };
  const std::string base = "; this <morph> is rendered as its base mesh";
  CHECK(warning(morph("lifted", "1"), target("lifted", 2, "0 0 4 1 0 4")) ==
        "this target has 2 vertices, and the base mesh 3" + base);
  CHECK(warning(morph("gone", "1"), "") ==
        "no <geometry> or <controller> has the id \"gone\", of a target" + base);
  CHECK(warning(morph("lifted", "1 1"), lifted) == "there are 1 targets, and 2 weights" + base);
  CHECK(warning(morph("lifted", "1", "method=\"SUM\""), lifted) ==
        "\"SUM\" is not a method of <morph>; valid are NORMALIZED and RELATIVE" + base);
  CHECK(warning(morph("c", "1"), "") ==
        "this controller is its own source; controllers must form no circle" + base);
}

TEST_CASE("a skin may move a morph") {
  SkinText skin;
  skin.source = "#m";
  check_positions(
      load(skin.text() + morph("lifted", "0.5", "", "m"), controller_instance() + joint_nodes, lifted),
      {{0, 0, 2}, {1, 2, 2}, {0, 2, 2}});
}

TEST_CASE("by CS184's rules controllers are left out, with a warning") {
  LoadOptions options;
  options.interpretation = Interpretation::cs184;
  const std::string library = "<library_controllers>" + SkinText{}.text() + "</library_controllers>";
  const LoadedScene loaded =
      load_collada(collada_text(collada_triangle() + library, controller_instance() + joint_nodes), options);
  CHECK(loaded.scene.geometry->triangle_count() == 0);
  CHECK(messages(loaded) ==
        std::vector<std::string>{"CS184's program reads no controllers; this one is left out",
                                 "the scene has no shapes"});
}

TEST_CASE("so many nodes may be joints and no more") {
  std::string nodes;
  for (std::size_t i = 0; i < ColladaJoints::max_joints; ++i) nodes += "<node/>";
  const LoadedScene loaded = load_skin({}, nodes + controller_instance() + joint_nodes);
  CHECK(messages(loaded) ==
        std::vector<std::string>{
            "of so many nodes the first 100000 may be joints",
            "no <node> of the scene is the joint \"base\"; this <skin> is rendered in its bind pose"});
}

TEST_CASE("controllers that are each other's source are an error") {
  const std::string controllers =
      "<controller id=\"c\"><skin source=\"#d\"/></controller>"
      "<controller id=\"d\"><morph source=\"#c\"/></controller>";
  CHECK(collada_error(collada_text("<library_controllers>" + controllers + "</library_controllers>",
                                   controller_instance()))
            .find("this controller is its own source; controllers must form no circle") != std::string::npos);
}

}  // namespace twinray
