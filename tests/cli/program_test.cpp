// SPDX-License-Identifier: Apache-2.0
// The program as a whole: exit codes, messages, files.
#include <fmt/format.h>

#include "io/picture/image_file.h"
#include "tests/support/catch.h"
#include "tests/support/collada_text.h"
#include "tests/support/json.h"
#include "tests/support/own_scenes.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

const std::string small_quiet = " -r 24 18 -s 2 -q ";

}  // namespace

TEST_CASE("a wrong command line ends with 2, the reason and the usage") {
  const ProcessResult result = run_program("--bvh-split=none " + box_scene);
  CHECK(result.exit_code == 2);
  CHECK(result.out.empty());
  CHECK(result.err ==
        "twinray: --bvh-split: there is no \"none\"; valid are sah, median, midpoint, mean\n"
        "usage: twinray [render] SCENE.dae [options]; all options: twinray --help\n");
  CHECK(run_program("").exit_code == 2);
}

TEST_CASE("help fits a tall screen of 108 lines and 100 columns, and version names engines") {
  const ProcessResult help = run_program("--help");
  CHECK(help.exit_code == 0);
  std::size_t lines = 0, widest = 0, width = 0;
  for (const char c : help.out) {
    width = c == '\n' ? 0 : width + 1;
    widest = std::max(widest, width);
    lines += c == '\n';
  }
  CHECK(lines <= 108);  // Cameras, pixels and displays have a line for each option.
  CHECK(widest <= 100);
  const ProcessResult version = run_program("--version");
  CHECK(version.exit_code == 0);
  CHECK(version.out.find("brute-force") != std::string::npos);
}

TEST_CASE("a scene that is not there, or an output that cannot be written, ends with 1 before rendering") {
  const TemporaryFolder folder;
  const ProcessResult missing = run_program("no-such-scene.dae -q -o " + quoted(folder.file("a.png")));
  CHECK(missing.exit_code == 1);
  CHECK(missing.err.find("no-such-scene.dae") != std::string::npos);
  const ProcessResult nowhere =
      run_program(box_scene + small_quiet + "-o " + quoted(folder.file("none/a.png")));
  CHECK(nowhere.exit_code == 1);
  CHECK(nowhere.err ==
        fmt::format("twinray: {}: there is no folder {}\n", folder.file("none/a.png"), folder.file("none")));
  const ProcessResult ending = run_program(box_scene + small_quiet + "-o " + quoted(folder.file("a.gif")));
  CHECK(ending.exit_code == 1);
  CHECK(ending.err ==
        fmt::format(
            "twinray: {}: a picture's name must end in .png, .jpg, .jpeg, .exr, .tif, .tiff, .hdr or .pfm\n",
            folder.file("a.gif")));
  const ProcessResult stats = run_program(box_scene + small_quiet + "-o " + quoted(folder.file("a.png")) +
                                          " --stats " + quoted(folder.file("none/s")));
  CHECK(stats.exit_code == 1);
  CHECK(stats.err ==
        fmt::format("twinray: {}: there is no folder {}\n", folder.file("none/s"), folder.file("none")));
  CHECK(folder.file_count() == 0);
}

TEST_CASE("a picture is written whole, and nothing else beside it") {
  const TemporaryFolder folder;
  REQUIRE(run_program(box_scene + small_quiet + "-o " + quoted(folder.file("a.exr"))).exit_code == 0);
  CHECK(folder.file_count() == 1);
  const Image image = read_image(folder.file("a.exr"));
  CHECK(image.width == 24);
  CHECK(image.height == 18);
}

TEST_CASE("costs are colours with a legend beside the picture, and numbers in an .exr") {
  const TemporaryFolder folder;
  const std::string options = box_scene + small_quiet + "--accel=brute-force --integrator=cost -o ";
  REQUIRE(run_program(options + quoted(folder.file("a.EXR"))).exit_code == 0);
  CHECK(folder.file_count() == 2);
  for (const Rgb& pixel : read_image(folder.file("a.EXR")).pixels) CHECK(pixel == Rgb{12, 12, 12});
  CHECK(read_image(folder.file("a_legend.png")).height == 221);
  REQUIRE(run_program(options + quoted(folder.file("b.png"))).exit_code == 0);
  CHECK(folder.file_count() == 4);
  const Image colors = read_image(folder.file("b.png"));
  CHECK(colors.width == 24);
  CHECK(colors.at(0, 0).g > colors.at(0, 0).r);  // 12 of 20 is green
}

