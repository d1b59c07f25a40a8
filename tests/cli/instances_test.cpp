// SPDX-License-Identifier: Apache-2.0
// Scenes whose files show shapes many times, as a program.
#include <fmt/format.h>

#include <cmath>

#include "accel/accelerator.h"
#include "io/picture/image_file.h"
#include "tests/support/catch.h"
#include "tests/support/json.h"
#include "tests/support/own_scenes.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

const std::string pawns = TWINRAY_SOURCE_DIR "/scenes/pawns.pbrt";

/// Renders the pawns, small; the picture's bytes.
std::string render(const TemporaryFolder& folder, const std::string& name, const std::string& options) {
  const ProcessResult result = run_program(
      fmt::format("{} -q -r 60 40 -s 4 {} -o {}", quoted(pawns), options, quoted(folder.file(name))));
  CAPTURE(options, result.err);
  CHECK(result.exit_code == 0);
  return read_text(folder.file(name));
}

}  // namespace

TEST_CASE("a picture of instances has the same bytes by every engine and with any number of threads") {
  const TemporaryFolder folder;
  const std::string expected = render(folder, "a.pfm", "--instances=keep --accel=brute-force");
  for (const char* options : {"--accel=bvh", "--accel=bvh --bvh-width=2 -t 3",
                              "--accel=bvh --simd=scalar -t 1", "--accel=bvh --bvh-quality=high"})
    CHECK(render(folder, "b.pfm", fmt::format("--instances=keep {}", options)) == expected);
  if (default_backend() == Backend::embree)
    CHECK(render(folder, "b.pfm", "--instances=keep --accel=embree") == expected);
}

TEST_CASE("a picture of instances is that of copies, but for rounding") {
  const TemporaryFolder folder;
  render(folder, "kept.exr", "--instances=keep");
  const std::string copied = render(folder, "copied.exr", "--instances=copy");
  CHECK(render(folder, "auto.exr", "") != copied);  // It tells its command.
  const Image a = read_image(folder.file("kept.exr")), b = read_image(folder.file("copied.exr"));
  REQUIRE(a.pixels.size() == b.pixels.size());
  CHECK(read_image(folder.file("auto.exr")).pixels == b.pixels);
  // A rounded direction moves a point of a mirror's image; few paths choose another way by it.
  int different = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    different += std::fabs(luminance(a.pixels[i]) - luminance(b.pixels[i])) > 0.01f * luminance(b.pixels[i]);
  CHECK(different < int(a.pixels.size()) / 50);
}

TEST_CASE("what --instances may be, and where it has no effect") {
  const TemporaryFolder folder;
  const ProcessResult wrong =
      run_program(quoted(pawns) + " --instances=many -o " + quoted(folder.file("a.png")));
  CHECK(wrong.exit_code == 2);
  CHECK(wrong.err.find("--instances") != std::string::npos);
  CHECK(wrong.err.find("auto, keep, copy") != std::string::npos);
  const std::string rest = " -r 8 8 -s 1 --instances=keep -o " + quoted(folder.file("b.png"));
  const ProcessResult useless = run_program(quoted(box_scene) + rest);
  CHECK(useless.exit_code == 0);
  CHECK(useless.err.find("--instances: no effect, for the scene's file shows nothing by instances") !=
        std::string::npos);
  CHECK(run_program(quoted(box_scene) + " --strict" + rest).exit_code == 2);
  const std::string copied = " -r 8 8 -s 1 --instances=copy -o " + quoted(folder.file("c.png"));
  CHECK(run_program("generated:woods:10" + copied).err.find("--instances: no effect, for generated scenes") !=
        std::string::npos);
  CHECK(run_program(quoted(pawns) + copied).err.find("no effect") == std::string::npos);
  const std::string nothing = "--instances: no effect, for the scene's file shows nothing by instances";
  const std::string sources = TWINRAY_SOURCE_DIR;
  for (const std::string& scene : {box_scene, sources + "/scenes/table.gltf", sources + "/scenes/blocks.obj",
                                   sources + "/scenes/materials.pbrt"})
    CHECK(run_program(quoted(scene) + copied).err.find(nothing) != std::string::npos);
  CHECK(run_program(quoted(box_scene) + " --strict" + copied).exit_code == 2);
}

TEST_CASE("statistics count the instances that rays enter") {
  const TemporaryFolder folder;
  render(folder, "a.png", "--instances=keep --count --accel=bvh --stats " + quoted(folder.file("a.json")));
  const auto stats = nlohmann::json::parse(read_text(folder.file("a.json")));
  CHECK(stats["counts"]["instances"].get<int>() > 0);
  CHECK(stats["build"]["primitives"] == 2 + 289);
}

TEST_CASE("a crosscheck of instances finds nothing unexplained") {
  const ProcessResult result =
      run_program("crosscheck --instances=keep --rays=30000 --json " + quoted(pawns));
  CHECK(result.exit_code == 0);
  CHECK(result.out.find("\"unexplained\":") != std::string::npos);
}

TEST_CASE("a ray and a sample of an instance are told with its number") {
  // The first pawn stands there.
  const ProcessResult shot =
      run_program("crosscheck -q --instances=keep --engines=bvh,brute-force --ray=1.6,20,0,0,-1,0,0,inf " +
                  quoted(pawns));
  CHECK(shot.exit_code == 0);
  CHECK(shot.out.find(" of 2:0 of instance 0 (identical)") != std::string::npos);
  CHECK(shot.out.find("of 2:0 of instance 0\n") != std::string::npos);  // By exact arithmetic.
  const TemporaryFolder folder;
  const std::string json = folder.file("path.json");
  const ProcessResult path = run_program(fmt::format(
      "{} --instances=keep -r 480 320 --replay 300 150 0 --replay-json={}", quoted(pawns), quoted(json)));
  CHECK(path.exit_code == 0);
  CHECK(path.out.find(", of instance 3, at t = ") != std::string::npos);
  CHECK(nlohmann::json::parse(read_text(json))["vertices"][0]["surface"]["instance"] == 3);
}

TEST_CASE("convert writes instances or, if it is asked, copies") {
  const TemporaryFolder folder;
  const auto convert = [&](const char* use) {
    const std::string path = folder.file("a.json");
    const ProcessResult result =
        run_program(fmt::format("convert {} {} --instances={} -q", quoted(pawns), quoted(path), use));
    CAPTURE(result.err);
    CHECK(result.exit_code == 0);
    return nlohmann::json::parse(read_text(path));
  };
  const auto kept = convert("keep"), copied = convert("copy");
  CHECK(kept["version"] == 2);
  CHECK(kept["instances"].size() > 1);
  CHECK(copied["version"] == 1);
  CHECK_FALSE(copied.contains("instances"));
  CHECK(copied["shapes"].size() > kept["shapes"].size());
}

}  // namespace twinray::test
