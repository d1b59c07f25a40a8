// SPDX-License-Identifier: Apache-2.0
// Small scenes for CS184's program, and its pictures of them.
#pragma once
#include <string>

#include "io/picture/image_file.h"
#include "tests/support/collada_text.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {

/// 16 numbers of a <matrix> that moves by (x, y, z).
inline std::string moved_by(const std::string& x, const std::string& y, const std::string& z) {
  return "1 0 0 " + x + " 0 1 0 " + y + " 0 0 1 " + z + " 0 0 0 1";
}

inline std::string cs184_node(const std::string& matrix, const std::string& instance) {
  return "<node id=\"n" + std::to_string(std::hash<std::string>{}(matrix + instance)) +
         "\" name=\"node\"><matrix>" + matrix + "</matrix>" + instance + "</node>\n";
}

/// A light of which CS184's program takes the CGL part, or that of COLLADA where `cgl` is empty.
inline std::string cs184_light(const std::string& common, const std::string& cgl = "") {
  const std::string extra =
      cgl.empty() ? "" : "<extra><technique profile=\"CGL\">" + cgl + "</technique></extra>";
  return "<library_lights><light id=\"light\" name=\"light\"><technique_common>" + common +
         "</technique_common>" + extra + "</light></library_lights>\n";
}

/// A geometry of one mesh: positions (triples) and triangles.
struct Cs184Mesh {
  int positions = 0;
  std::string numbers;
  int triangles = 0;
  std::string corners;
  std::string normals;  ///< Of each corner; empty: none.
};

inline std::string cs184_geometry(const std::string& id, const Cs184Mesh& mesh) {
  std::string vcount, normals, input;
  for (int i = 0; i < mesh.triangles; ++i) vcount += "3 ";
  if (!mesh.normals.empty()) {
    normals = collada_source(id + "-normals", mesh.positions, mesh.normals);
    input = "<input semantic=\"NORMAL\" source=\"#" + id + "-normals\" offset=\"0\"/>";
  }
  return "<geometry id=\"" + id + "\" name=\"" + id + "\"><mesh>" +
         collada_source(id + "-positions", mesh.positions, mesh.numbers) + normals + "<vertices id=\"" + id +
         "-vertices\"><input semantic=\"POSITION\" source=\"#" + id +
         "-positions\"/></vertices><polylist count=\"" + std::to_string(mesh.triangles) +
         "\"><input semantic=\"VERTEX\" source=\"#" + id + "-vertices\" offset=\"0\"/>" + input + "<vcount>" +
         vcount + "</vcount><p>" + mesh.corners + "</p></polylist></mesh></geometry>\n";
}

/// The square [-2, 2]^2 at y = 0, wound so that its front is up.
inline const Cs184Mesh floor_mesh{4, "-2 0 -2 2 0 -2 2 0 2 -2 0 2", 2, "0 2 1 0 3 2", ""};

inline std::string cs184_camera_library(const std::string& zfar) {
  return "<library_cameras><camera id=\"camera\" "
         "name=\"camera\"><optics><technique_common><perspective><xfov>"
         "50</xfov><aspect_ratio>1.333333</aspect_ratio><znear>0.01</znear><zfar>" +
         zfar + "</zfar></perspective></technique_common></optics></camera></library_cameras>\n";
}

/// A scene of these geometries and nodes, under these lights, with a camera that is placed by a matrix.
struct Cs184Scene {
  std::string geometries = cs184_geometry("floor", floor_mesh);
  std::string libraries;
  std::string nodes = cs184_node(moved_by("0", "0", "0"), "<instance_geometry url=\"#floor\"/>");
  std::string camera_matrix = moved_by("0", "2", "4");
  std::string zfar = "100";

  std::string text() const {
    return collada_text(cs184_camera_library(zfar) + libraries + "<library_geometries>" + geometries +
                            "</library_geometries>\n",
                        nodes + cs184_node(camera_matrix, "<instance_camera url=\"#camera\"/>"));
  }
};

/// A square lamp of 0.8 x 0.6 at y = 1.5 above the floor, shining down.
inline Cs184Scene lit_floor() {
  Cs184Scene scene;
  scene.libraries =
      cs184_light("<point><color>10 10 10</color></point>", "<area><color>10 10 10</color></area>");
  scene.nodes += cs184_node("0.8 0 0 0 0 0 1 1.5 0 -0.6 0 0 0 0 0 1", "<instance_light url=\"#light\"/>");
  return scene;
}

/// Runs CS184's program on a scene in a folder; the picture is "picture.exr" there, or what the options say.
inline ProcessResult run_cs184(const TemporaryFolder& folder, const Cs184Scene& scene,
                               const std::string& options) {
  write_text(folder.file("scene.dae"), scene.text());
  return run_shell("cd '" + folder.path().string() + "' && '" TWINRAY_PATHTRACER "' " + options +
                   " scene.dae");
}

/// The picture of these options.
inline Image cs184_picture(const Cs184Scene& scene, const std::string& options,
                           const std::string& name = "picture.exr") {
  const TemporaryFolder folder;
  const ProcessResult result = run_cs184(folder, scene, options + " -f " + name);
  if (result.exit_code != 0) throw Error(result.err);
  return read_image(folder.file(name));
}

inline double mean_luminance(const Image& image) {
  double sum = 0;
  for (const Rgb& pixel : image.pixels) sum += 0.2126 * pixel.r + 0.7152 * pixel.g + 0.0722 * pixel.b;
  return sum / double(image.pixels.size());
}

}  // namespace twinray::test