TEST_CASE("render is the subcommand that may be left out") {
  const TemporaryFolder folder;
  REQUIRE(run_program("render " + box_scene + small_quiet + "-o " + quoted(folder.file("a.exr"))).exit_code ==
          0);
  REQUIRE(run_program(box_scene + small_quiet + "-o " + quoted(folder.file("b.exr"))).exit_code == 0);
  CHECK(read_image(folder.file("a.exr")).pixels == read_image(folder.file("b.exr")).pixels);
}

TEST_CASE("paths one after the other give the picture of the default, and are named in help") {
  const TemporaryFolder folder;
  const std::string options = box_scene + small_quiet + "-s 3 -l 2 -m 6 ";
  REQUIRE(run_program(options + "-o " + quoted(folder.file("a.exr"))).exit_code == 0);
  REQUIRE(run_program(options + "--integrator=path-reference -o " + quoted(folder.file("b.exr"))).exit_code ==
          0);
  CHECK(read_image(folder.file("a.exr")).pixels == read_image(folder.file("b.exr")).pixels);
  CHECK(run_program("render --help").out.find("path-reference") != std::string::npos);
}

TEST_CASE("adaptive sampling writes its sample rates beside the picture") {
  const TemporaryFolder folder;
  REQUIRE(
      run_program(box_scene + small_quiet + "-s 64 -a 8 0.5 -o " + quoted(folder.file("a.png"))).exit_code ==
      0);
  CHECK(folder.file_count() == 2);
  CHECK(read_image(folder.file("a_rate.png")).width == 24);
}

TEST_CASE("statistics are JSON, and brute force tests each primitive for each ray of normal shading") {
  const TemporaryFolder folder;
  const std::string stats = folder.file("stats.json");
  REQUIRE(run_program(box_scene +
                      " -r 24 18 -s 1 -q --integrator=normals --count --accel=brute-force --stats " +
                      quoted(stats) + " -o " + quoted(folder.file("a.png")))
              .exit_code == 0);
  const nlohmann::json json = nlohmann::json::parse(read_text(stats));
  CHECK(json["rays"]["total"] == 24 * 18);
  CHECK(json["rays"]["camera"] == 24 * 18);
  CHECK(json["per_ray"]["primitives"] == json["build"]["primitives"]);
}

TEST_CASE("what hemisphere sampling leaves out is a warning on stderr, in quiet runs too") {
  const TemporaryFolder folder;
  const std::string lights = TWINRAY_SOURCE_DIR "/scenes/lights.dae" + small_quiet;
  const ProcessResult result = run_program(lights + "-H -o " + quoted(folder.file("a.png")));
  CHECK(result.exit_code == 0);
  CHECK(result.out.empty());
  CHECK(result.err ==
        "warning: hemisphere sampling finds no light from a point, a single direction or an invisible shape: "
        "\"point\", "
        "\"faded\", \"spot\", \"sun\" add nothing to the picture; --direct=lights would show them\n");
  CHECK(run_program(lights + "-o " + quoted(folder.file("b.png"))).err.empty());
}

TEST_CASE("a scene without a light is a warning") {
  const TemporaryFolder folder;
  const std::string ball =
      "<library_geometries><geometry id=\"ball\"><extra><technique profile=\"CGL\"><sphere><radius>1"
      "</radius></sphere></technique></extra></geometry></library_geometries>\n";
  write_text(folder.file("dark.dae"),
             collada_text(ball, "<node id=\"node\"><instance_geometry url=\"#ball\"/></node>\n"));
  const ProcessResult result =
      run_program(quoted(folder.file("dark.dae")) + small_quiet + "-o " + quoted(folder.file("a.png")));
  CHECK(result.exit_code == 0);
  CHECK(result.err ==
        "warning: the scene has no light: the picture will be black; --default-light lights it by a "
        "soft sky\n");
}

