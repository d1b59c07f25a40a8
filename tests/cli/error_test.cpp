// SPDX-License-Identifier: Apache-2.0
// The error of settings against a converged picture, as a user measures it.
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <sstream>

#include "check/picture_error.h"
#include "cli/error/command.h"
#include "cli/error/option_set.h"
#include "cli/error/reference_file.h"
#include "cli/error/tile_map.h"
#include "io/picture/image_file.h"
#include "tests/support/catch.h"
#include "tests/support/html.h"
#include "tests/support/own_scenes.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/terminal.h"
#include "tests/support/text.h"

namespace twinray::test {
namespace {

const std::string frame = " -r 40 30 -t 2 ";

std::string error_command(const std::string& more) { return "error '" + spheres_scene + "'" + frame + more; }

using Fields = std::map<std::string, std::string>;

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream stream(line + ",");
  for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
  return fields;
}

/// The lines of a table, each as its fields by their names.
std::vector<Fields> read_table(const std::string& csv) {
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  const std::vector<std::string> names = split(line);
  std::vector<Fields> rows;
  while (std::getline(lines, line)) {
    const std::vector<std::string> fields = split(line);
    REQUIRE(fields.size() == names.size());
    Fields& row = rows.emplace_back();
    for (std::size_t i = 0; i < names.size(); ++i) row[names[i]] = fields[i];
  }
  return rows;
}

double number(const Fields& row, const std::string& name) { return std::stod(row.at(name)); }

/// Measures into a table on standard output.
std::vector<Fields> measured(const std::string& more) {
  const ProcessResult result = run_program(error_command(more + " -q --csv=-"));
  CAPTURE(result.err);
  REQUIRE(result.exit_code == 0);
  return read_table(result.out);
}

/// A reference of 2048 samples, rendered once for all tests.
const std::string& reference() {
  static const TemporaryFolder folder;
  static const std::string path = [] {
    const std::string file = folder.file("reference.exr");
    const ProcessResult result = run_program(error_command(
        "--converge --reference-samples 2048 -s 1 --repeats 1 -q --save-reference '" + file + "'"));
    REQUIRE(result.exit_code == 0);
    return file;
  }();
  return path;
}

}  // namespace

TEST_CASE("a set of options is a name and words, as a shell would split them") {
  const error::OptionSet set = error::parse_option_set(" calm one : -l 4  --environment='a b.exr' \"-m\" 3");
  CHECK(set.name == "calm one");
  CHECK(set.options == Words{"-l", "4", "--environment=a b.exr", "-m", "3"});
  CHECK(error::parse_option_set("usual:").options.empty());
  CHECK(error::parse_option_set("-m 3").name == "-m 3");
  CHECK(error::parse_option_set("-m 3").options == Words{"-m", "3"});
  CHECK(error::parse_option_set("a:--direct=lights:").options == Words{"--direct=lights:"});
  CHECK(error::split_words("a '' b") == Words{"a", "", "b"});
}

TEST_CASE("wrong command lines of error are refused with what would be valid") {
  const std::map<std::string, std::string> wrong{
      {"", "a reference is missing: --reference FILE, or --converge to render it"},
      {"--converge --reference a.exr", "--reference and --converge exclude each other"},
      {"--reference a.exr --save-reference b.exr", "--save-reference goes with --converge"},
      {"--reference a.exr --reference-samples 9", "--reference-samples goes with --converge"},
      {"--converge -s 4,x", "--samples: \"x\" is not a whole number from 1 to 4194304"},
      {"--converge -s 4,", "--samples: \"\" is not a whole number from 1 to 4194304"},
      {"--converge --repeats 0", "--repeats: \"0\" is not a whole number from 1 to 1000"},
      {"--converge --target-rmse 0", "--target-rmse: \"0\" is not a number from 1e-09 to 1000000000"},
      {"--converge --settings ': -m 3'", "--settings: \": -m 3\" has no name; valid is \"NAME: OPTIONS\""},
      {"--converge --settings fast",
       "--settings: \"fast\" has no colon; valid is \"NAME: OPTIONS\", or \"NAME:\""},
      {"--converge --settings 'a: -m 3' --settings 'a:'", "--settings: two sets are called a"},
      {"--converge --settings \"a: 'b\"", "--settings: ' is not closed in: 'b"},
      {"--converge --settings 'a: -m x'", "--settings \"a\": --max-depth: \"x\" is not a whole number"},
      {"--converge --settings 'a: -r 3 4'", "--settings \"a\": there is no option -r"},
      {"--converge --settings 'a: --seed=3'",
       "--settings \"a\": the pictures of all settings have the same seeds: --seed of error"},
      {"--converge --settings 'a: --accel=check'", "--accel=check goes with render; error takes one engine"},
      {"--converge --convert-textures",
       "--convert-textures goes with render; what renders nothing has no error"},
      {"--converge --settings 'a: --convert-textures'", "--convert-textures goes with render"},
  };
  for (const auto& [options, message] : wrong) {
    CAPTURE(options);
    const ProcessResult result = run_program(error_command(options));
    CHECK(result.exit_code == 2);
    CHECK(result.out.empty());
    CHECK(contains(result.err, message));
    CHECK(contains(result.err, "\nusage: twinray error SCENE.dae [options]"));
  }
  CHECK(contains(run_program(error_command("--converge --settings 'a: -r 3 4'")).err,
                 "valid there are render's options of light, sampling and engine"));
}

