// SPDX-License-Identifier: Apache-2.0
// Each broken file in tests/bad, with the text beside it that loading it must produce: the error, or, where
// it loads, its warnings one after the other.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "io/scene_file.h"
#include "tests/support/catch.h"

namespace twinray {
namespace {

const std::filesystem::path folder = std::filesystem::path(TWINRAY_SOURCE_DIR) / "tests" / "bad";

std::vector<std::string> bad_files() {
  const std::set<std::string> extensions{".dae", ".glb", ".gltf", ".json", ".pbrt"};
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (extensions.count(entry.path().extension().string()) > 0)
      names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string read_text(const std::filesystem::path& path) {
  std::ifstream stream(path);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Messages name the file as it was given; the texts have its name alone.
std::string without_folder(std::string text) {
  const std::string prefix = folder.string() + "/";
  for (std::size_t at; (at = text.find(prefix)) != std::string::npos;) text.erase(at, prefix.size());
  return text;
}

std::string outcome(const std::string& name) {
  std::string text;
  try {
    for (const Diagnostic& warning : load_scene((folder / name).string()).warnings)
      text += warning.text() + "\n";
  } catch (const Error& error) {
    text = std::string(error.what()) + "\n";
  }
  return without_folder(text);
}

}  // namespace

TEST_CASE("each broken file gives exactly its message") {
  const auto names = bad_files();
  REQUIRE(names.size() >= 80);
  for (const std::string& name : names) {
    INFO(name);
    const std::string expected = read_text((folder / name).replace_extension(".txt"));
    CHECK(!expected.empty());
    CHECK(outcome(name) == expected);
  }
}

TEST_CASE("in strict mode a warning is an error with the same text") {
  for (const std::string& name : bad_files()) {
    if (name.rfind("warning_", 0) != 0) continue;
    INFO(name);
    const std::string expected = read_text((folder / name).replace_extension(".txt"));
    std::string text;
    try {
      load_scene((folder / name).string(), {.strict = true});
    } catch (const Error& error) {
      text = without_folder(error.what());
    }
    CHECK(!text.empty());
    CHECK(text.substr(0, text.find(" (")) == expected.substr(0, std::min(text.find(" ("), text.size())));
  }
}

TEST_CASE("a missing file, a directory and another format are named") {
  const auto message = [](const std::string& path) -> std::string {
    try {
      load_scene(path);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  CHECK(message("no/such.dae") == "no/such.dae: there is no such file");
  CHECK(message("no/such.obj") == "no/such.obj: there is no such file");
  CHECK(message(folder.string()) == folder.string() + ": this is a directory; a scene file is needed");
  const std::string text = (folder / "empty.txt").string();
  CHECK(message(text) ==
        text +
            ": \".txt\" is not the extension of a scene file; valid are .3mf (3MF), .dae .zae (COLLADA), "
            ".stl (STL), .obj (Wavefront), .ply .ply.gz (a mesh), .fbx .3ds .off .x .lwo .ase .ac "
            ".dxf .amf .x3d (by Assimp), .gltf .glb (glTF 2.0), .pbrt .pbrt.gz (pbrt-v4), .json (twinray's "
            "exchange form)");
}

}  // namespace twinray