TEST_CASE("the word help is the option") {
  const ProcessResult help = run_program("help");
  CHECK(help.exit_code == 0);
  CHECK(help.out == run_program("--help").out);
  CHECK(run_program("help convert").out == run_program("convert --help").out);
}

TEST_CASE("samples per light have an effect on the light that a scene without any gets") {
  const std::string blocks = quoted(std::string(TWINRAY_SOURCE_DIR) + "/scenes/blocks.obj");
  const TemporaryFolder folder;
  const std::string render = "-r 16 12 -s 1 -t 1 -q -l 4 -o " + quoted(folder.file("a.exr")) + " ";
  CHECK(run_program(render + blocks).err.find("--light-samples") == std::string::npos);
  CHECK(run_program(render + "--strict " + blocks).exit_code == 0);
}

TEST_CASE(
    "option --default-light lights a dark scene so that what stands before the camera has its own color") {
  const TemporaryFolder folder;
  // A gray wall fills the view, at a distance from which light that falls off would not be seen.
  write_text(
      folder.file("dark.dae"),
      collada_text(collada_mesh(3, "-9e4 -9e4 -100  9e4 -9e4 -100  0 9e4 -100",
                                "<triangles count=\"1\"><input semantic=\"VERTEX\" source=\"#vertices\" "
                                "offset=\"0\"/><p>0 1 2</p></triangles>\n") +
                       "<library_cameras><camera id=\"eye\"><optics><technique_common><perspective><xfov>1"
                       "</xfov></perspective></technique_common></optics></camera></library_cameras>",
                   "<node><instance_geometry url=\"#shape\"/><instance_camera url=\"#eye\"/></node>\n"));
  const std::string picture = folder.file("a.exr");
  const ProcessResult result = run_program(quoted(folder.file("dark.dae")) + small_quiet +
                                           "-s 64 --default-light -o " + quoted(picture));
  CHECK(result.exit_code == 0);
  CHECK(result.err.empty());
  CHECK(mean_of(read_image(picture)).r == Approx(0.5f).epsilon(0.01));
  const ProcessResult lit = run_program(box_scene + small_quiet + "--default-light -o " + quoted(picture));
  CHECK(lit.exit_code == 0);
  CHECK(lit.err ==
        "warning: --default-light: no effect, for the scene has light; --default-light=always adds to it\n");
}

TEST_CASE("option --default-light=always adds to a scene's own light") {
  const TemporaryFolder folder;
  const auto mean = [&](const std::string& option) {
    const std::string picture = folder.file("a.exr");
    const ProcessResult result =
        run_program(box_scene + small_quiet + "-s 16 " + option + " -o " + quoted(picture));
    CHECK(result.exit_code == 0);
    CHECK(result.err.empty());
    return mean_of(read_image(picture)).g;
  };
  CHECK(mean("--default-light=always") > mean("") + 0.1f);
  const ProcessResult wrong =
      run_program(box_scene + small_quiet + "--default-light=bright -o " + quoted(folder.file("b.exr")));
  CHECK(wrong.exit_code == 2);
  CHECK(wrong.err.find("--default-light: \"bright\" is not valid; it stands alone or is "
                       "--default-light=always") != std::string::npos);
}

TEST_CASE("an OBJ file is lit by default, unless something else lights it") {
  const TemporaryFolder folder;
  write_text(folder.file("a.obj"), "v -9 -9 0\nv 9 -9 0\nv 0 9 0\nf 1 2 3\n");
  write_text(folder.file("lamp.obj"), "mtllib a.mtl\nv -9 -9 0\nv 9 -9 0\nv 0 9 0\nusemtl m\nf 1 2 3\n");
  write_text(folder.file("a.mtl"), "newmtl m\nKe 1 1 1\n");
  write_png(folder.file("white.png"), {1, 1, {255, 255, 255}});
  const std::string picture = folder.file("a.png"),
                    to = " -r 24 18 -s 2 --progress=none -o " + quoted(picture);
  const std::string note = "note: the file has no light: a soft sky, and a light at the camera\n";
  const auto has_note = [&](const std::string& words) {
    const ProcessResult result = run_program(words + to);
    CHECK(result.err.empty());
    return result.out.find(note) != std::string::npos;
  };
  CHECK(has_note(quoted(folder.file("a.obj"))));
  CHECK(luminance(mean_of(read_image(picture))) > 0.01f);
  CHECK(!has_note(quoted(folder.file("a.obj")) + " -e " + quoted(folder.file("white.png"))));
  CHECK(!has_note(quoted(folder.file("lamp.obj"))));
  CHECK(!has_note(quoted(folder.file("a.obj")) + " --integrator=normals"));
}