TEST_CASE("a reference has two halves of as many samples") {
  const auto reference_samples = [](const Words& more) {
    Words words{"a.dae", "--converge", "-s", "5"};
    words.insert(words.end(), more.begin(), more.end());
    return parse_alone<ErrorArguments>(add_error_options, words).reference_samples;
  };
  CHECK(reference_samples({}) == 80);
  CHECK(reference_samples({"--reference-samples", "9"}) == 10);
  CHECK(reference_samples({"--reference-samples", "10"}) == 10);
  CHECK(reference_samples({"--reference-samples", "4194304"}) == 4194304);
  CHECK(reference_samples({"--reference-samples", "4194303"}) == 4194304);
}

TEST_CASE("the search for emitters ends when it is stopped") {
  const error::OptionSet set =
      parse_alone<ErrorArguments>(add_error_options,
                                  {spheres_scene, "--converge", "-r", "40", "30", "--view=file"})
          .common;
  const error::Subject subject(set);
  const PixelMask all(std::size_t(subject.pixel_count()), 1);
  CHECK(subject.without_emitters([] { return false; }) != all);
  CHECK(subject.without_emitters([] { return true; }) == all);
}

TEST_CASE("a reference must be linear and of the frame's size") {
  const TemporaryFolder folder;
  const ProcessResult png = run_program(error_command("--reference a.png"));
  CHECK(png.exit_code == 1);
  CHECK(contains(png.err, "a.png: a reference is a picture of linear floats; its name must end in .exr"));
  const ProcessResult saved = run_program(error_command("--converge --save-reference a.png"));
  CHECK(saved.exit_code == 1);
  CHECK(contains(saved.err, "a.png: a reference is a picture of linear floats; its name must end in .exr"));
  const std::string small = folder.file("small.exr");
  write_exr(small, Image(20, 30));
  const ProcessResult result = run_program(error_command("--reference '" + small + "'"));
  CHECK(result.exit_code == 1);
  CHECK(contains(result.err,
                 "small.exr: it has 20 x 30 pixels, but the pictures to compare have 40 x 30; -r "
                 "sets their size"));
  const std::string crop = folder.file("crop.exr");
  write_exr(crop, Image(20, 15), {}, ImageFrame{5, 0, 40, 30});
  CHECK(run_program(error_command("--reference '" + crop + "' -p 5 0 20 15 -s 1")).exit_code == 0);
  const ProcessResult other = run_program(error_command("--reference '" + crop + "' -p 0 5 20 15 -s 1"));
  CHECK(other.exit_code == 1);
  CHECK(contains(other.err,
                 "crop.exr: it shows x 5 to 25, y 0 to 15 of 40 x 30 pixels, but the pictures to "
                 "compare show x 0 to 20, y 5 to 20 of 40 x 30 pixels"));
  Image hole(40, 30);
  hole.at(7, 5).g = std::nanf("");
  write_exr(small, hole);
  const ProcessResult holed = run_program(error_command("--reference '" + small + "'"));
  CHECK(holed.exit_code == 1);
  CHECK(contains(holed.err, "small.exr: pixel 7 5 is not finite"));
}

