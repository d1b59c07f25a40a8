// SPDX-License-Identifier: Apache-2.0
// Pictures on surfaces in bounded memory, as a program.
#include <fmt/format.h>

#include <filesystem>

#include "io/picture/image_file.h"
#include "tests/support/arguments.h"
#include "tests/support/catch.h"
#include "tests/support/json.h"
#include "tests/support/process.h"
#include "tests/support/random.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

/// A floor to the horizon with one picture, behind a fence with holes by another, under a bumpy wall.
constexpr const char* mapped_scene = R"(
LookAt 0 1 4  0 0.6 0  0 1 0
Camera "perspective" "float fov" 60
WorldBegin
LightSource "infinite" "rgb L" [1 1 1]
Texture "noise" "spectrum" "imagemap" "string filename" "noise.png" "float uscale" 3 "float vscale" 3
Texture "holes" "float" "imagemap" "string filename" "holes.png" "string encoding" "linear"
Material "diffuse" "texture reflectance" "noise"
Shape "bilinearmesh" "point3 P" [-9 0 -9  9 0 -9  -9 0 4  9 0 4]
Material "coateddiffuse" "texture reflectance" "noise" "texture displacement" "holes"
Shape "bilinearmesh" "point3 P" [-9 0 -5  9 0 -5  -9 9 -5  9 9 -5]
Material "diffuse" "texture reflectance" "noise" "string normalmap" "noise.png"
Shape "bilinearmesh" "point3 P" [-2 0 0  0 0 0  -2 2 0  0 2 0] "texture alpha" "holes"
)";

void write_noise(const std::string& path, int width, int height) {
  ByteImage image{width, height, {}};
  Random random(7);
  for (int i = 0; i < 3 * width * height; ++i) image.bytes.push_back(std::uint8_t(256 * random.unit()));
  write_png(path, image);
}

}  // namespace

TEST_CASE("a picture has the same bytes with any memory for textures, which is kept to and told of") {
  const TemporaryFolder folder;
  write_text(folder.file("a.pbrt"), mapped_scene);
  write_noise(folder.file("noise.png"), 700, 500);
  write_noise(folder.file("holes.png"), 300, 200);
  const auto render = [&](const std::string& name, const std::string& options) {
    return run_program(fmt::format("{} -r 40 30 -s 2 {} -o {} --stats {}", quoted(folder.file("a.pbrt")),
                                   options, quoted(folder.file(name + ".exr")),
                                   quoted(folder.file(name + ".json"))));
  };
  const auto pixels = [&](const std::string& name) { return read_image(folder.file(name + ".exr")).pixels; };
  const ProcessResult whole = render("whole", "");
  CHECK(whole.err.empty());
  CHECK(whole.out.find("Textures") == std::string::npos);
  CHECK(nlohmann::json::parse(read_text(folder.file("whole.json")))["textures"].is_null());
  for (const std::string filter : {"", " --texture-filter=trilinear", " --accel=bvh -t 2"}) {
    REQUIRE(render("other", filter).exit_code == 0);
    for (const char* megabytes : {"0", "0.2", "1000"}) {
      CAPTURE(filter, megabytes);
      const ProcessResult result = render("bounded", fmt::format("--texture-memory={}{}", megabytes, filter));
      CHECK(result.err.find("warning") == std::string::npos);  // A slow machine shows its progress.
      CHECK(result.out.find("\nTextures       3 pictures of 12.2 MB: ") != std::string::npos);
      CHECK(pixels("bounded") == pixels("other"));
      const auto json = nlohmann::json::parse(read_text(folder.file("bounded.json")))["textures"];
      CHECK(json["pictures"] == 3);
      CHECK(json["tiles_failed"] == 0);
      CHECK(json["peak_bytes"] <= json["limit_bytes"]);
      CHECK(json["lookups"] > json["tiles_read"]);
      CHECK(json["bytes_read"] == 49152 * json["tiles_read"].get<std::uint64_t>());
    }
  }
}

