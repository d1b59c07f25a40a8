// SPDX-License-Identifier: Apache-2.0
// --denoise and --noise-target: words, errors, and the pictures that come out.
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>

#include "cli/relight/relight.h"
#include "cli/render_command_line.h"
#include "cli/resources.h"
#include "cli/statistics_report.h"
#include "io/picture/image_file.h"
#include "tests/support/arguments.h"
#include "tests/support/catch.h"
#include "tests/support/json.h"
#include "tests/support/own_scenes.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/text.h"

namespace twinray::test {
namespace {

const std::string small_render = fmt::format("render {} -r 24 18 -s 6 -q ", box_scene);
const std::string fake = std::string("TWINRAY_OIDN=") + TWINRAY_FAKE_DENOISER;

/// The mean square of the differences of red of two pictures.
double squared_difference(const Image& a, const Image& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const double difference = double(a.pixels[i].r) - b.pixels[i].r;
    sum += difference * difference;
  }
  return sum / double(a.pixels.size());
}

}  // namespace

TEST_CASE("a denoiser is auto, oidn or own, and needs the features of surfaces") {
  CHECK_FALSE(parse({}).denoiser);
  CHECK_FALSE(parse({}).render.half_layers);
  CHECK(parse({"--denoise"}).denoiser == DenoiserKind::automatic);
  CHECK(parse({"--denoise=auto"}).denoiser == DenoiserKind::automatic);
  CHECK(parse({"--denoise=oidn"}).denoiser == DenoiserKind::open_image_denoise);
  CHECK(parse({"--denoise=own"}).denoiser == DenoiserKind::own);
  CHECK(parse({"--denoise", "--noise-target=0.1"}).render.half_layers ==
        std::vector{Layer::albedo, Layer::normal});
  CHECK(message_of({"--denoise=optix"}) == "--denoise: there is no \"optix\"; valid are auto, oidn, own");
  CHECK(message_of({"--denoise", "--integrator=normals"}) ==
        "--denoise: --integrator=normals knows no features of surfaces; path, path-reference and direct do");
}

TEST_CASE("noise decides how many samples there are, and a number of samples is the most") {
  CHECK(parse({"--noise-target=0.1"}).render.noise_target == 0.1);
  CHECK(parse({"--noise-target=0.1"}).render.samples == Film::max_samples);
  CHECK(parse({"--noise-target=0.1"}).render.half_layers == std::vector<Layer>{});
  CHECK(parse({"--noise-target=0.1", "-s", "700"}).render.samples == 700);
  CHECK(parse({"--noise-target=0.1", "-s", "17"}).without_effect.empty());
  CHECK(parse({"--noise-target=0.1", "-s", "16"}).without_effect.front() ==
        "--noise-target: no effect, for it ends a render after 16 samples or more, and 16 are asked for");
  CHECK(message_of({"--noise-target=0"}) == "--noise-target: \"0\" is not a number from 1e-06 to 1000");
}

TEST_CASE("the halves of the samples are counted among what a render needs of memory") {
  RenderOptions options{.width = 20, .height = 40};
  options.half_layers = std::vector{Layer::albedo, Layer::normal};
  CHECK(memory_needs(options)[0].bytes == (64 + 2 * (64 + 48)) * 20 * 40);
}

TEST_CASE("where a picture is one sample, there is nothing to denoise it by") {
  const TemporaryFolder folder;
  const ProcessResult result =
      run_program("render " + box_scene + " -s 1 --denoise=own -q -o " + folder.file("a.png"));
  CHECK(result.exit_code == 1);
  CHECK(result.err ==
        "twinray: --denoise: a single sample per pixel says nothing of the noise; -s takes 2 or more\n");
  CHECK(folder.file_count() == 0);
}

TEST_CASE("a denoiser that cannot be loaded is an error before the render") {
  const TemporaryFolder folder;
  const std::string denoised = small_render + "--denoise -o " + folder.file("a.png");
  const ProcessResult result = run_program(denoised, "TWINRAY_OIDN=/nowhere/library.so");
  CHECK(result.exit_code == 1);
  CHECK(result.err.starts_with("twinray: TWINRAY_OIDN: /nowhere/library.so: cannot open shared object file"));
  CHECK(folder.file_count() == 0);
}

