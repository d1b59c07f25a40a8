// SPDX-License-Identifier: Apache-2.0
// How far a render is, told to machines; and when it is to end.
#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <regex>
#include <sstream>
#include <thread>

#include "cli/clock_time.h"
#include "cli/render_command_line.h"
#include "cli/status/metrics_file.h"
#include "core/error.h"
#include "tests/support/catch.h"
#include "tests/support/json.h"
#include "tests/support/own_scenes.h"
#include "tests/support/process.h"
#include "tests/support/sanitizer.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/terminal.h"

namespace twinray::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::vector<json> objects_of(const std::string& text) {
  std::vector<json> objects;
  for (const std::string& line : lines_of(text))
    if (line.starts_with("{")) objects.push_back(json::parse(line));
  return objects;
}

/// Of a metrics file; nothing where there is no such metric.
std::optional<double> metric(const std::string& text, const std::string& name, const std::string& more = "") {
  for (const std::string& line : lines_of(text))
    if (line.starts_with("twinray_" + name + "{") && line.find(more) != std::string::npos)
      return std::strtod(line.substr(line.rfind(' ')).c_str(), nullptr);
  return std::nullopt;
}

WallTime utc(int year, int month, int day, int hour, int minute) {
  using namespace std::chrono;
  return sys_days(std::chrono::year(year) / month / day) + hours(hour) + minutes(minute);
}

/// The machine's time zone, for a moment.
class TimeZone {
 public:
  explicit TimeZone(const char* name) {
    setenv("TZ", name, 1);
    tzset();
  }
  ~TimeZone() {
    unsetenv("TZ");
    tzset();
  }
};

}  // namespace

TEST_CASE("times are of the machine's zone, or of UTC, or the next such time of day") {
  const TimeZone berlin("CET-1CEST,M3.5.0,M10.5.0/3");
  const WallTime noon = utc(2026, 11, 23, 11, 0);  // 12:00 there
  CHECK(parse_clock_time("2026-11-24T07:30", noon) == utc(2026, 11, 24, 6, 30));
  CHECK(parse_clock_time("2026-07-24 07:30:30", noon) == utc(2026, 7, 24, 5, 30) + std::chrono::seconds(30));
  CHECK(parse_clock_time("2026-11-24T07:30Z", noon) == utc(2026, 11, 24, 7, 30));
  CHECK(parse_clock_time("12:01", noon) == utc(2026, 11, 23, 11, 1));
  CHECK(parse_clock_time("12:00", noon) == utc(2026, 11, 24, 11, 0));
  CHECK(parse_clock_time("00:00:00", utc(2026, 12, 31, 20, 0)) == utc(2026, 12, 31, 23, 0));
  CHECK(parse_clock_time("2028-02-29T00:00", noon) == utc(2028, 2, 28, 23, 0));
  CHECK(clock_text(utc(2026, 11, 24, 6, 30)) == "2026-11-24 07:30:00");
}

TEST_CASE("what is no time is refused, with what would be one") {
  for (const std::string text :
       {"", "7:30", "24:00", "12:60", "noon", "2026-11-24", "2026-02-29T00:00", "2026-13-01T00:00",
        "2026-11-24T07:30z", "2026-11-24T07:30:00ZZ", "2026-11-24T", "12:00Z", "1969-12-31T00:00"})
    CHECK_THROWS_WITH(parse_clock_time(text),
                      fmt::format("\"{}\" is no time; valid are 07:30, 2026-11-24T07:30, "
                                  "2026-11-24T07:30:00Z",
                                  text));
  CHECK(run_program("render box.dae --until=noon").err.find("--until: \"noon\" is no time; valid are") !=
        std::string::npos);
}

TEST_CASE("a time to end by is one that a render has at most, beside its seconds") {
  const auto until = [](int seconds, std::vector<std::string> more = {}) {
    const WallTime end = std::chrono::system_clock::now() + std::chrono::seconds(seconds);
    std::vector<std::string> words{box_scene, "--until", clock_text(end)};
    words.insert(words.end(), more.begin(), more.end());
    return parse_render_arguments(words);
  };
  const RenderArguments hour = until(3600);
  CHECK(hour.render.samples == Film::max_samples);
  CHECK(*hour.render.seconds > 3500);
  CHECK(*hour.render.seconds <= 3600);
  CHECK(*until(3600, {"--seconds=20"}).render.seconds == 20);
  CHECK(*until(10, {"--seconds=2000"}).render.seconds <= 10);
  RenderArguments soon = until(3600);
  *soon.until -= std::chrono::seconds(1800);
  heed_the_clock(soon);
  CHECK(*soon.render.seconds <= 1800);
  CHECK(until(-5).render.seconds == 1e-3);
  // Clocks of 64 bits end in 2262.
  for (const char* far : {"2262-04-12T12:00", "2300-01-01T00:00Z", "9999-12-31T23:59"})
    CHECK(*parse_render_arguments({box_scene, "--until", far}).render.seconds > 1e8);
  CHECK(until(3600, {"-s", "7"}).render.samples == 7);
}