TEST_CASE("errors are those of the pictures that render makes with the same options and seeds") {
  const TemporaryFolder folder;
  const std::string alone = folder.file("alone.exr");
  const Image converged = read_image(reference());
  write_exr(alone, converged);  // without its noise, nothing is subtracted
  const std::vector<Fields> rows =
      measured("--reference '" + alone + "' --mask=none -s 4 --repeats 3 --seed 5 --settings 'three: -m 3'");
  REQUIRE(rows.size() == 1);
  double mse = 0, relative = 0;
  for (int seed = 5; seed < 8; ++seed) {
    const std::string file = folder.file("picture.exr");
    REQUIRE(
        run_program(fmt::format("'{}' {} -s 4 -m 3 --seed {} -q -o '{}'", spheres_scene, frame, seed, file))
            .exit_code == 0);
    const SquaredError error =
        squared_error(read_image(file), {converged, {}}, PixelMask(converged.pixels.size(), 1));
    mse += error.mse / 3;
    relative += error.relative / 3;
  }
  CHECK(number(rows[0], "mse") == Approx(mse).epsilon(1e-7));
  CHECK(number(rows[0], "relative_mse") == Approx(relative).epsilon(1e-7));
  CHECK(rows[0].at("settings") == "three");
  CHECK(rows[0].at("samples") == "4");
  CHECK(rows[0].at("seeds") == "3");
}

TEST_CASE("an honest picture has no bias, and a reference that is 1 % too bright shows one") {
  const TemporaryFolder folder;
  const std::string bright = folder.file("bright.exr");
  ConvergedPicture planted = error::read_reference(reference(), {{0, 0, 40, 30}, 40, 30});
  REQUIRE(planted.noise.has_value());
  for (Rgb& pixel : planted.mean.pixels) pixel = pixel * 1.01f;
  error::write_reference(bright, planted, {}, {});
  const std::string options = "-s 16,128 --repeats 4 --reference '";
  const ProcessResult honest = run_program(error_command(options + reference() + "'"));
  CHECK(contains(honest.out, "\nNo bias found in 2 tests, at a level of 1 % for all together.\n"));
  const ProcessResult biased = run_program(error_command(options + bright + "'"));
  CHECK(contains(biased.out, "\ndefault: biased, or another picture than the reference, at "));
  CHECK(!contains(biased.out, "No bias"));
  const Fields row = measured(options + bright + "'").back();
  const double part = number(row, "bias") / number(row, "reference_mean");
  CHECK(std::abs(part + 0.01) < 4 * number(row, "bias_standard_error") / number(row, "reference_mean"));
  CHECK(number(row, "p_value") < 1e-3);
}

TEST_CASE("the noise of a reference that is rendered here is not counted as error, nor as bias") {
  const std::string options = "-s 16 --repeats 8";
  const Fields fine = measured(options + " --reference '" + reference() + "'").front();
  const Fields rough = measured(options + " --converge --reference-samples 48").front();
  // Its noise alone is a third of the error; 8 pictures know that to 2 %.
  CHECK(number(rough, "mse") == Approx(number(fine, "mse")).epsilon(0.1));
  CHECK(number(rough, "p_value") > 0.01);
}

TEST_CASE("each set has a row for each number of samples, and what it takes to each error") {
  const std::vector<Fields> rows = measured("--reference '" + reference() +
                                            "' -s 32,4,4 --repeats 2 --target-rmse 0.03,0.001 --settings "
                                            "'a:' --settings 'b: --sampler=independent'");
  REQUIRE(rows.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(rows[i].at("settings") == (i < 2 ? "a" : "b"));
    CHECK(rows[i].at("samples") == (i % 2 == 0 ? "4" : "32"));
    CHECK(rows[i].at("is_extrapolated_0.03") == "0");
    CHECK(rows[i].at("is_extrapolated_0.001") == "1");
    CHECK(number(rows[i], "samples_to_rmse_0.03") > 4);
    CHECK(number(rows[i], "samples_to_rmse_0.03") < 32);
    CHECK(number(rows[i], "cpu_seconds_to_rmse_0.001") > number(rows[i], "cpu_seconds_to_rmse_0.03"));
  }
  CHECK(number(rows[0], "samples_to_rmse_0.001") ==
        Approx(32 * number(rows[1], "mse") / 1e-6));  // as 1 / samples from the last point on
  CHECK(number(rows[3], "samples_to_rmse_0.03") > number(rows[1], "samples_to_rmse_0.03"));
}

TEST_CASE("a name with a comma is one field of the table") {
  const ProcessResult result = run_program(error_command(
      "-q --csv=- -s 1 --repeats 1 --settings 'b, or \"c\": -m 2' --reference '" + reference() + "'"));
  CHECK(contains(result.out, "\n\"b, or \"\"c\"\"\",1,1,1,"));
}

