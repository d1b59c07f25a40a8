// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "cli/crosscheck/arguments.h"
#include "cli/crosscheck/ray_text.h"
#include "cli/crosscheck/report.h"
#include "core/error.h"
#include "tests/support/catch.h"
#include "tests/support/json.h"
#include "tests/support/own_scenes.h"
#include "tests/support/process.h"

namespace twinray::test {
namespace {

/// A report with one unexplained ray among a thousand.
SceneCrosscheck with_one_unexplained() {
  SceneCrosscheck result{{"bvh", "embree"}, CrosscheckReport(2), 1.5};
  for (int i = 0; i < 999; ++i) result.report.add_explained(1, RayClass::moved, Difference::identical);
  const Ray ray{.origin = {1, -0.0f, 0.1f}, .direction = {0, 0, -1}, .t_max = 2};
  const Answer hit{{.t = 1.5f, .u = 0.25f, .v = 0.5f, .primitive = 7, .mesh = 3}, true};
  result.report.add({.ray_class = RayClass::moved, .number = 42, .engine = 1, .ray = ray, .reference = hit},
                    true);
  return result;
}

}  // namespace

TEST_CASE("a ray's text keeps every bit") {
  const Ray ray{.origin = {-0.0f, 0x1p-149f, 0x1.fffffep59f},
                .direction = {0.1f, -1 / 3.0f, 0},
                .t_min = 0x1.8p-100f,
                .t_max = INFINITY};
  const Ray read = parse_ray(ray_text(ray));
  CHECK(read.origin == ray.origin);
  CHECK(std::signbit(read.origin.x));
  CHECK(read.direction == ray.direction);
  CHECK(read.t_min == ray.t_min);
  CHECK(read.t_max == ray.t_max);
  CHECK(parse_ray("1,2.5,-3e2,0,0,1,0,inf").origin == Vec3{1, 2.5f, -300});
}

TEST_CASE("a text that is no ray is refused") {
  for (const char* text : {"", "1,2,3", "1,2,3,4,5,6,7", "1,2,3,4,5,6,7,8,9", "1,2,3,4,5,6,7,",
                           "a,2,3,4,5,6,7,8", "1,2,3,4,5,6,7,8x", "--1,2,3,4,5,6,7,8", "0x,2,3,4,5,6,7,8"})
    CHECK_THROWS_AS(parse_ray(text), UsageError);
}

TEST_CASE("a ray outside of the domain is refused with what is wrong with it") {
  const auto message_of = [](const char* text) -> std::string {
    try {
      parse_ray(text);
    } catch (const UsageError& error) {
      return error.what();
    }
    return "accepted";
  };
  CHECK(message_of("0,0,nan,0,0,1,0,inf") == "--ray: the origin must be finite, with components up to 2^60");
  CHECK(message_of("0,0,-inf,0,0,1,0,inf") == "--ray: the origin must be finite, with components up to 2^60");
  CHECK(message_of("0,0x1.1p60,0,0,0,1,0,inf") ==
        "--ray: the origin must be finite, with components up to 2^60");
  CHECK(message_of("0,0,0,-0.0,0,0,0,inf") == "--ray: the direction must be finite and not zero");
  CHECK(message_of("0,0,0,inf,0,0,0,inf") == "--ray: the direction must be finite and not zero");
  const std::string interval = "--ray: the interval must have 0 <= t_min <= t_max";
  for (const char* text : {"0,0,0,0,0,1,2,1", "0,0,0,0,0,1,-1,1", "0,0,0,0,0,1,nan,1", "0,0,0,0,0,1,0,nan"})
    CHECK(message_of(text) == interval);
  CHECK(message_of("0x1p60,0,0,0,0,1,1,1") == "accepted");
}

TEST_CASE("an unexplained ray is printed as the command that shoots it again") {
  const SceneCrosscheck result = with_one_unexplained();
  CHECK_FALSE(is_passed(result.report, Ceilings::remark));
  const std::string text = crosscheck_text(result, replay_command("a b.dae", {}), Ceilings::remark);
  CHECK(text.find("embree, moved 42, unexplained: bvh sees t 0x1.8p+0 u 0x1p-2 v 0x1p-1 of 3:7; embree sees "
                  "nothing\n  twinray crosscheck 'a b.dae' --placement=moved "
                  "--ray=0x1p+0,-0x0p+0,0x1.99999ap-4,0x0p+0,0x0p+0,-0x1p+0,0x0p+0,0x1p+1\n") !=
        std::string::npos);
  CHECK(text.ends_with("1 unexplained; 1.5 s\n"));
  const auto json = nlohmann::json::parse(crosscheck_json(
      result, "a b.dae", replay_command("a b.dae", {.keep_both_lamps = true}), Ceilings::remark));
  CHECK(json["passed"] == false);
  CHECK(json["unexplained"] == 1);
  CHECK(json["engines"]["embree"]["moved"]["rays"] == 1000);
  CHECK(json["findings"][0]["number"] == 42);
  CHECK(std::string(json["findings"][0]["command"])
            .find("twinray crosscheck 'a b.dae' --keep-both-lamps --placement=moved --ray=0x1p+0,") == 0);
  CHECK(replay_command("a.pbrt", {.instances = InstanceUse::keep}) ==
        "twinray crosscheck a.pbrt --instances=keep");
  CHECK(replay_command("a.dae", {}, {"bvh", "embree-native-fast"}) ==
        "twinray crosscheck a.dae --engines=bvh,embree-native-fast");
  CHECK(replay_command("it's.dae", {}) == "twinray crosscheck 'it'\\''s.dae'");
  CHECK(primitive_text(3, 7, no_instance) == "3:7");
  CHECK(primitive_text(3, 7, 0) == "3:7 of instance 0");
}

TEST_CASE("a leak that is explained is a remark, and an error where ceilings count") {
  SceneCrosscheck result{{"bvh", "embree-native"}, CrosscheckReport(2), 1.5};
  const Finding leak{
      .ray_class = RayClass::edges, .engine = 1, .difference = Difference::edge, .is_leak = true};
  result.report.add(leak, true);
  CHECK(is_passed(result.report, Ceilings::remark));
  CHECK_FALSE(is_passed(result.report, Ceilings::count));
  const std::string said = "embree-native: 1 edges rays leak; none may\n";
  const std::string remark = crosscheck_text(result, "replay", Ceilings::remark);
  CHECK(remark.ends_with("remark: " + said + "nothing unexplained; 1.5 s\n"));
  CHECK(remark.find("--ray=") == std::string::npos);
  const std::string error = crosscheck_text(result, "replay", Ceilings::count);
  CHECK(error.ends_with("\n" + said + "nothing unexplained; 1.5 s\n"));
  CHECK(error.find("--ray=") != std::string::npos);
  CHECK(nlohmann::json::parse(crosscheck_json(result, "a", "b", Ceilings::remark))["passed"] == true);
  CHECK(nlohmann::json::parse(crosscheck_json(result, "a", "b", Ceilings::count))["passed"] == false);
}

TEST_CASE("crosscheck ends with 0 where engines agree, and prints a table") {
  const ProcessResult result = run_program("crosscheck " + box_scene + " --rays=5000 -q");
  CHECK(result.exit_code == 0);
  CHECK(result.err.empty());
  CHECK(result.out.find(" against ") != std::string::npos);
  CHECK(result.out.find("\nbox faces") != std::string::npos);
  const ProcessResult json =
      run_program("crosscheck " + box_scene + " --rays=2000 -q --json --engines=bvh,brute-force");
  CHECK(json.exit_code == 0);
  CHECK(nlohmann::json::parse(json.out)["passed"] == true);
}

TEST_CASE("one ray is shot again by its text") {
  const ProcessResult result =
      run_program("crosscheck " + box_scene + " -q --engines=bvh,brute-force --ray=0,0.1,0.2,0,0,-1,0,inf");
  CHECK(result.exit_code == 0);
  CHECK(result.out.find("bvh ") == 0);
  CHECK(result.out.find("brute-force    t 0x1.") != std::string::npos);
  CHECK(result.out.find("exact          t ") != std::string::npos);
  CHECK(result.err == "");
  const ProcessResult vain = run_program(
      "crosscheck " + box_scene + " -q --engines=bvh,brute-force --json --rays=9 --ray=0,1,2,0,0,-1,0,inf");
  CHECK(vain.err.find("warning: --json: no effect, for --ray shoots one ray\n") != std::string::npos);
  CHECK(vain.err.find("warning: --rays: no effect, for --ray shoots one ray\n") != std::string::npos);
  CHECK(run_program("crosscheck " + box_scene + " -q --engines=bvh,brute-force --rays=9 --placement=moved")
            .err == "warning: --placement: no effect, for it goes with --ray\n");
}

TEST_CASE("a wrong crosscheck command line ends with 2 and its own usage") {
  const ProcessResult result = run_program("crosscheck " + box_scene + " --engines=bvh,octree");
  CHECK(result.exit_code == 2);
  CHECK(result.err.find("there is no engine \"octree\"") != std::string::npos);
  const ProcessResult alone = run_program("crosscheck " + box_scene + " --engines=bvh");
  CHECK(alone.exit_code == 2);
  CHECK(alone.err.starts_with("twinray: --engines: two are needed, one of them bvh, bvh-2 or embree\n"));
  // Neither can be held to for every ray.
  if (find_engine("embree-native"))
    CHECK(run_program("crosscheck " + box_scene + " --engines=brute-force,embree-native")
              .err.starts_with("twinray: --engines: two are needed, one of them bvh, bvh-2 or embree\n"));
  CHECK(run_program("crosscheck " + box_scene + " --engines=bvh,bvh").err.find("bvh stands there twice") !=
        std::string::npos);
  CHECK(result.err.find("usage: twinray crosscheck SCENE.dae") != std::string::npos);
  CHECK(run_program("crosscheck").exit_code == 2);
  CHECK(run_program("crosscheck " + box_scene + " --ray=1,2").exit_code == 2);
  CHECK(run_program("crosscheck " + box_scene + " --placement=gone").exit_code == 2);
  CHECK(run_program("crosscheck --help").exit_code == 0);
}

}  // namespace twinray::test
