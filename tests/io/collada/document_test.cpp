// SPDX-License-Identifier: Apache-2.0
#include "io/collada/document.h"

#include "io/scene_file.h"
#include "tests/support/catch.h"
#include "tests/support/collada_text.h"
#include "tests/support/temporary_folder.h"

namespace twinray {
namespace {

const std::string name_space_1_4 = "http://www.collada.org/2005/11/COLLADASchema",
                  name_space_1_5 = "http://www.collada.org/2008/03/COLLADASchema";

/// A document with one triangle whose root element begins like this.
std::string with_root(const std::string& root) {
  std::string text = collada_text(collada_triangle(), collada_shape_node());
  return root + text.substr(text.find('>'));
}

/// A folder of files that refer to each other.
struct Folder {
  void write(const std::string& name, const std::string& text) const {
    test::write_text(folder.file(name), text);
  }
  LoadedScene load(const std::string& name) const { return load_scene(folder.file(name)); }
  std::string error(const std::string& name) const {
    try {
      load(name);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }

  test::TemporaryFolder folder;
};

std::string instance_of(const std::string& url) {
  return "<node><instance_geometry url=\"" + url + "\"/></node>";
}

}  // namespace

TEST_CASE("1.4 and 1.5 are read, each with its namespace") {
  for (const std::string& root : {"<COLLADA xmlns=\"" + name_space_1_4 + "\" version=\"1.4.0\"",
                                  "<COLLADA xmlns=\"" + name_space_1_4 + "\" version=\"1.4.1\"",
                                  "<COLLADA xmlns=\"" + name_space_1_5 + "\" version=\"1.5.0\"",
                                  std::string("<COLLADA version=\"1.5\"")}) {
    INFO(root);
    const LoadedScene loaded = load_collada(with_root(root));
    CHECK(loaded.warnings.empty());
    CHECK(loaded.scene.geometry->triangle_count() == 1);
  }
}

TEST_CASE("a version that is missing, or belongs to another namespace, is a warning") {
  CHECK(messages(load_collada(with_root("<COLLADA"))) ==
        std::vector<std::string>{"<COLLADA> has no version; it is read as 1.4.1"});
  CHECK(messages(load_collada(with_root("<COLLADA xmlns=\"" + name_space_1_5 + "\" version=\"1.4.1\""))) ==
        std::vector<std::string>{"the namespace \"" + name_space_1_5 + "\" is not that of COLLADA 1.4, \"" +
                                 name_space_1_4 + "\"; the names are read all the same"});
  CHECK(collada_error(with_root("<COLLADA version=\"1.3.1\""))
            .find("COLLADA version \"1.3.1\" is not read; valid are 1.4.0, 1.4.1 and 1.5.0") !=
        std::string::npos);
  CHECK(!collada_error(with_root("<COLLADA version=\"1.40\"")).empty());
}

TEST_CASE("names may have a prefix") {
  std::string text = collada_text(collada_triangle(), collada_shape_node());
  for (std::size_t i = 0; (i = text.find('<', i)) != std::string::npos; i += 2)
    text.insert(text[i + 1] == '/' ? i + 2 : i + 1, "dae:");
  text.insert(text.find(' '), " xmlns:dae=\"" + name_space_1_4 + "\"");
  const LoadedScene loaded = load_collada(text);
  CHECK(messages(loaded).empty());
  CHECK(loaded.scene.geometry->triangle_count() == 1);
}

TEST_CASE("a letter in another encoding is a warning") {
  std::string text =
      "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>" +
      collada_text(collada_triangle(), "<node name=\"caf\xe9\"><instance_geometry url=\"#shape\"/></node>");
  CHECK(
      messages(load_collada(text)) ==
      std::vector<std::string>{"the encoding ISO-8859-1 is read as if it were UTF-8; names may look wrong"});
}

TEST_CASE("an id that several elements have means the one of the kind that is needed") {
  const LoadedScene loaded = load_collada(
      collada_text("<library_lights><light id=\"shape\"><technique_common><ambient><color>1 1 1</color>"
                   "</ambient></technique_common></light></library_lights>" +
                       collada_triangle(),
                   collada_shape_node()));
  CHECK(loaded.scene.geometry->triangle_count() == 1);
  REQUIRE(loaded.warnings.size() == 1);
  CHECK(loaded.warnings[0].message.find("the id \"shape\" is used before") == 0);
}

TEST_CASE("a reference without # is read where it is plain what it means") {
  const LoadedScene loaded = load_collada(collada_text(collada_triangle(), instance_of("shape")));
  CHECK(loaded.scene.geometry->triangle_count() == 1);
  CHECK(messages(loaded) ==
        std::vector<std::string>{"\"shape\" is taken to mean \"#shape\"; a reference has the form \"#id\""});
}

TEST_CASE("references lead to other files, relative to the one they stand in") {
  const Folder folder;
  std::filesystem::create_directory(folder.folder.path() / "some parts");
  folder.write("scene.dae",
               collada_text("", instance_of("./some%20parts/b.dae#shape") +
                                    "<node><instance_node url=\"some%20parts/c.dae#again\"/></node>"));
  folder.write("some parts/b.dae", collada_text(collada_triangle(), ""));
  folder.write(
      "some parts/c.dae",
      collada_text("<library_nodes><node id=\"again\"><instance_geometry url=\"b.dae#shape\"/></node>"
                   "</library_nodes>",
                   ""));
  CHECK(folder.load("scene.dae").scene.geometry->triangle_count() == 2);
}

TEST_CASE("a reference to the file that it stands in is one to itself") {
  const Folder folder;
  folder.write("scene.dae",
               collada_text(collada_triangle(), instance_of("../" + folder.folder.path().filename().string() +
                                                            "/scene.dae#shape")));
  CHECK(folder.load("scene.dae").scene.geometry->triangle_count() == 1);
}

TEST_CASE("a file that a reference names and that cannot be read is told with the reference's place") {
  const Folder folder;
  folder.write("scene.dae", collada_text("", instance_of("no.dae#shape")));
  const std::string error = folder.error("scene.dae");
  CHECK(error.find("scene.dae:3:26: the file that this reference names cannot be read\n") !=
        std::string::npos);
  CHECK(error.find("no.dae: there is no such file") != std::string::npos);
  folder.write("far.dae", collada_text("", instance_of("http://example.com/a.dae#shape")));
  CHECK(folder.error("far.dae").find(
            "\"http://example.com/a.dae\" is not a file of this machine; references lead to "
            "files") != std::string::npos);
}

TEST_CASE("files that refer to each other in a circle are an error") {
  const Folder folder;
  const auto text = [](const std::string& other) {
    return collada_text(
        "<library_nodes><node id=\"n\"><instance_node url=\"" + other + "#n\"/></node></library_nodes>",
        "<node><instance_node url=\"#n\"/></node>");
  };
  folder.write("a.dae", text("b.dae"));
  folder.write("b.dae", text("a.dae"));
  CHECK(folder.error("a.dae").find("this node instances itself") != std::string::npos);
}

TEST_CASE("references lead to so many files and no more") {
  const Folder folder;
  for (int i = 0; i < 120; ++i)
    folder.write(std::to_string(i) + ".dae",
                 collada_text("<library_nodes><node id=\"n\"><instance_node url=\"" + std::to_string(i + 1) +
                                  ".dae#n\"/></node></library_nodes>",
                              "<node><instance_node url=\"#n\"/></node>"));
  CHECK(folder.error("0.dae").find("references lead to more than 100 files") != std::string::npos);
}

TEST_CASE("a scene that nothing instances is read where there is one, with a warning") {
  std::string text = collada_text(collada_triangle(), collada_shape_node());
  text.replace(text.find("<scene>"), text.rfind("</COLLADA>") - text.find("<scene>"), "");
  const LoadedScene loaded = load_collada(text);
  CHECK(loaded.scene.geometry->triangle_count() == 1);
  CHECK(messages(loaded) ==
        std::vector<std::string>{
            "no <instance_visual_scene> says which scene is seen; this is the first of 1"});
  CHECK(collada_error("<COLLADA version=\"1.4.1\"/>")
            .find("the file has no <visual_scene>: it may hold geometry, and places none of it") !=
        std::string::npos);
}

TEST_CASE("a VERTEX input that names no vertices means the only ones of its mesh") {
  std::string text = collada_text(collada_triangle(), collada_shape_node());
  text.replace(text.find("source=\"#vertices\""), 18, "source=\"#verteces\"");
  const LoadedScene loaded = load_collada(text);
  CHECK(mesh_of(loaded).triangles.size() == 1);
  REQUIRE(loaded.warnings.size() == 1);
  CHECK(loaded.warnings[0].message ==
        "no <vertices> is \"#verteces\"; this <input> is taken to mean the only ones of its <mesh>");
}

}  // namespace twinray