TEST_CASE("pixels that see an emitter are left out unless all are asked for") {
  const std::string options = "-s 4 --repeats 2 --reference '" + reference() + "'";
  const ProcessResult without = run_program(error_command(options));
  CHECK(contains(without.out, "spheres.dae, 40 x 30 pixels, without "));
  CHECK(contains(without.out, " that see an emitter\n"));
  CHECK(contains(run_program(error_command(options + " --mask=none")).out, "spheres.dae, 40 x 30 pixels\n"));
  // The lamp's edge hides other noise.
  CHECK(number(measured(options + " --mask=none").front(), "mse") >
        2 * number(measured(options).front(), "mse"));
}

TEST_CASE("the page is whole by itself, and shows each set with both plots and its map") {
  const TemporaryFolder folder;
  const std::string page_file = folder.file("page.html");
  const ProcessResult result =
      run_program(error_command("-q --reference '" + reference() +
                                "' -s 4,8 --repeats 2 --settings 'a<b: -m 2' --settings "
                                "'c: -m 0' --html '" +
                                page_file + "'"));
  CHECK(result.exit_code == 0);
  CHECK(result.out.empty());
  const std::string page = read_text(page_file);
  CHECK(html_fault(page) == "");
  CHECK(html_load(page) == "");
  CHECK(count(page, "<svg class=\"curves\"") == 3);
  CHECK(count(page, "aria-label=\"where the means differ\"") == 2);
  CHECK(count(page, "a&lt;b") > 3);
  CHECK(contains(page, "c, 8 samples: p &lt;1e-300"));  // black, but for what emits
  CHECK(contains(page, "Error over samples"));
  CHECK(contains(page, "Error over CPU seconds"));
  CHECK(contains(page, "twinray error "));
}

TEST_CASE("a tile that is too bright is red, one that is too dark blue, and one without bias white") {
  CHECK(error::tile_color({.t = 0, .p_value = 1}) == "#ffffff");
  CHECK(error::tile_color({.t = 9, .p_value = 1e-12}) == "#bf0d1a");
  CHECK(error::tile_color({.t = -9, .p_value = 0}) == "#004db2");
}

TEST_CASE("a reference of unknown noise, and one that is too noisy, are warned of") {
  const TemporaryFolder folder;
  const std::string alone = folder.file("alone.exr");
  std::filesystem::copy_file(reference(), alone);
  CHECK(
      contains(run_program(error_command("-q -s 4 --repeats 2 --reference '" + alone + "'")).err,
               "warning: the reference's noise is not known: it is part of every error, and counts as bias"));
  CHECK(contains(run_program(error_command("-q -s 16 --repeats 2 --converge --reference-samples 32")).err,
                 "warning: the reference's own mean squared error, "));
  CHECK(run_program(error_command("-q -s 4 --repeats 2 --reference '" + reference() + "'")).err.empty());
}

TEST_CASE("a single seed has errors, and no spread nor p-value") {
  const Fields row = measured("--reference '" + reference() + "' -s 4 --repeats 1").front();
  CHECK(number(row, "mse") > 0);
  CHECK(row.at("p_value").empty());
  CHECK(row.at("bias").empty());
}

TEST_CASE("Ctrl-C keeps the rows that are there, beside the old table") {
  const TemporaryFolder folder;
  const std::string table = folder.file("table.csv");
  write_text(table, "old");
  TerminalProgram program({"error", spheres_scene, "-r", "40", "30", "--reference", reference(), "-s",
                           "1,2,64", "--repeats", "1000", "--csv", table});
  REQUIRE(program.wait_for("64 samples, seed "));
  program.press_control_c();
  CHECK(program.exit_code() == 130);
  const std::string partial = folder.file("table_partial.csv");
  CHECK(contains(program.shown(), "twinray: interrupted; the table, " + partial + " hold what there is"));
  CHECK(read_text(table) == "old");
  const std::vector<Fields> rows = read_table(read_text(partial));
  REQUIRE(rows.size() >= 2);
  CHECK(number(rows[0], "seeds") >= 1);
  CHECK(folder.file_count() == 2);
}

TEST_CASE("Ctrl-C before the first picture writes nothing") {
  const TemporaryFolder folder;
  TerminalProgram program({"error", spheres_scene, "-r", "40", "30", "--converge", "--reference-samples",
                           "4000000", "--csv", folder.file("table.csv"), "--save-reference",
                           folder.file("r.exr")});
  REQUIRE(program.wait_for("reference: 2 x 2000000 samples"));
  program.press_control_c();
  CHECK(program.exit_code() == 130);
  CHECK(contains(program.shown(), "twinray: interrupted before the first picture; nothing is written"));
  CHECK(folder.file_count() == 0);
}

}  // namespace twinray::test
