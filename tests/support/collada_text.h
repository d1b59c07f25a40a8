// SPDX-License-Identifier: Apache-2.0
// COLLADA documents in a few lines, for tests.
#pragma once
#include <string>
#include <vector>

#include "io/collada/collada.h"
#include "tests/support/error_text.h"

namespace twinray {

/// A document of these libraries and these nodes of its scene.
inline std::string collada_text(const std::string& libraries, const std::string& nodes,
                                const std::string& up_axis = "Y_UP") {
  return "<COLLADA version=\"1.4.1\"><asset><up_axis>" + up_axis + "</up_axis></asset>\n" + libraries +
         "<library_visual_scenes><visual_scene id=\"world\">\n" + nodes +
         "</visual_scene></library_visual_scenes>\n"
         "<scene><instance_visual_scene url=\"#world\"/></scene></COLLADA>\n";
}

/// <source id="ID"> of triples.
inline std::string collada_source(const std::string& id, int count, const std::string& numbers) {
  return "<source id=\"" + id + "\"><float_array id=\"" + id + "-array\" count=\"" +
         std::to_string(3 * count) + "\">" + numbers +
         "</float_array><technique_common><accessor source=\"#" + id + "-array\" count=\"" +
         std::to_string(count) +
         "\" stride=\"3\"><param name=\"X\"/><param name=\"Y\"/><param "
         "name=\"Z\"/></accessor></technique_common>"
         "</source>\n";
}

/// A library with one geometry, "shape": a mesh of these positions, further sources and primitive elements.
/// Vertices are "#vertices".
inline std::string collada_mesh(int count, const std::string& positions, const std::string& rest) {
  return "<library_geometries><geometry id=\"shape\"><mesh>\n" +
         collada_source("positions", count, positions) +
         "<vertices id=\"vertices\"><input semantic=\"POSITION\" source=\"#positions\"/></vertices>\n" +
         rest + "</mesh></geometry></library_geometries>\n";
}

/// A node with collada_mesh()'s geometry, behind these transforms.
inline std::string collada_shape_node(const std::string& transforms = "") {
  return "<node>" + transforms + "<instance_geometry url=\"#shape\"/></node>";
}

/// The triangle (0, 0, 0), (1, 0, 0), (0, 1, 0), whose front is towards +z.
inline std::string collada_triangle() {
  return collada_mesh(3, "0 0 0 1 0 0 0 1 0",
                      "<triangles count=\"1\"><input semantic=\"VERTEX\" source=\"#vertices\" offset=\"0\"/>"
                      "<p>0 1 2</p></triangles>\n");
}

inline LoadedScene load_collada(const std::string& text, const LoadOptions& options = {}) {
  return read_collada(*XmlDocument::parse(text, "scene.dae"), options);
}

/// The text of the error that loading throws; "" for none.
inline std::string collada_error(const std::string& text, const LoadOptions& options = {}) {
  return test::error_text([&] { load_collada(text, options); });
}

inline const Mesh& mesh_of(const LoadedScene& loaded, std::size_t shape = 0) {
  return *loaded.scene.geometry->mesh(std::uint32_t(shape));
}

/// What a reader had to warn of.
inline std::vector<std::string> messages(const LoadedScene& loaded) {
  std::vector<std::string> result;
  for (const Diagnostic& warning : loaded.warnings) result.push_back(warning.message);
  return result;
}

}  // namespace twinray