TEST_CASE("a render whose time is over makes the least picture, and says so") {
  const TemporaryFolder folder;
  const ProcessResult late = run_program(fmt::format("render {} -r 8 6 --until=2026-01-02T03:04 -o {}",
                                                     box_scene, quoted(folder.file("a.png"))));
  CHECK(late.exit_code == 0);
  CHECK(late.err.find("--until: 2026-01-02 03:04:00 is over: as few samples are rendered as can be") !=
        std::string::npos);
  CHECK(read_text(folder.file("a.png")).size() > 50);
}

TEST_CASE("progress in JSON is a line for each step, and all numbers are those of the render") {
  const TemporaryFolder folder;
  const ProcessResult result = run_program(fmt::format("render {} -r 16 12 -s 4 -q --progress=json -o {}",
                                                       box_scene, quoted(folder.file("a.png"))));
  REQUIRE(result.exit_code == 0);
  CHECK(result.out.empty());
  const std::vector<json> objects = objects_of(result.err);
  REQUIRE(objects.size() == lines_of(result.err).size());
  std::vector<std::string> steps;
  for (const json& object : objects) steps.push_back(object["step"]);
  CHECK(steps == std::vector<std::string>{"loading", "building", "rendering", "saving", "done"});
  CHECK(objects.front()["scene"] == box_scene);
  CHECK(objects.front()["output"] == folder.file("a.png"));
  CHECK(objects.front()["samples_done"].is_null());
  const json& last = objects.back();
  CHECK(last["progress_ratio"] == 1);
  CHECK(last["samples_done"] == 16 * 12 * 4);
  CHECK(last["samples_wanted"] == 16 * 12 * 4);
  CHECK(last["rays_done"] > 16 * 12 * 4);
  CHECK(last["left_seconds"].is_null());
  CHECK(last["error_ratio"].is_null());
  CHECK(last["peak_memory_bytes"] > 1000000);
}

TEST_CASE("a render that goes on with all of its samples tells machines that they are there") {
  const TemporaryFolder folder;
  const std::string film = quoted(folder.file("a.ck"));
  REQUIRE(run_program(fmt::format("render {} -r 16 12 -s 4 -q --checkpoint={} -o {}", box_scene, film,
                                  quoted(folder.file("a.png"))))
              .exit_code == 0);
  const ProcessResult result = run_program(fmt::format("resume {} --progress=json", film));
  REQUIRE(result.exit_code == 0);
  const json last = objects_of(result.err).back();
  CHECK(last["step"] == "done");
  CHECK(last["progress_ratio"] == 1);
  CHECK(last["samples_done"] == 16 * 12 * 4);
  CHECK(last["samples_wanted"] == 16 * 12 * 4);
}

TEST_CASE("a line for machines says that a render is done which ended before its time") {
  RenderStatus status{.progress = RenderProgress{.samples_done = 2, .samples_total = 8}};
  const auto share = [&](RenderStatus::Step step) {
    status.step = step;
    return *status_numbers(status).front().value;
  };
  CHECK(share(RenderStatus::Step::rendering) == 0.25);
  CHECK(share(RenderStatus::Step::interrupted) == 0.25);
  CHECK(share(RenderStatus::Step::saving) == 1);
  CHECK(share(RenderStatus::Step::done) == 1);
}

TEST_CASE("a line of progress comes each second, and the last says that it was interrupted") {
  const TemporaryFolder folder;
  TerminalProgram program({box_scene, "-r", "48", "36", "-s", "4000000", "-t", "1", "--progress=json", "-o",
                           folder.file("a.png")});
  REQUIRE(program.wait_for("\"elapsed_seconds\":1."));
  REQUIRE(program.wait_for("\"elapsed_seconds\":2."));
  program.press_control_c();
  CHECK(program.exit_code() == 130);
  CHECK(program.shown().find("\"step\":\"interrupted\"") != std::string::npos);
  CHECK(program.shown().find(" samples |") == std::string::npos);
}