TEST_CASE("an EXR picture has denoised colours, and the noisy ones as layers") {
  const TemporaryFolder folder;
  const std::string plain = folder.file("plain.exr"), denoised = folder.file("denoised.exr");
  REQUIRE(run_program(small_render + "--layers=albedo,normal -o " + plain).exit_code == 0);
  REQUIRE(run_program(small_render + "--layers=depth --denoise -o " + denoised, fake).exit_code == 0);
  const Image before = read_image(plain), after = read_image(denoised);
  const std::vector<float> noisy = read_channel(denoised, "noisy.R"),
                           albedo = read_channel(plain, "albedo.R"), normal = read_channel(plain, "N.X");
  REQUIRE(noisy.size() == before.pixels.size());
  constexpr double half_rounding = 0.1;  // 220 times that of layers of 16 bits
  for (std::size_t i = 0; i < noisy.size(); ++i) {
    CHECK(noisy[i] == before.pixels[i].r);
    const double expected = std::max(0.0, double(noisy[i]) + 10 * 2 * albedo[i] + 100 * 2 * normal[i]);
    CHECK(std::fabs(double(after.pixels[i].r) - expected) < half_rounding);
  }
  CHECK_FALSE(read_channel(denoised, "Z").empty());
  CHECK(read_channel(denoised, "albedo.R").empty());  // It was not asked for.
  CHECK(contains(read_text(denoised), "Open Image Denoise 2.4.3"));
}

TEST_CASE("a PNG picture is denoised, and the noisy one stands beside it") {
  const TemporaryFolder folder;
  REQUIRE(run_program(small_render + "-o " + folder.file("plain.png")).exit_code == 0);
  REQUIRE(run_program(small_render + "--denoise=own -o " + folder.file("a.png")).exit_code == 0);
  CHECK(read_image(folder.file("a_noisy.png")).pixels == read_image(folder.file("plain.png")).pixels);
  CHECK(read_image(folder.file("a.png")).pixels != read_image(folder.file("plain.png")).pixels);
  CHECK(contains(read_text(folder.file("a.png")), "own filter"));
  const ProcessResult piped = run_program(small_render + "--denoise=own -o - > " + folder.file("b.png"));
  CHECK(piped.err == "warning: - is no file: the picture that would stand beside it is not written\n");
}

TEST_CASE("our own filter brings a picture nearer to the converged one, in the same bits by any threads") {
  const TemporaryFolder folder;
  const std::string render = fmt::format("render {} -r 48 36 -q ", box_scene);
  REQUIRE(run_program(render + "-s 1024 --seed 5 -o " + folder.file("converged.exr")).exit_code == 0);
  for (const int threads : {1, 3})
    REQUIRE(run_program(render + fmt::format("-s 16 --denoise=own -t {0} -o {1} --stats {1}.json", threads,
                                             folder.file(fmt::format("{}.exr", threads))))
                .exit_code == 0);
  const Image converged = read_image(folder.file("converged.exr")),
              denoised = read_image(folder.file("1.exr"));
  CHECK(denoised.pixels == read_image(folder.file("3.exr")).pixels);
  const std::vector<float> noisy = read_channel(folder.file("1.exr"), "noisy.R");
  Image before = denoised;
  for (std::size_t i = 0; i < noisy.size(); ++i) before.pixels[i].r = noisy[i];
  CHECK(squared_difference(denoised, converged) < 0.8 * squared_difference(before, converged));
  CHECK(contains(read_text(folder.file("1.exr.json")), "own filter\",\n    \"seconds\""));
}