TEST_CASE("a scene that media light has no default light") {
  const TemporaryFolder folder;
  const auto is_lit_by_default = [&](const std::string& light) {
    const std::string scene = folder.file("a.pbrt");
    write_text(scene,
               "LookAt 0 0 9  0 0 0  0 1 0 Camera \"perspective\" WorldBegin MakeNamedMedium \"m\" \"string "
               "type\" \"homogeneous\" " +
                   light +
                   " MediumInterface \"m\" \"\" Material \"interface\" "
                   "Shape \"sphere\"");
    const ProcessResult result = run_program(
        quoted(scene) + " --default-light -r 24 18 -s 1 --progress=none -o " + quoted(folder.file("a.png")));
    CHECK(result.exit_code == 0);
    return result.err.find("--default-light: no effect, for the scene has light") == std::string::npos;
  };
  CHECK(is_lit_by_default(""));
  CHECK_FALSE(is_lit_by_default("\"rgb Le\" [ 1 1 1 ]"));
}

TEST_CASE("option --clip=file cuts the view at the file's clip distances, also those of a camera file") {
  const TemporaryFolder folder;
  const std::string picture = folder.file("a.exr");
  const auto rendered = [&](const std::string& options) {
    CHECK(run_program(box_scene + small_quiet + "--integrator=normals -o " + quoted(picture) + options)
              .exit_code == 0);
    return read_image(picture).pixels;
  };
  const auto is_empty = [](const std::vector<Rgb>& pixels) {
    return std::all_of(pixels.begin(), pixels.end(), [](const Rgb& pixel) { return is_black(pixel); });
  };
  write_text(folder.file("near.info"),  // sees nothing nearer than 1000
             "50 35 1.33 1000 2000 0 1 3 0 0 0 0 0 3 0.1 10 1 0 0 0 1 0 0 0 1 480 360 500 4.56 0\n");
  const std::string camera = " -c " + quoted(folder.file("near.info"));
  CHECK(!is_empty(rendered(camera)));
  CHECK(is_empty(rendered(camera + " --clip=file")));
  CHECK(!is_empty(rendered(camera + " --clip=file --view=whole")));
}

TEST_CASE("an option without effect is a warning, in quiet runs too, and ends a strict run with 2") {
  const TemporaryFolder folder;
  const std::string line =
      box_scene + small_quiet + "--accel=brute-force --bvh-split=mean -o " + quoted(folder.file("a.png"));
  const std::string reason = "--bvh-split: no effect, for the engine is brute-force; --accel=bvh takes it\n";
  const ProcessResult lenient = run_program(line);
  CHECK(lenient.exit_code == 0);
  CHECK(lenient.err == "warning: " + reason);
  const ProcessResult strict = run_program(line + " --strict");
  CHECK(strict.exit_code == 2);
  CHECK(strict.err.find("twinray: " + reason + "usage: ") == 0);
}

TEST_CASE("a generated scene is rendered, crosschecked and measured by its name") {
  const TemporaryFolder folder;
  CHECK(run_program("generated:ball:1000" + small_quiet + "-o " + quoted(folder.file("a.png"))).exit_code ==
        0);
  CHECK(run_program("crosscheck generated:ball:1000 -q --rays=200 --engines=bvh,bvh-2").exit_code == 0);
  CHECK(run_program("stats generated:ball:1000 -q -r 2 2 --seconds=0").exit_code == 0);
  const ProcessResult wrong = run_program("stats generated:cube -q");
  CHECK(wrong.exit_code == 1);
  CHECK(wrong.err ==
        "twinray: generated:cube: there is no such scene; valid are generated:room, generated:ball, "
        "generated:forest, generated:woods, generated:stadium, each with :N behind it for N triangles "
        "or, of the last two, instances\n");
}