TEST_CASE("a metrics file follows a render while it goes on") {
  const TemporaryFolder folder;
  const std::string metrics = folder.file("a.prom");
  TerminalProgram program({box_scene, "-r", "48", "36", "-s", "4000000", "-t", "1", "-o",
                           folder.file("a.png"), "--metrics-file=" + metrics});
  const auto samples = [&] { return metric(read_text(metrics), "samples_done"); };
  for (int i = 0; i < 600 && !samples(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(100));
  CHECK(samples() > 0);
  CHECK(metric(read_text(metrics), "step", "step=\"rendering\"") == 1);
  program.press_control_c();
  CHECK(program.exit_code() == 130);
}

TEST_CASE("an interrupted render tells machines of its last checkpoint") {
  const TemporaryFolder folder;
  TerminalProgram program({box_scene, "-r", "48", "36", "-s", "4000000", "-t", "1", "-o",
                           folder.file("a.png"), "--checkpoint=" + folder.file("a.ck"),
                           "--metrics-file=" + folder.file("a.prom")});
  REQUIRE(program.wait_for(" samples |"));
  program.press_control_c();
  CHECK(program.exit_code() == 75);
  const std::string text = read_text(folder.file("a.prom"));
  CHECK(metric(text, "step", "step=\"interrupted\"") == 1);
  CHECK(metric(text, "checkpoint_time_seconds") > 1.7e9);
}

TEST_CASE("a render that fails says so to machines") {
  const TemporaryFolder folder;
  const std::string scene = folder.file("broken.dae"), metrics = folder.file("a.prom");
  write_text(scene, "<COLLADA>");
  const ProcessResult result =
      run_program(fmt::format("render {} --progress=json --metrics-file={} -o {}", quoted(scene),
                              quoted(metrics), quoted(folder.file("a.png"))));
  CHECK(result.exit_code == 1);
  CHECK(objects_of(result.err).back()["step"] == "failed");
  CHECK(metric(read_text(metrics), "step", "step=\"failed\"") == 1);
  CHECK(metric(read_text(metrics), "step", "step=\"done\"") == 0);
}

TEST_CASE("a render that is refused before it begins says to machines that it failed") {
  const TemporaryFolder folder;
  const std::string metrics = folder.file("a.prom"), picture = quoted(folder.file("a.png"));
  const auto refused = [&](const std::string& words) {
    const ProcessResult result = run_program(
        fmt::format("render {} -q --progress=json --metrics-file={} {}", box_scene, quoted(metrics), words));
    CHECK(result.exit_code == 1);
    const std::vector<json> objects = objects_of(result.err);
    REQUIRE(objects.size() == 1);
    CHECK(objects[0]["step"] == "failed");
    CHECK(objects[0]["scene"] == box_scene);
  };
  const std::string nowhere = "-r 4 3 -o " + quoted(folder.file("none/a.png"));
  // A sanitizer's own memory is more.
  const std::string too_large = has_sanitizer ? nowhere : "-r 20000 20000 --memory=200 -o " + picture;
  for (const std::string& words : {too_large, nowhere}) {
    CAPTURE(words);
    fs::remove(metrics);
    for (int time = 0; time < 2; ++time) {
      refused(words);
      CHECK(metric(read_text(metrics), "step", "step=\"failed\"") == 1);
    }
  }
  // What is no file of metrics stays.
  write_text(metrics, "mine");
  refused(too_large);
  CHECK(read_text(metrics) == "mine");
  CHECK(folder.file_count() == 1);
}

TEST_CASE("a metrics file writes over no part of the scene, also before the scene is read") {
  const TemporaryFolder folder;
  for (const char* name : {"blocks.obj", "blocks.mtl"})
    fs::copy_file(fs::path(TWINRAY_SOURCE_DIR "/scenes") / name, folder.file(name));
  const std::string part = folder.file("blocks.mtl"), before = read_text(part);
  const std::string render =
      fmt::format("render {} -r 8 6 -s 1 -q -o {} --metrics-file=", quoted(folder.file("blocks.obj")),
                  quoted(folder.file("a.png")));
  const std::string refusal = fmt::format("twinray: {}: this file is read; choose another name\n", part);
  const ProcessResult refused = run_program(render + quoted(part));
  CHECK(refused.exit_code == 1);
  CHECK(refused.err == refusal);
  CHECK(read_text(part) == before);
  const std::string film = folder.file("a.ck");
  REQUIRE(run_program(render + quoted(folder.file("a.prom")) + " --checkpoint=" + quoted(film)).exit_code ==
          0);
  const ProcessResult resumed =
      run_program(fmt::format("resume {} --metrics-file={}", quoted(film), quoted(part)));
  CHECK(resumed.exit_code == 1);
  CHECK(resumed.err == refusal);
  CHECK(read_text(part) == before);
  // What is no part of it is replaced, once that is known.
  const std::string other = folder.file("other.prom");
  write_text(other, "mine");
  CHECK(run_program(render + quoted(other)).exit_code == 0);
  CHECK(metric(read_text(other), "step", "step=\"done\"") == 1);
}

TEST_CASE("a metrics file has the numbers of the render at its end, in Prometheus's words") {
  const TemporaryFolder folder;
  const std::string metrics = folder.file("a.prom");
  const ProcessResult result =
      run_program(fmt::format("render {} -r 16 12 -s 4 -q --metrics-file={} -o {} --checkpoint={}", box_scene,
                              quoted(metrics), quoted(folder.file("a.png")), quoted(folder.file("a.ck"))));
  REQUIRE(result.exit_code == 0);
  const std::string text = read_text(metrics);
  CHECK(metric(text, "step", "step=\"done\"") == 1);
  CHECK(metric(text, "progress_ratio") == 1);
  CHECK(metric(text, "samples_done") == 16 * 12 * 4);
  CHECK(metric(text, "elapsed_seconds") > 0);
  CHECK_FALSE(metric(text, "noise_target_ratio"));
  CHECK(metric(text, "checkpoint_time_seconds") <= metric(text, "update_time_seconds"));
  CHECK(metric(text, "checkpoint_time_seconds") > 1.7e9);
  const std::regex sample(R"re([a-z_]+\{scene="[^"]*",output="[^"]*"(,step="[a-z]+")?\} [0-9.e+-]+)re");
  const std::regex comment(R"re(# (HELP|TYPE) twinray_[a-z_]+ .+)re");
  for (const std::string& line : lines_of(text)) {
    CAPTURE(line);
    CHECK((std::regex_match(line, sample) || std::regex_match(line, comment)));
  }
  CHECK(folder.file_count() == 3);
}

TEST_CASE("names in metrics keep their signs, and lose bytes that are no letters") {
  const std::string text = metrics_text({}, "a\"b\\c\nd", "e\xff.png");
  CHECK(text.find("{scene=\"a\\\"b\\\\c\\nd\",output=\"e\xEF\xBF\xBD.png\"}") != std::string::npos);
}

TEST_CASE("metrics go to a file that can be replaced, and to no other output's place") {
  const TemporaryFolder folder;
  const auto error_of = [&](const std::string& words) {
    const ProcessResult result = run_program(fmt::format("render {} -r 4 3 -s 1 {}", box_scene, words));
    CHECK(result.exit_code == 1);
    return result.err;
  };
  CHECK(error_of("-o - --metrics-file=/dev/null").find("metrics are a file that can be replaced") !=
        std::string::npos);
  const std::string same = quoted(folder.file("a.png"));
  CHECK(error_of("-o " + same + " --metrics-file=" + same).find("a.png") != std::string::npos);
  const std::string picture = "-q -o " + same, film = folder.file("a.ck");
  CHECK(error_of(fmt::format("{0} --checkpoint={1} --metrics-file={1}.before", picture, quoted(film)))
            .find("choose another name") != std::string::npos);
  CHECK(error_of(picture + " -a 2 0.1 --metrics-file=" + quoted(folder.file("a_rate.png")))
            .find("a_rate.png") != std::string::npos);
  const std::string nowhere = folder.file("none/a.prom");
  const std::string told = error_of(picture + " --metrics-file=" + quoted(nowhere));
  CHECK(told.find(nowhere) != std::string::npos);
  CHECK(told.find(nowhere) == told.rfind(nowhere));
  CHECK(told.find("no metrics") == std::string::npos);
  const ProcessResult standard =
      run_program("render " + box_scene + " -r 4 3 -s 1 --metrics-file=- " + picture);
  CHECK(standard.exit_code == 1);
  CHECK(standard.out.empty());
  CHECK(folder.file_count() == 0);
}

}  // namespace twinray::test