TEST_CASE(
    "light groups are denoised, and are together the picture, as the noisy ones are the noisy picture") {
  const TemporaryFolder folder;
  const std::string lights = fmt::format("render {}/scenes/lights.dae -r 24 18 -s 8 -q ", TWINRAY_SOURCE_DIR);
  const std::string picture = folder.file("a.exr"), again = folder.file("b.exr");
  REQUIRE(run_program(lights + "--layers=light-groups --denoise=own --denoise-light-groups -o " + picture)
              .exit_code == 0);
  const StoredLayers layers = read_layers(picture);
  const std::vector<std::string> groups = light_groups_of(layers);
  REQUIRE(groups.size() > 1);
  const std::vector<float> whole = read_channel(picture, "G"), noisy = read_channel(picture, "noisy.G");
  std::vector<float> sum(whole.size()), noisy_sum(whole.size());
  for (const std::string& group : groups) {
    const std::vector<float> part = read_channel(picture, "light_" + group + ".G"),
                             noisy_part = read_channel(picture, "noisy_light_" + group + ".G");
    CHECK(part != noisy_part);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += part[i], noisy_sum[i] += noisy_part[i];
  }
  CHECK(sum == whole);
  CHECK(noisy_sum == noisy);
  REQUIRE(run_program(fmt::format("relight {} -o {}", picture, again)).exit_code == 0);
  CHECK(read_image(again).pixels == read_image(picture).pixels);
  CHECK(read_channel(again, "noisy_light_" + groups[0] + ".G").empty());
}

TEST_CASE("a crop and adaptive sampling are denoised, too") {
  const TemporaryFolder folder;
  const std::string render =
      fmt::format("render {} -r 48 36 -p 8 4 20 30 -s 48 -a 8 0.1 -q --denoise=own ", box_scene);
  REQUIRE(run_program(render + "-o " + folder.file("a.exr")).exit_code == 0);
  CHECK(read_image(folder.file("a.exr")).width == 20);
  CHECK(read_channel(folder.file("a.exr"), "noisy.G").size() == 600);
}

TEST_CASE("a render that ends by its noise says after how many samples, and which error is left") {
  const TemporaryFolder folder;
  const std::string render = fmt::format("render {} -r 24 18 --noise-target=0.2 -o {} --stats {}", box_scene,
                                         folder.file("a.exr"), folder.file("a.json"));
  const ProcessResult result = run_program(render);
  REQUIRE(result.exit_code == 0);
  CHECK(contains(result.out, " s, 16 samples per pixel, relative error 0."));
  CHECK(contains(read_text(folder.file("a.json")), "\"samples_per_pixel\": 16"));
  CHECK(contains(read_text(folder.file("a.json")), "\"estimated_error\": 0."));
  CHECK(contains(read_text(folder.file("a.exr")), "twinray:samples"));
}

TEST_CASE("with a denoiser a noise target is that of the denoised picture, which needs fewer samples") {
  const TemporaryFolder folder;
  const auto samples = [&](const std::string& options) {
    REQUIRE(run_program(fmt::format("render {} -r 48 36 --noise-target=0.04 -q {} -o {} --stats {}",
                                    box_scene, options, folder.file("a.exr"), folder.file("a.json")))
                .exit_code == 0);
    return nlohmann::json::parse(read_text(folder.file("a.json")))["samples_per_pixel"].get<int>();
  };
  CHECK(samples("--denoise=own") < samples(""));
}

TEST_CASE("Open Image Denoise is judged by what it makes of the halves") {
  // What the library of the tests adds to both halves is bias: 20 albedo + 200 normal, clean features
  // doubled.
  const TemporaryFolder folder;
  REQUIRE(
      run_program(
          small_render +
              fmt::format("-s 64 --layers=albedo,normal --noise-target=1e-6 --denoise=oidn -o {} --stats {}",
                          folder.file("a.exr"), folder.file("a.json")),
          fake)
          .exit_code == 0);
  const auto json = nlohmann::json::parse(read_text(folder.file("a.json")));
  const std::string text = json.dump();
  const std::size_t at = text.find("\"estimated_error\":");
  REQUIRE(at != text.npos);
  const double estimated = std::stod(text.substr(at + 18));
  const Image denoised = read_image(folder.file("a.exr"));
  double sum = 0;
  for (const char channel : {'R', 'G', 'B'}) {
    const std::vector<float> noisy = read_channel(folder.file("a.exr"), fmt::format("noisy.{}", channel)),
                             after = read_channel(folder.file("a.exr"), std::string(1, channel));
    for (std::size_t i = 0; i < noisy.size(); ++i)
      sum += std::pow(double(after[i]) - noisy[i], 2) / (double(after[i]) * after[i] + 0.01);
  }
  const double is = std::sqrt(sum / (3.0 * double(denoised.pixels.size())));
  CHECK(estimated == Approx(is).epsilon(0.05));
}

