// SPDX-License-Identifier: Apache-2.0
#include "io/collada/archive.h"

#include "io/scene_file.h"
#include "tests/support/catch.h"
#include "tests/support/collada_text.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/zip_text.h"

namespace twinray {
namespace {

using test::zip_text;
using test::ZipEntry;

/// An archive in a folder of its own.
struct Archive {
  explicit Archive(const std::string& bytes) { test::write_text(path(), bytes); }
  explicit Archive(const std::vector<ZipEntry>& entries) : Archive(zip_text(entries)) {}

  std::string path() const { return folder.file("a.zae"); }
  LoadedScene load() const { return load_scene(path()); }
  /// Without the folder's name.
  std::string error() const {
    try {
      load();
    } catch (const Error& error) {
      std::string text = error.what();
      const std::string prefix = folder.path().string() + "/";
      for (std::size_t at; (at = text.find(prefix)) != std::string::npos;) text.erase(at, prefix.size());
      return text;
    }
    return "";
  }

  test::TemporaryFolder folder;
};

ZipEntry manifest(const std::string& root) {
  return {"manifest.xml", "<?xml version=\"1.0\"?>\n<dae_root>" + root + "</dae_root>"};
}

}  // namespace

TEST_CASE("an archive is read from the document that its manifest names") {
  const Archive archive({manifest("./in%20it/scene.dae#world"),
                         {"other.dae", "not XML"},
                         {"in it/scene.dae", collada_text(collada_triangle(), collada_shape_node())}});
  const LoadedScene loaded = archive.load();
  CHECK(loaded.scene.geometry->triangle_count() == 1);
  CHECK(loaded.warnings.empty());
}

TEST_CASE("documents of an archive refer to each other within it") {
  const std::string node = "<node><instance_geometry url=\"../parts/shape.dae#shape\"/></node>";
  const Archive archive({manifest("a/scene.dae"),
                         {"a/scene.dae", collada_text("", node)},
                         {"parts/shape.dae", collada_text(collada_triangle(), "")}});
  CHECK(archive.load().scene.geometry->triangle_count() == 1);
  const Archive outside(
      {manifest("scene.dae"),
       {"scene.dae", collada_text("", "<node><instance_geometry url=\"../shape.dae#shape\"/></node>")}});
  CHECK(outside.error().find("shape.dae: this lies outside of the archive a.zae") != std::string::npos);
}

TEST_CASE("an archive without a manifest is read where it has one document") {
  const ZipEntry scene{"scene.dae", collada_text(collada_triangle(), collada_shape_node())};
  const LoadedScene loaded = Archive(std::vector{scene}).load();
  REQUIRE(loaded.warnings.size() == 1);
  CHECK(loaded.warnings[0].message ==
        "the archive has no manifest.xml; its only document, scene.dae, is read");
  CHECK(Archive({scene, {"more.dae", "x"}}).error() ==
        "a.zae: the archive has no manifest.xml, which says where to start, and 2 documents (.dae)");
}

TEST_CASE("messages name the file within the archive, with its line") {
  const Archive archive({manifest("scene.dae"), {"scene.dae", "<COLLADA version=\"1.4.1\">\n<asset>\n"}});
  CHECK(archive.error().find("a.zae/scene.dae:2:") == 0);
  CHECK(Archive({manifest("no.dae")}).error() == "a.zae/no.dae: there is no such file in the archive");
  CHECK(Archive(std::vector<ZipEntry>{{"manifest.xml", "<root/>"}})
            .error()
            .find("a.zae/manifest.xml:1:1: a manifest holds the document") == 0);
}

TEST_CASE("what would be too large is refused by its size, before it is unpacked") {
  CHECK(Archive({manifest("scene.dae"), {"scene.dae", "0123456789", 0x7fffffff}}).error() ==
        "a.zae/scene.dae: unpacked the file has 2147483647 bytes; at most 1073741824 are read");
  CHECK(
      Archive({manifest("scene.dae"), {"scene.dae", "0123456789", 100'000'000}}).error() ==
      "a.zae/scene.dae: 10 bytes become 100000000 when they are unpacked; beyond 67108864 bytes, at most 100 "
      "times as many are read");
}

TEST_CASE("a damaged archive is an error that says so") {
  const std::string whole = zip_text(
      {manifest("scene.dae"), {"scene.dae", collada_text(collada_triangle(), collada_shape_node())}});
  std::string changed = whole;
  changed[changed.find("COLLADA")] = 'X';  // its check sum tells
  CHECK(Archive(changed).error().find("a.zae/scene.dae: cannot be unpacked") == 0);
  CHECK(
      Archive(whole.substr(0, whole.size() / 2)).error().find("a.zae: not a zip archive that can be read") ==
      0);
  CHECK(Archive(std::string("no archive")).error().find("a.zae: not a zip archive that can be read") == 0);
}

}  // namespace twinray