TEST_CASE("pictures are converted once, and what is rendered from their tiles has the same pixels") {
  const TemporaryFolder folder;
  write_text(folder.file("a.pbrt"), mapped_scene);
  write_noise(folder.file("noise.png"), 300, 200);
  write_noise(folder.file("holes.png"), 150, 100);
  const std::string name = quoted(folder.file("a.pbrt"));
  const auto pixels = [&](const std::string& options) {
    const std::string picture = folder.file("a.exr");
    const ProcessResult result =
        run_program(fmt::format("{} -r 40 30 -s 2 -q {} -o {}", name, options, quoted(picture)));
    CHECK(result.err.empty());
    return read_image(picture).pixels;
  };
  const auto before = pixels("");
  const ProcessResult first = run_program(name + " --convert-textures");
  CHECK(first.exit_code == 0);
  CHECK(first.err.empty());
  CHECK(first.out == fmt::format("{0}: 300 x 200 pixels, 9 levels\n{1}: 150 x 100 pixels, 8 levels\n"
                                 "{2}: 300 x 200 pixels, 9 levels\n",
                                 folder.file("noise.png.tx"), folder.file("holes.png.data.number.tx"),
                                 folder.file("noise.png.data.tx")));
  const ProcessResult second = run_program(name + " --convert-textures");
  CHECK(second.out.find("noise.png.tx: 300 x 200 pixels, 9 levels; it is there already\n") !=
        std::string::npos);
  CHECK(pixels("") == before);
  CHECK(pixels("--texture-memory=0.1") == before);
  const ProcessResult vain = run_program(name + " --convert-textures -q -o b.png --replay 1 1 0");
  CHECK(vain.exit_code == 0);
  for (const char* option : {"--output", "--replay"})
    CHECK(vain.err.find(fmt::format("warning: {}: no effect, for --convert-textures renders nothing\n",
                                    option)) != std::string::npos);
  CHECK(run_program(name + " --convert-textures --strict -s 4").exit_code == 2);
  std::filesystem::remove(folder.file("noise.png"));  // The tiles stand for it.
  CHECK(pixels("") == before);
  std::filesystem::remove(folder.file("holes.png.data.number.tx"));
  std::filesystem::remove(folder.file("holes.png"));
  const ProcessResult broken = run_program(name + " --convert-textures");
  CHECK(broken.exit_code == 1);
  CHECK(broken.err.find("holes.png: there is no such file") != std::string::npos);
}

TEST_CASE("what has no effect on the conversion of pictures is named") {
  const std::string reason = ": no effect, for --convert-textures renders nothing";
  for (const char* option :
       {"--output=a.png", "--stats=a.json", "--checkpoint=a.ck", "--denoise", "--samples=4", "--accel=bvh",
        "--metrics-file=a.prom", "--serve", "--exposure=1", "--texture-memory=9", "--texture-filter=nearest",
        "--threads=1", "--camera-name=top", "--instances=copy"}) {
    const std::string text = option, name = text.substr(0, text.find('='));
    CHECK(no_effect({"--convert-textures", option}) == name + reason);
  }
  CHECK(no_effect({"--convert-textures", "--layers=all", "-o", "a.exr"}) ==
        "--output" + reason + "\n--layers" + reason);
  CHECK(no_effect({"--convert-textures", "--replay", "1", "1", "0"}) == "--replay" + reason);
  CHECK(no_effect({"--convert-textures", "-q", "--memory=2000", "--time-limit=9"}).empty());
  CHECK(no_effect({"--convert-textures", "--camera-name=?"}).empty());
}

TEST_CASE("a wrong amount of memory for textures, and one without effect, are named") {
  const std::string bunny = TWINRAY_SOURCE_DIR "/scenes/cornell-bunny.dae";
  const ProcessResult wrong = run_program(bunny + " --texture-memory=many");
  CHECK(wrong.exit_code == 2);
  CHECK(wrong.err.find("--texture-memory: \"many\" is not a number from 0 to 1000000000") !=
        std::string::npos);
  const TemporaryFolder folder;
  const ProcessResult vain =
      run_program(bunny + " -r 4 4 -s 1 --texture-memory=1 -o " + quoted(folder.file("a.png")));
  CHECK(vain.err.find("--texture-memory: no effect, for the scene has no picture on its surfaces") !=
        std::string::npos);
}

}  // namespace twinray::test
