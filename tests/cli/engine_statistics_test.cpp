// SPDX-License-Identifier: Apache-2.0
#include "cli/stats/engine_statistics.h"

#include <fmt/format.h>

#include "cli/statistics_report.h"
#include "cli/stats/command.h"
#include "core/error.h"
#include "io/scene_file.h"
#include "tests/support/catch.h"
#include "tests/support/json.h"
#include "tests/support/own_scenes.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

/// One pass over the rays of 8 x 6 pixels.
StatsOptions tiny_statistics(int threads = 1) {
  return {.recording = {.width = 8, .height = 6}, .threads = threads, .least_seconds = 0};
}

SceneStatistics statistics_of(const std::string& path, const StatsOptions& options = tiny_statistics()) {
  return measure_engines(load_scene(path).scene, options);
}

const EngineStatistics& engine(const SceneStatistics& statistics, const std::string& name) {
  for (const EngineStatistics& entry : statistics.engines)
    if (entry.name == name) return entry;
  throw Error("there is no " + name);
}

std::string counts_text(const EngineStatistics& statistics) {
  std::string text;
  for (const RayStatistics& rays : statistics.rays)
    text += fmt::format("{} {} {} {} {}; ", rays.rays, rays.counts.nodes, rays.counts.boxes,
                        rays.counts.leaves, rays.counts.primitives);
  return text;
}

StatsArguments parse_stats(const Words& words) {
  return parse_alone<StatsArguments>(add_stats_options, words);
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

}  // namespace

TEST_CASE("the counts of a small box follow from its trees") {
  const SceneStatistics statistics = statistics_of(box_scene);
  CHECK(statistics.engines.size() == stats_engines().size());
  for (const char* name : {"bvh-2", "bvh-2-median"})
    for (const RayStatistics& rays : engine(statistics, name).rays) {
      CHECK(rays.rays >= 48);
      // The box around all, and both of each node that is visited.
      CHECK(rays.counts.boxes == rays.rays + 2 * rays.counts.nodes);
    }
  // Twelve triangles by halves: a root, two nodes and four leaves of three. From inside of a box no ray
  // misses the root's halves: all three nodes are visited.
  const EngineStatistics& median = engine(statistics, "bvh-2-median");
  CHECK(median.build.tree.value().nodes == 7);
  CHECK(median.build.tree.value().leaves == 4);
  CHECK(median.build.tree.value().depth == 2);
  for (const RayStatistics& rays : median.rays) {
    CHECK(rays.counts.nodes == 3 * rays.rays);
    CHECK(rays.counts.primitives == 3 * rays.counts.leaves);
    CHECK(rays.counts.leaves <= 4 * rays.rays);
  }
  // By cost each wall is a leaf of its two triangles, and a ray from inside hits one wall; a shadow ray may
  // be asked for the other walls' boxes, but not for more than one leaf each.
  const EngineStatistics& sah = engine(statistics, "bvh-2");
  CHECK(sah.build.tree.value().leaves == 6);
  CHECK(sah.rays[0].counts.leaves == sah.rays[0].rays);
  for (const RayStatistics& rays : sah.rays) {
    CHECK(rays.counts.primitives == 2 * rays.counts.leaves);
    CHECK(rays.counts.leaves <= rays.rays);
    CHECK(rays.counts.nodes <= 5 * rays.rays);  // of eleven in all
  }
  const EngineStatistics& all = engine(statistics, "brute-force");
  CHECK(all.rays[0].counts.primitives == 12 * all.rays[0].rays);
  CHECK(all.rays[1].counts.primitives <= 12 * all.rays[1].rays);
  CHECK(all.rays[2].counts.primitives == 12 * all.rays[2].rays);
}

TEST_CASE("all engines get the same rays, and their counts do not depend on threads") {
  const SceneStatistics one = statistics_of(box_scene), three = statistics_of(box_scene, tiny_statistics(3));
  REQUIRE(one.engines.size() == three.engines.size());
  for (std::size_t i = 0; i < one.engines.size(); ++i) {
    CAPTURE(one.engines[i].name);
    CHECK(counts_text(one.engines[i]) == counts_text(three.engines[i]));
    for (std::size_t kind = 0; kind < ray_kinds.size(); ++kind)
      CHECK(one.engines[i].rays[kind].rays == one.engines[0].rays[kind].rays);
  }
  CHECK(one.engines[0].rays[0].rays == 8 * 6);
}

TEST_CASE("what an engine does not tell is a dash, an empty field, and null") {
  SceneStatistics statistics{{{.name = "some", .has_primitives = true}, {.name = "none"}}};
  for (EngineStatistics& each : statistics.engines)
    for (RayStatistics& rays : each.rays) rays.rays = 1;
  const std::string text = stats_text({}, statistics);
  const std::string some = text.substr(text.find("\nsome") + 1, text.find("\nnone") - text.find("\nsome"));
  CHECK(count_of(some, " -") == 3 + 3);
  CHECK(count_of(text, " -") == 3 + 3 + 3 + 6);
  const std::string csv = stats_csv(statistics);
  CHECK(csv.find("\nsome,0,0,,,,,0,camera,1,,,0,0,0\n") != std::string::npos);
  CHECK(csv.find("\nnone,0,0,,,,,0,bounce,1,,,,,0\n") != std::string::npos);
  const auto json = nlohmann::json::parse(stats_json({}, statistics));
  CHECK(json["engines"][0]["build"]["sah_cost"].is_null());
  CHECK(json["engines"][0]["camera"]["counts"]["nodes"].is_null());
  CHECK(json["engines"][0]["camera"]["counts"]["primitives"] == 0);
  CHECK(json["engines"][1]["camera"]["per_ray"]["primitives"].is_null());
}