TEST_CASE("warnings of a scene file are printed by every command, in quiet runs too") {
  const std::string scene = TWINRAY_SOURCE_DIR "/tests/bad/warning_attribute.dae";
  const TemporaryFolder folder;
  for (const std::string& command :
       {scene + small_quiet + "-o " + quoted(folder.file("a.png")), "stats -q -r 2 2 --seconds=0 " + scene,
        "agreement -q -r 2 2 -s 1 " + scene, "crosscheck -q --rays=100 --engines=bvh,bvh-2 " + scene})
    CHECK(run_program(command).err.find("warning: " + scene) == 0);
}

TEST_CASE("what an engine does not know is neither printed nor written as 0") {
  const TemporaryFolder folder;
  const std::string stats = folder.file("a.json");
  const ProcessResult result =
      run_program(box_scene + " -r 8 6 -s 1 --count --accel=brute-force --integrator=normals -o " +
                  quoted(folder.file("a.png")) + " --stats " + quoted(stats));
  CHECK(result.out.find("nodes") == std::string::npos);
  CHECK(result.out.find("SAH") == std::string::npos);
  CHECK(result.out.find("\nPer ray        0.0000 leaves, 12.0000 intersection tests\n") != std::string::npos);
  const nlohmann::json json = nlohmann::json::parse(read_text(stats));
  for (const char* key : {"nodes", "leaves", "depth", "sah_cost"}) CHECK(json["build"][key].is_null());
  for (const char* key : {"nodes", "boxes"}) CHECK(json["per_ray"][key].is_null());
  CHECK(json["counts"]["primitives"] == 12 * 48);
}

#ifdef TWINRAY_WITH_EMBREE
TEST_CASE("counts of Embree's way are said to be those of this machine") {
  const TemporaryFolder folder;
  const std::string line =
      box_scene + " -r 8 6 -s 1 --count -o " + quoted(folder.file("a.png")) + " --accel=";
  const std::string said = "(Embree's way: other machines may count otherwise)";
  CHECK(run_program(line + "embree").out.find(said) != std::string::npos);
  CHECK(run_program(line + "bvh").out.find(said) == std::string::npos);
  CHECK(run_program("stats -r 2 2 --seconds=0 " + box_scene)
            .out.find("\nOther machines may count otherwise in embree; all other counts are the same "
                      "everywhere.\n") != std::string::npos);
}
#endif

TEST_CASE("one of several cameras is chosen by its name, and all are listed on request") {
  const TemporaryFolder folder;
  const auto camera = [](const std::string& id) {
    return "<camera id=\"" + id +
           "\"><optics><technique_common><orthographic><xmag>1</xmag></orthographic></technique_common></"
           "optics>"
           "</camera>";
  };
  const std::string scene = folder.file("two cameras.dae");
  write_text(scene, collada_text("<library_cameras>" + camera("front") + camera("top") +
                                     "</library_cameras>" + collada_triangle(),
                                 collada_shape_node() + "<node><instance_camera url=\"#front\"/></node>"
                                                        "<node><instance_camera url=\"#top\"/></node>"));
  const ProcessResult list = run_program("render " + quoted(scene) + " --camera-name=?");
  CHECK(list.exit_code == 0);
  CHECK(list.out == "front (makes the picture)\ntop\n");
  const std::string picture = " -o " + quoted(folder.file("a.png")) + " -r 8 6 -s 1";
  const ProcessResult top = run_program("render " + quoted(scene) + " --camera-name=top" + picture);
  CHECK(top.exit_code == 0);
  CHECK(top.out.find(
            "camera: \"top\", one of 2; --camera-name=NAME chooses another, --camera-name=? lists them") !=
        std::string::npos);
  const ProcessResult wrong = run_program("render " + quoted(scene) + " --camera-name=left" + picture);
  CHECK(wrong.exit_code == 1);
  CHECK(wrong.err ==
        "twinray: " + scene +
            ": no camera, and no node of one, has the name \"left\"; the scene has \"front\", \"top\"\n");
}

