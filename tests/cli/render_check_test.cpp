// SPDX-License-Identifier: Apache-2.0
// twinray render --accel=check, as a program.

#include "core/image.h"
#include "io/picture/image_file.h"
#include "tests/support/catch.h"
#include "tests/support/json.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

const std::string bunny = TWINRAY_SOURCE_DIR "/scenes/cornell-bunny.dae";
const std::string small = " -r 24 18 -s 2 ";

/// The first line that begins with these words.
std::string line_of(const std::string& text, const std::string& words) {
  const std::size_t begin = text.find("\n" + words) + 1;
  REQUIRE(begin > 0);
  return text.substr(begin, text.find('\n', begin) - begin);
}

}  // namespace

TEST_CASE("a render is checked: the picture of the bvh, a table, and a picture without marks") {
  const TemporaryFolder folder;
  const ProcessResult result =
      run_program(bunny + small + "--accel=check -o " + quoted(folder.file("a.exr")) + " --stats " +
                  quoted(folder.file("a.json")));
  CHECK(result.exit_code == 0);
  CHECK(result.err.empty());
  CHECK(result.out.find(" against bvh\nrays ") != std::string::npos);
  CHECK(result.out.find("\ncamera            864          864            0 ") != std::string::npos);
  CHECK(result.out.find("\nnothing unexplained; ") != std::string::npos);
  CHECK(folder.file_count() == 3);
  CHECK(nlohmann::json::parse(read_text(folder.file("a.json")))["check"]["passed"] == true);
  REQUIRE(run_program(bunny + small + "-q --accel=bvh -o " + quoted(folder.file("b.exr"))).exit_code == 0);
  CHECK(read_image(folder.file("a.exr")).pixels == read_image(folder.file("b.exr")).pixels);
  for (const Rgb& pixel : read_image(folder.file("a_differences.png")).pixels) CHECK(pixel.r == pixel.b);
}

TEST_CASE("a checked render with a planted difference ends with 1 and names rays, which can be shot again") {
  const TemporaryFolder folder;
  const ProcessResult result =
      run_program(bunny + small + "-q --accel=check --plant-difference -o " + quoted(folder.file("a.png")));
  CHECK(result.exit_code == 1);
  CHECK(result.out.find(" unexplained; ") != std::string::npos);
  const std::string finding = line_of(result.out, "bvh-moller-trumbore, camera ray of pixel ");
  CHECK(finding.find(", sample ") != std::string::npos);
  CHECK(finding.find(", unexplained: bvh sees t 0x1.") != std::string::npos);
  CHECK(finding.find("; exact t ") != std::string::npos);
  bool has_red = false;
  for (const Rgb& pixel : read_image(folder.file("a_differences.png")).pixels)
    has_red = has_red || pixel == Rgb{1, 0, 0};
  CHECK(has_red);

  const std::string command = line_of(result.out, "  twinray crosscheck ");
  const ProcessResult again = run_program(command.substr(command.find("crosscheck")));
  CHECK(again.exit_code == 0);
  const std::string seen = finding.substr(finding.find("bvh sees ") + 9);
  CHECK(again.out.find(seen.substr(0, seen.find(';'))) != std::string::npos);
}

TEST_CASE("CS184's program says what a check has found, also where all is the same") {
  const TemporaryFolder folder;
  const ProcessResult result =
      run_program("--cs184 -r 16 12 -m 2 --accel=check --check-with=brute-force -f " +
                  quoted(folder.file("a.png")) + " " + bunny);
  CHECK(result.exit_code == 0);
  CHECK(result.out.find("\nDifferences    " + folder.file("a_differences.png") + "\n") != std::string::npos);
  CHECK(result.out.find("\nnothing unexplained; ") != std::string::npos);
}

TEST_CASE("a ray of a scene that is read by CS184's rules has no command that would read it otherwise") {
  const TemporaryFolder folder;
  const ProcessResult result = run_program("--cs184 -r 16 12 -m 2 --accel=check --plant-difference -f " +
                                           quoted(folder.file("a.png")) + " " + bunny);
  CHECK(result.exit_code == 1);
  CHECK(result.out.find(
            "  # crosscheck reads the scene at rest, and by no rules of CS184: twinray crosscheck ") !=
        std::string::npos);
  CHECK(result.out.find("  twinray crosscheck ") == std::string::npos);
}

}  // namespace twinray::test