TEST_CASE("of rays that there are none of nothing is told but that") {
  const SceneStatistics statistics{{{.name = "bvh", .has_tree = true, .has_primitives = true}}};
  CHECK(count_of(stats_text({}, statistics), " -") == 3 * 3);
  CHECK(stats_csv(statistics).find(",shadow,0,,,,,\n") != std::string::npos);
  const auto shadow = nlohmann::json::parse(stats_json({}, statistics))["engines"][0]["shadow"];
  CHECK(shadow["rays"] == 0);
  CHECK(shadow["rays_per_second"].is_null());
  CHECK(shadow["per_ray"]["primitives"].is_null());
  CHECK(shadow["counts"]["primitives"] == 0);
}

TEST_CASE("brute force is left out where it would take too long") {
  StatsOptions options = tiny_statistics();
  CHECK_FALSE(statistics_of(box_scene, options).is_brute_force_left_out);
  options.brute_force_tests = 100;
  const SceneStatistics statistics = statistics_of(box_scene, options);
  CHECK(statistics.is_brute_force_left_out);
  CHECK(statistics.engines.size() + 1 == stats_engines().size());
  CHECK(stats_text({}, statistics).find("Brute force is left out") != std::string::npos);
}

TEST_CASE("a scene without shapes has statistics") {
  const SceneStatistics statistics = statistics_of(TWINRAY_SOURCE_DIR "/tests/bad/warning_no_shapes.dae");
  CHECK(counts_text(engine(statistics, "bvh-2")).find("48 0 ") == 0);
  CHECK(counts_text(engine(statistics, "brute-force")) == "48 0 0 0 0; 0 0 0 0 0; 0 0 0 0 0; ");
}

TEST_CASE("the stats command prints a row for each engine and writes both files") {
  const TemporaryFolder folder;
  const std::string csv = folder.file("a.csv"), json = folder.file("a.json");
  const ProcessResult result = run_program("stats -r 8 6 -t 1 --seconds=0 " + box_scene + " --csv " +
                                           quoted(csv) + " --json " + quoted(json));
  CHECK(result.exit_code == 0);
  CHECK(folder.file_count() == 2);
  CHECK(result.out.find("\nengine ") != std::string::npos);
  CHECK(result.out.find("\n12 primitives. ") != std::string::npos);
  CHECK(result.out.find("\nof 8 x 6 pixels, 1 sample each, view whole: 48 camera, ") != std::string::npos);
  for (const AgreementEngine& entry : stats_engines())
    CHECK(result.out.find("\n" + entry.name + " ") != std::string::npos);
  CHECK(count_of(read_text(csv), "\n") == 1 + 3 * stats_engines().size());
  const auto parsed = nlohmann::json::parse(read_text(json));
  CHECK(parsed["resolution"] == nlohmann::json({8, 6}));
  CHECK(parsed["threads"] == 1);
  CHECK(parsed["engines"].size() == stats_engines().size());
  CHECK(parsed["engines"][1]["camera"]["rays"] == 48);
}

TEST_CASE("a wrong stats command line ends with 2, and a file that is not there or not writable with 1") {
  const ProcessResult unknown = run_program("stats --none " + box_scene);
  CHECK(unknown.exit_code == 2);
  CHECK(unknown.err ==
        "twinray: there is no option --none\n"
        "usage: twinray stats SCENE.dae [options]; all options: twinray stats --help\n");
  CHECK_THROWS_AS(parse_stats({}), UsageError);
  CHECK_THROWS_AS(parse_stats({"a.dae", "-r", "0", "1"}), UsageError);
  CHECK_THROWS_AS(parse_stats({"a.dae", "-s", "0"}), UsageError);
  CHECK_THROWS_AS(parse_stats({"a.dae", "--view", "both"}), UsageError);
  CHECK_THROWS_AS(parse_stats({"a.dae", "--seconds=-1"}), UsageError);
  CHECK(parse_stats({"a.dae", "--seconds=0.5"}).options.least_seconds == 0.5);
  CHECK(parse_stats({"a.dae"}).view == View::whole);
  CHECK(parse_stats({"a.dae", "--view=file"}).view == View::file);
  CHECK(run_program("stats -q no-such-scene.dae").exit_code == 1);
  const TemporaryFolder folder;
  const std::string nowhere = folder.file("none/a.csv");
  const ProcessResult refused = run_program("stats -q " + box_scene + " --csv " + quoted(nowhere));
  CHECK(refused.exit_code == 1);
  CHECK(refused.out.empty());
  CHECK(refused.err == fmt::format("twinray: {}: there is no folder {}\n", nowhere, folder.file("none")));
  const ProcessResult help = run_program("stats --help");
  CHECK(help.exit_code == 0);
  CHECK(help.out.find("--csv") != std::string::npos);
}

}  // namespace twinray::test