TEST_CASE("Open Image Denoise denoises each light group with the same clean features") {
  const TemporaryFolder folder;
  const std::string picture = folder.file("a.exr");
  REQUIRE(run_program(
              fmt::format("render {}/scenes/lights.dae -r 24 18 -s 8 -q --layers=light-groups,albedo,normal "
                          "--denoise=oidn --denoise-light-groups -o {}",
                          TWINRAY_SOURCE_DIR, picture),
              fake)
              .exit_code == 0);
  const std::vector<float> albedo = read_channel(picture, "albedo.R"), normal = read_channel(picture, "N.X");
  constexpr double rounding = 0.1;  // 220 times that of layers of 16 bits
  for (const std::string& group : light_groups_of(read_layers(picture))) {
    CAPTURE(group);
    const std::vector<float> noisy = read_channel(picture, "noisy_light_" + group + ".R"),
                             after = read_channel(picture, "light_" + group + ".R");
    double most = 0;
    for (std::size_t i = 0; i < noisy.size(); ++i)
      most = std::max(most,
                      std::fabs(after[i] - std::max(0.0, noisy[i] + 20.0 * albedo[i] + 200.0 * normal[i])));
    CHECK(most < rounding);
  }
}

TEST_CASE("an interruption while it is denoised keeps the picture as it is, and a checkpoint to denoise") {
  const TemporaryFolder folder;
  const std::string render = small_render + "--denoise=oidn -o " + folder.file("a.exr");
  const auto interrupted = [&](const std::string& more, const char* mode) {
    return run_program(render + more, fake + " FAKE_DENOISER=" + mode);
  };
  const std::string kept = folder.file("a_partial.exr") + " holds what there is: 6 of 6 samples a pixel\n";
  const ProcessResult alone = interrupted("", "interrupt");
  CHECK(alone.exit_code == 130);
  CHECK(alone.err == "twinray: interrupted while it was denoised; " + kept);
  CHECK(folder.file_count() == 1);
  REQUIRE(run_program(small_render + "-o " + folder.file("plain.exr")).exit_code == 0);
  CHECK(read_image(folder.file("a_partial.exr")).pixels == read_image(folder.file("plain.exr")).pixels);
  const std::string checkpoint = folder.file("a.ck");
  const ProcessResult saved = interrupted(" --checkpoint=" + checkpoint, "interrupt");
  CHECK(saved.exit_code == 75);
  CHECK(contains(saved.err, kept + "twinray: `twinray resume " + checkpoint + "` goes on with it\n"));
  CHECK(interrupted(" --checkpoint=" + checkpoint, "interrupt-twice").exit_code == 75);
  CHECK_FALSE(std::filesystem::exists(folder.file("a.exr")));
  REQUIRE(run_program("resume " + checkpoint + " -q", fake).exit_code == 0);
  REQUIRE(run_program(small_render + "--denoise=oidn -o " + folder.file("whole.exr"), fake).exit_code == 0);
  CHECK(read_layers(folder.file("a.exr")).values == read_layers(folder.file("whole.exr")).values);
}

TEST_CASE("light groups are denoised where they are kept, and something denoises") {
  const Words both{"--layers=light-groups", "-o", "a.exr", "--denoise-light-groups", "--denoise=own"};
  CHECK(parse(both).render.half_light_groups);
  CHECK(parse(both).without_effect.empty());
  CHECK(parse({"--denoise-light-groups", "--denoise=own"}).without_effect.front() ==
        "--denoise-light-groups: no effect, for --layers does not name light-groups");
  CHECK(parse({"--denoise-light-groups", "--layers=light-groups"}).without_effect.front() ==
        "--denoise-light-groups: no effect, for nothing is denoised; --denoise does it");
  CHECK(parse({"--replay", "1", "2", "3", "--denoise-light-groups"}).without_effect.front() ==
        "--denoise-light-groups: no effect, for --replay renders no picture");
}

TEST_CASE("a replay is no picture that could be denoised") {
  const RenderArguments replay = parse({"--replay", "1", "2", "3", "--denoise", "--noise-target=1"});
  CHECK(replay.without_effect ==
        std::vector<std::string>{"--noise-target: no effect, for --replay renders no picture",
                                 "--denoise: no effect, for --replay renders no picture"});
}

}  // namespace twinray::test
