// SPDX-License-Identifier: Apache-2.0
#include "cli/crosscheck/agreement.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/crosscheck/agreement_command.h"
#include "core/error.h"
#include "io/scene_file.h"
#include "tests/support/catch.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

const std::string scenes = TWINRAY_SOURCE_DIR "/scenes/";
/// By six integrators and two samplers, on each of the engines' numbers of threads.
std::size_t renders_of(const std::vector<AgreementEngine>& engines) {
  std::size_t renders = 0;
  for (const AgreementEngine& engine : engines) renders += 6 * 2 * engine.threads.size();
  return renders;
}

AgreementOptions tiny() { return {.width = 8, .height = 6, .samples = 2}; }

}  // namespace

TEST_CASE("all engines give the same bits for the box and for a mesh") {
  for (const char* name : {"box.dae", "cornell-bunny.dae"}) {
    const Scene scene = load_scene(scenes + name).scene;
    const SceneAgreement found = compare_engines(scene, tiny());
    CHECK(found.renders == renders_of(agreement_engines()));
    CHECK(found.rays > found.pixels);
    CHECK(found.differences.empty());
  }
}

TEST_CASE("engines are compared with every instruction set of the machine") {
  std::vector<std::string> names;
  for (const AgreementEngine& engine : agreement_engines()) names.push_back(engine.name);
  const auto has = [&](const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  for (const std::string& simd : available_instruction_sets())
    if (simd != "best") CHECK(has("bvh-" + simd));
#ifdef TWINRAY_WITH_EMBREE
  for (const char* isa :
       {"embree", "embree-sse2", "embree-sse4.2", "embree-avx", "embree-avx512", "embree-default"})
    CHECK(has(isa));
  for (const std::string& simd : available_instruction_sets())
    if (simd != "best") CHECK(has("embree-leaf-" + simd));
#endif
}

TEST_CASE("an engine that gives other bits is found, with the first pixel and both values") {
  AgreementOptions options = tiny();
  options.engines.push_back(differing_engine());
  const SceneAgreement found = compare_engines(load_scene(scenes + "cornell-bunny.dae").scene, options);
  CHECK(found.renders == renders_of(options.engines));
  REQUIRE_FALSE(found.differences.empty());
  for (const std::string& difference : found.differences) {
    CHECK(difference.find(", bvh-moller-trumbore, threads ") != std::string::npos);
    CHECK(difference.find(": pixel ") != std::string::npos);
    CHECK(difference.find(" 0x1.") != std::string::npos);
  }
}

TEST_CASE("brute force renders the middle of the frame where the whole is more than it may do") {
  AgreementOptions options = tiny();
  const Scene scene = load_scene(scenes + "box.dae").scene;
  CHECK(compare_engines(scene, options).brute_force_pixels == 8 * 6);
  options.brute_force_tests = 1e4;
  const SceneAgreement found = compare_engines(scene, options);
  CHECK(found.brute_force_pixels < 8 * 6);
  CHECK(found.brute_force_pixels > 1);
  CHECK(found.differences.empty());
  options.brute_force_tests = 1;
  CHECK(compare_engines(scene, options).brute_force_pixels == 1);
}

TEST_CASE("the agreement command prints one row for a scene, and ends with 0 where all agree") {
  const std::string box = scenes + "box.dae";
  const ProcessResult table = run_program("agreement -r 8 6 -s 1 " + box);
  CHECK(table.exit_code == 0);
  CHECK(table.err.empty());
  CHECK(table.out.find("scene  ") == 0);
  CHECK(table.out.find("\n" + box + " ") != std::string::npos);
  CHECK(table.out.find(" same bits\n") != std::string::npos);
  const ProcessResult verdict = run_program("agreement -q -r 8 6 -s 1 " + box);
  CHECK(verdict.exit_code == 0);
  CHECK(verdict.out.find('\n') + 1 == verdict.out.size());
  CHECK(verdict.out.find(" renders of 1 scenes (") != std::string::npos);
  CHECK(verdict.out.find("): all the same, bit for bit\n") != std::string::npos);
}

TEST_CASE("the agreement command ends with 1 and names what differs") {
  const ProcessResult result =
      run_program("agreement --plant-difference -q -r 8 6 " + scenes + "cornell-bunny.dae");
  CHECK(result.exit_code == 1);
  CHECK(
      result.out.find("cornell-bunny.dae: view whole, path, sobol, bvh-moller-trumbore, threads 7: pixel ") !=
      std::string::npos);
  CHECK(result.out.find(" differ\n") != std::string::npos);
}

TEST_CASE("without a scene the agreement command takes ours and those of TWINRAY_SCENES") {
  const TemporaryFolder folder;
  write_text(folder.file("box.dae"), read_text(scenes + "box.dae"));
  const ProcessResult result = run_program("agreement -r 2 1 -s 1 --view file",
                                           fmt::format("TWINRAY_SCENES='{}'", folder.path().string()));
  CHECK(result.exit_code == 0);
  CHECK(result.out.find("\nscenes/box.dae ") != std::string::npos);
  CHECK(result.out.find("\nscenes/lights.dae ") != std::string::npos);
  CHECK(result.out.find("\nbox.dae ") != std::string::npos);
}

TEST_CASE("a wrong agreement command line ends with 2, a scene that is not there with 1") {
  const ProcessResult unknown = run_program("agreement --none");
  CHECK(unknown.exit_code == 2);
  CHECK(unknown.out.empty());
  CHECK(unknown.err ==
        "twinray: there is no option --none\n"
        "usage: twinray agreement [SCENE.dae]... [options]; all options: twinray agreement --help\n");
  CHECK_THROWS_AS(parse_alone<AgreementArguments>(add_agreement_options, {"-r", "0", "1"}), UsageError);
  CHECK_THROWS_AS(parse_alone<AgreementArguments>(add_agreement_options, {"-s", "0"}), UsageError);
  CHECK_THROWS_AS(parse_alone<AgreementArguments>(add_agreement_options, {"--view", "none"}), UsageError);
  CHECK(run_program("agreement -q no-such-scene.dae").exit_code == 1);
  CHECK(run_program("agreement --help").exit_code == 0);
}

}  // namespace twinray::test
