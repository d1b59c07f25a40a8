// SPDX-License-Identifier: Apache-2.0
// Pictures of normals by CS184's rules, held to a reference that was written from the description of its
// program alone (tests/support/cs184/).
#include <fmt/format.h>

#include "tests/support/catch.h"
#include "tests/support/collada_text.h"
#include "tests/support/cs184/compare.h"
#include "tests/support/random.h"

namespace twinray {
namespace {

using test::cs184::Difference;

/// What CS184's program may differ by, as a part of all pixels.
constexpr double most_beyond_one_step = 0.002;
/// Pixels whose centre lies within rounding of an edge: the diagonals of halved squares seen upright go
/// through many.
constexpr double most_outline = 0.001;

void check(const Difference& difference) {
  CHECK(difference.beyond_one_step <= most_beyond_one_step);
  CHECK(difference.outline <= most_outline);
}

std::string polylist(const std::string& counts, const std::string& indices, int count) {
  return "<polylist count=\"" + std::to_string(count) +
         "\"><input semantic=\"VERTEX\" source=\"#vertices\" offset=\"0\"/><vcount>" + counts +
         "</vcount><p>" + indices + "</p></polylist>\n";
}

/// A pyramid over a square: closed, or without its bottom.
std::string pyramid(bool is_closed) {
  return collada_mesh(5, "1 0 0 0 1 0 -1 0 0 0 -1 0 0 0 1.5",
                      is_closed ? polylist("3 3 3 3 3 3", "0 1 4 1 2 4 2 3 4 3 0 4 2 1 0 3 2 0", 6)
                                : polylist("3 3 3 3", "0 1 4 1 2 4 2 3 4 3 0 4", 4));
}

std::string perspective(const std::string& id, const std::string& lens) {
  return "<camera id=\"" + id + "\"><optics><technique_common><perspective>" + lens +
         "</perspective></technique_common></optics></camera>";
}

const std::string cameras =
    "<library_cameras>" + perspective("near", "<xfov>60</xfov><aspect_ratio>1.5</aspect_ratio>") +
    perspective("far", "<yfov>20</yfov>") +
    perspective("cut", "<xfov>50</xfov><yfov>40</yfov><znear>5.5</znear><zfar>6.4</zfar>") +
    "</library_cameras>";

std::string look(const std::string& id, const std::string& where = "3 1 2") {
  return "<node><translate>" + where + "</translate><instance_camera url=\"#" + id + "\"/></node>";
}

const std::string shape_instance = "<instance_geometry url=\"#shape\"/>";

/// A hilly patch of 5 x 5 vertices some of whose 32 triangles are missing, and few of the rest wound the
/// other way round: with borders, holes, corners that only touch, and edges that no manifold has.
std::string random_patch(test::Random& random, bool is_manifold) {
  constexpr int side = 5;
  std::string positions, indices, counts;
  for (int i = 0; i < side * side; ++i)
    positions += fmt::format("{} {} {} ", i % side, i / side, random.uniform(-0.7f, 0.7f));
  int count = 0;
  const auto add = [&](int a, int b, int c) {
    if (count > 0 && random.unit() < 0.15f) return;
    if (!is_manifold && random.unit() < 0.1f) std::swap(b, c);
    indices += fmt::format("{} {} {} ", a, b, c);
    counts += "3 ";
    ++count;
  };
  for (int y = 0; y + 1 < side; ++y)
    for (int x = 0; x + 1 < side; ++x) {
      const int a = y * side + x, b = a + 1, c = a + side, d = c + 1;
      add(a, b, d);
      add(a, d, c);
    }
  return collada_mesh(side * side, positions, polylist(counts, indices, count));
}

std::string random_matrix(test::Random& random) {
  std::string numbers;
  for (int i = 0; i < 12; ++i) numbers += fmt::format("{} ", random.uniform(-2, 2));
  return "<matrix>" + numbers + "0 0 0 1</matrix>";
}

}  // namespace

TEST_CASE("normals of the scenes of this project are those of CS184's program") {
  for (const char* name : {"box", "spheres", "furnace", "lights", "cornell-bunny"})
    for (const auto& [width, height] : {std::pair{480, 360}, {800, 600}, {90, 200}}) {
      CAPTURE(name, width, height);
      check(test::cs184::difference_of_file(std::string(TWINRAY_SOURCE_DIR) + "/scenes/" + name + ".dae",
                                            width, height));
    }
}

TEST_CASE("normals of open, closed, mirrored and turned meshes are those of CS184's program") {
  const std::string mirrored =
      "<node><matrix>-1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</matrix>" + shape_instance + "</node>";
  const std::string nested = "<node><translate>0 2 0</translate><node><scale>0.5 1 2</scale>" +
                             shape_instance + "</node></node><node>" + shape_instance + "</node>";
  for (const bool is_closed : {true, false})
    for (const char* up : {"X_UP", "Y_UP", "Z_UP"})
      for (const std::string& nodes : {mirrored, nested}) {
        CAPTURE(is_closed, up, nodes);
        check(test::cs184::difference_of_text(
            collada_text(pyramid(is_closed) + cameras, nodes + look("near"), up), 320, 240));
      }
}

TEST_CASE("a polygon loses its third corner and those after it, as in CS184's program") {
  const std::string libraries =
      collada_mesh(6, "0 0 0 1 0 0 2 1 0 1 2 0.5 0 2 1 -1 1 0", polylist("4 4", "0 1 2 3 0 3 4 5", 2)) +
      cameras;
  check(test::cs184::difference_of_text(
      collada_text(libraries, "<node>" + shape_instance + "</node>" + look("far", "0 0 4")), 320, 240));
}

TEST_CASE("a mesh that is no manifold has smooth normals where CS184's program would refuse it") {
  const std::string fin =
      collada_mesh(5, "0 0 0 0 0 2 1 0 1 -1 0.2 1 0 1 1", polylist("3 3 3", "0 1 2 0 1 3 0 1 4", 3)) +
      cameras;
  const std::string text = collada_text(fin, "<node>" + shape_instance + "</node>" + look("near"));
  check(test::cs184::difference_of_text(text, 320, 240));
  const LoadedScene loaded = load_collada(text, {.interpretation = Interpretation::cs184});
  REQUIRE(loaded.warnings.size() == 1);
  CHECK(loaded.warnings[0].message ==
        "CS184's program refuses this mesh, since two faces have the edge from vertex 0 to vertex 1 in the "
        "same direction; it gets smooth normals without the program's rule for borders");
}

TEST_CASE("the last camera counts, and none is one on +z") {
  const std::string mesh = "<node>" + shape_instance + "</node>";
  for (const std::string& nodes :
       {mesh, mesh + look("far") + look("near", "-2 0 1"), look("near") + mesh + look("far"),
        "<node><translate>1 1 -3</translate><instance_camera url=\"#near\"/><node><instance_camera "
        "url=\"#far\"/></node></node>" +
            mesh,
        mesh + look("near", "0 4 1")}) {
    CAPTURE(nodes);
    check(test::cs184::difference_of_text(collada_text(pyramid(true) + cameras, nodes), 320, 240));
  }
}

TEST_CASE("the camera's clip distances cut the picture as in CS184's program") {
  const std::string text =
      collada_text(pyramid(true) + cameras, "<node>" + shape_instance + "</node>" + look("cut"));
  check(test::cs184::difference_of_text(text, 320, 240));
  const auto picture = test::cs184::normals_picture(text, 320, 240);
  const auto whole = test::cs184::normals_picture(
      collada_text(pyramid(true) + cameras, "<node>" + shape_instance + "</node>" + look("near")), 320, 240);
  const auto hits = [](const auto& p) { return std::count(p.is_hit.begin(), p.is_hit.end(), true); };
  CHECK(hits(picture) > 100);
  CHECK(hits(picture) < hits(whole));
}

TEST_CASE("a sphere has the scale of its x axis") {
  const std::string ball =
      "<library_geometries><geometry id=\"ball\"><extra><technique "
      "profile=\"CGL\"><sphere><radius>0.7</radius>"
      "</sphere></technique></extra></geometry></library_geometries>";
  const std::string node =
      "<node><matrix>0 -1 0 2 1.5 0 0 0 0 0 1 1 0 0 0 1</matrix><instance_geometry url=\"#ball\"/></node>";
  check(test::cs184::difference_of_text(collada_text(ball + cameras, node + look("near")), 320, 240));
}

TEST_CASE("normals of random patches under random transforms and cameras are those of CS184's program") {
  constexpr int seeds = 60;
  double covered = 0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const std::string libraries = random_patch(random, seed % 3 != 0) + cameras;
    std::string nodes;
    for (int i = 0; i < 3; ++i) {
      const std::string inner = random_matrix(random), outer = random_matrix(random);
      nodes += "<node>" + outer + "<node>" + inner + shape_instance + "</node></node>";
    }
    nodes += "<node>" + random_matrix(random) + "<instance_camera url=\"#" + (seed % 2 ? "near" : "far") +
             "\"/></node>";
    const char* axes[] = {"X_UP", "Y_UP", "Z_UP"};
    const Difference difference =
        test::cs184::difference_of_text(collada_text(libraries, nodes, axes[seed / 2 % 3]), 160, 120);
    check(difference);
    covered += difference.covered / seeds;
  }
  CHECK(covered > 0.3);
}

}  // namespace twinray