TEST_CASE("a camera that a file of one camera, or of none, does not have is an error") {
  const TemporaryFolder folder;
  const std::string scenes = std::string(TWINRAY_SOURCE_DIR) + "/scenes/";
  const std::string picture = " -q -o " + quoted(folder.file("a.png")) + " -r 8 6 -s 1";
  const auto error = [&](const std::string& scene, const std::string& name) {
    return run_program("render " + quoted(scene) + " --camera-name=" + name + picture).err;
  };
  CHECK(error(scenes + "materials.pbrt", "left") ==
        "twinray: " + scenes +
            "materials.pbrt: no camera has the name \"left\"; the scene has \"perspective\"\n");
  CHECK(error(scenes + "materials.pbrt", "perspective").empty());
  CHECK(error(scenes + "blocks.obj", "left") ==
        "twinray: " + scenes + "blocks.obj: no camera has the name \"left\"; the scene has no camera\n");
  CHECK(error("generated:ball", "left") ==
        "twinray: generated:ball: no camera has the name \"left\"; the scene has \"generated:ball\"\n");
  const std::string exchange = folder.file("box.json");
  CHECK(run_program("convert -q " + box_scene + " " + quoted(exchange)).exit_code == 0);
  CHECK(run_program("render " + quoted(exchange) + " --camera-name=?").out == "camera (makes the picture)\n");
}

TEST_CASE("what only some files and cameras have is an option without effect for others") {
  const TemporaryFolder folder;
  const std::string scenes = std::string(TWINRAY_SOURCE_DIR) + "/scenes/";
  const auto warnings = [&](const std::string& scene, const std::string& options) {
    return run_program("render " + quoted(scenes + scene) + " -q -r 8 6 -s 2 -o " +
                       quoted(folder.file("a.png")) + " " + options)
        .err;
  };
  CHECK(warnings("materials.pbrt", "--clip=file") ==
        "warning: --clip: no effect, for the file's camera has no clip distances\n");
  CHECK(warnings("box.dae", "--clip=file").empty());
  CHECK(warnings("materials.pbrt", "--clip=1,20").empty());
  CHECK(warnings("materials.pbrt", "--keep-both-lamps") ==
        "warning: --keep-both-lamps: no effect, for the scene is no COLLADA file\n");
  CHECK(warnings("blocks.obj", "--attenuation=file") ==
        "warning: --attenuation: no effect, for the scene is no COLLADA file\n");
  CHECK(warnings("box.dae", "--keep-both-lamps") ==
        "warning: --keep-both-lamps: no effect, for the scene has no lamp that is given twice\n");
  CHECK(warnings("materials.pbrt", "--projection=fisheye --aperture-blades=5") ==
        "warning: --aperture-blades: no effect, for panoramas have no lens\n");
}

TEST_CASE("a glTF file is shown at a time, and a scene in which nothing moves warns") {
  const TemporaryFolder folder;
  const std::string rest = " -o " + quoted(folder.file("a.png")) + " -r 8 6 -s 1";
  const std::string sources = TWINRAY_SOURCE_DIR;
  const ProcessResult moving =
      run_program("render " + quoted(sources + "/tests/fuzz/seeds/gltf/moving.glb") + " --time=0.5" + rest);
  CHECK(moving.exit_code == 0);
  CHECK(moving.out.find("animation: 0 to 1 s, shown at 0.5 s\n") != std::string::npos);
  const ProcessResult still =
      run_program("render " + quoted(sources + "/scenes/box.dae") + " --time=0.5" + rest);
  CHECK(still.err.find("--time: no effect, for nothing in the scene moves") != std::string::npos);
  CHECK(run_program("render " + quoted(sources + "/scenes/box.dae") + " --strict --time=0.5" + rest)
            .exit_code != 0);
}

}  // namespace twinray::test
