// SPDX-License-Identifier: Apache-2.0
// Plans for many machines.
#include <fmt/format.h>

#include <filesystem>

#include "cli/plan/farm_plan.h"
#include "io/picture/image_file.h"
#include "io/picture/layered_image.h"
#include "tests/support/catch.h"
#include "tests/support/json.h"
#include "tests/support/own_scenes.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/text.h"

namespace twinray::test {
namespace {

namespace fs = std::filesystem;

/// A command of a shell within the folder.
ProcessResult shell_in(const TemporaryFolder& folder, const std::string& command) {
  return run_shell("cd " + quoted(folder.path().string()) + " && " + command);
}

ProcessResult plan_in(const TemporaryFolder& folder, const std::string& words) {
  return shell_in(folder, quoted(TWINRAY_PROGRAM) + " plan " + words);
}

std::string error_of(const std::string& words) {
  const TemporaryFolder folder;
  const ProcessResult result = plan_in(folder, quoted(box_scene) + " " + words);
  CHECK(result.exit_code != 0);
  CHECK(folder.file_count() == 0);
  return result.err.substr(0, result.err.find('\n'));
}

/// Calls each line of a plan's list, the last one first, and merges.
void render_by(const TemporaryFolder& folder, const std::string& plan) {
  const ProcessResult result = shell_in(
      folder,
      fmt::format("tac {0}/commands.txt | while read -r line; do bash -c \"$line\" || exit 9; done && "
                  "{0}/merge-parts",
                  plan));
  INFO(result.out << result.err);
  REQUIRE(result.exit_code == 0);
}

}  // namespace

TEST_CASE("a plan that does not fit on the disk leaves nothing, and can be tried again") {
  const TemporaryFolder folder;
  const std::string words =
      " plan " + quoted(box_scene) + " -r 16 12 -s 100 --jobs=100 -q -o a.pfm --folder=";
  write_text(folder.file("old"), "old");
  for (const char* plan : {"p", "new/er/p", "q/"}) {
    CAPTURE(plan);
    // Of what is larger than a block nothing can be written.
    const ProcessResult full = shell_in(folder, "ulimit -f 1; " + quoted(TWINRAY_PROGRAM) + words + plan);
    CHECK(full.exit_code == 1);
    CHECK(full.err.find(": cannot be written: File too large\n") != std::string::npos);
    CHECK(folder.file_count() == 1);
    CHECK(shell_in(folder, quoted(TWINRAY_PROGRAM) + words + plan).exit_code == 0);
    CHECK(fs::exists(folder.file(std::string(plan) + "/openjd/template.json")));
    fs::remove_all(folder.file(plan));
    fs::remove_all(folder.file("new"));
  }
  // Of others nothing is removed.
  fs::create_symlink("nowhere", folder.file("link"));
  CHECK(shell_in(folder, quoted(TWINRAY_PROGRAM) + words + "link").exit_code == 1);
  CHECK(fs::is_symlink(folder.file("link")));
}

TEST_CASE("a task of Open Job Description renders several parts that follow on each other") {
  const TemporaryFolder folder;
  REQUIRE(
      plan_in(folder, quoted(box_scene) + " -r 16 12 -s 2500 --folder=p --jobs=2500 -o a.pfm").exit_code ==
      0);
  const auto plan = nlohmann::json::parse(read_text(folder.file("p/openjd/template.json")));
  CHECK(plan["extensions"] == nlohmann::json{"TASK_CHUNKING"});
  CHECK(plan["parameterDefinitions"][0]["default"] == 3);  // A thousand tasks, at most.
  const auto numbers = plan["steps"][0]["parameterSpace"]["taskParameterDefinitions"][0];
  CHECK(numbers["type"] == "CHUNK[INT]");
  CHECK(numbers["range"] == "0-2499");
  CHECK(numbers["chunks"]["rangeConstraint"] == "CONTIGUOUS");
  CHECK(shell_in(folder, "p/render-part 9-11").exit_code == 0);
  CHECK(fs::exists(folder.file("p/parts/00009.film")));
  CHECK(fs::exists(folder.file("p/parts/00011.film")));
  CHECK_FALSE(fs::exists(folder.file("p/parts/00012.film")));
  CHECK_FALSE(fs::exists(folder.file("p/parts/00008.film")));
  CHECK(shell_in(folder, "p/render-part 08-08").exit_code == 0);
  CHECK(fs::exists(folder.file("p/parts/00008.film")));
  for (const char* wrong : {"-1", "5-3", "3-", "a-b", "1-2-3"}) {
    CAPTURE(wrong);
    const ProcessResult result = shell_in(folder, std::string("p/render-part ") + wrong);
    CHECK(result.exit_code == 2);
    CHECK(result.err ==
          fmt::format("p/render-part: \"{}\" is neither a part from 0 to 2499 nor a range of such as 3-7\n",
                      wrong));
  }
}

TEST_CASE("a range of a plan's parts that is stopped stops its part, which goes on later") {
  const TemporaryFolder folder;
  REQUIRE(
      plan_in(folder, quoted(box_scene) + " -r 16 12 -s 4000000 --folder=p --jobs=2 -o a.pfm").exit_code ==
      0);
  const ProcessResult stopped =
      shell_in(folder,
               "p/render-part 0-1 & run=$!; children=/proc/$run/task/$run/children; "
               "until part=$(cat $children) && [ -n \"$part\" ]; do sleep 0.05; done; "
               "sleep 1; kill -TERM $run; wait $run; code=$?; ! kill -0 $part 2>/dev/null && exit $code");
  CHECK(stopped.exit_code == 75);
  CHECK(fs::exists(folder.file("p/parts/00000.checkpoint")));
  fs::remove(folder.file("p/parts/00000.checkpoint"));
  // The signal comes to the whole group: to the part from the script, too.
  CHECK(shell_in(folder,
                 "setsid p/render-part 0-1 & run=$!; children=/proc/$run/task/$run/children; "
                 "until part=$(cat $children) && [ -n \"$part\" ]; do sleep 0.05; done; "
                 "sleep 1; kill -TERM -$run; wait $run")
            .exit_code == 75);
  CHECK(fs::exists(folder.file("p/parts/00000.checkpoint")));
  CHECK_FALSE(fs::exists(folder.file("p/parts/00000.film")));
  CHECK_FALSE(fs::exists(folder.file("p/parts/00001.checkpoint")));
}

TEST_CASE("the parts of a plan merge to the picture of one render, in whatever order they are made") {
  const TemporaryFolder folder;
  const std::string scene = "'a b.dae'", options = " -r 48 36 -s 11 ";
  fs::copy(box_scene, folder.file("a b.dae"));
  const ProcessResult planned =
      plan_in(folder, scene + options + "--folder='my plan' --jobs=4 --output='a b.pfm'");
  INFO(planned.err);
  REQUIRE(planned.exit_code == 0);
  CHECK(planned.out.starts_with("Plan           11 samples in 4 parts\n"));
  const std::string unfinished = folder.file("my plan/parts/.00001.film.123.part");
  write_text(unfinished, "killed while it was written");
  render_by(folder, "'my plan'");
  CHECK_FALSE(fs::exists(unfinished));
  CHECK(shell_in(folder, quoted(TWINRAY_PROGRAM) + " " + scene + options + "-q -o b.pfm").exit_code == 0);
  CHECK(read_text(folder.file("a b.pfm")) == read_text(folder.file("b.pfm")));
  // What is done is not done again, and no checkpoint stays.
  const auto time = fs::last_write_time(folder.file("my plan/parts/00002.film"));
  render_by(folder, "'my plan'");
  CHECK(fs::last_write_time(folder.file("my plan/parts/00002.film")) == time);
  CHECK_FALSE(fs::exists(folder.file("my plan/parts/00002.checkpoint")));
}

TEST_CASE(
    "an adaptive picture is planned by tiles, others if asked for, and never in more parts than there are") {
  const TemporaryFolder folder;
  const auto check = [&](const std::string& options, const std::string& plan, const std::string& said) {
    fs::remove_all(folder.file("p"));
    const std::string scene = quoted(box_scene) + " -r 40 20 " + options;
    CHECK(plan_in(folder, scene + " --folder=p -o a.pfm " + plan).out.starts_with(said));
    render_by(folder, "p");
    CHECK(shell_in(folder, quoted(TWINRAY_PROGRAM) + " " + scene + " -q -o b.pfm").exit_code == 0);
    CHECK(read_text(folder.file("a.pfm")) == read_text(folder.file("b.pfm")));
  };
  check("-s 40 -a 8 0.3", "--jobs=100", "Plan           6 tiles in 6 parts\n");
  check("-s 3", "--jobs=2 --by-tiles", "Plan           6 tiles in 2 parts\n");
  check("-s 3", "--jobs=9", "Plan           3 samples in 3 parts\n");
}

TEST_CASE("frames have their numbers in scenes and pictures") {
  const TemporaryFolder folder;
  for (const char* name : {"s08.dae", "s09.dae", "s10.dae"}) fs::copy(box_scene, folder.file(name));
  const ProcessResult planned =
      plan_in(folder, "s%02d.dae -r 24 18 -s 4 --frames=8:10 --folder=p --jobs=2 -o f%02d%02d.pfm --seed=3");
  INFO(planned.err);
  CHECK(planned.out.starts_with("Plan           4 samples in 2 parts, for each of 3 frames\n"));
  render_by(folder, "p");
  CHECK(shell_in(folder, quoted(TWINRAY_PROGRAM) + " s09.dae -r 24 18 -s 4 -q --seed=3 -o b.pfm").exit_code ==
        0);
  for (const char* name : {"f0808.pfm", "f0909.pfm", "f1010.pfm"})
    CHECK(read_text(folder.file(name)) == read_text(folder.file("b.pfm")));
}

TEST_CASE("what is no part or frame of a plan is refused, and the others are merged where one is missing") {
  const TemporaryFolder folder;
  fs::copy(box_scene, folder.file("s.dae"));
  CHECK(plan_in(folder, "s.dae -r 24 18 -s 2 --frames=8:10 --folder=p --jobs=2 --seed=%d -o f%04d.pfm")
            .exit_code == 0);
  const auto code = [&](const std::string& command) { return shell_in(folder, command).exit_code; };
  for (const char* wrong : {"", "6", "-1", "4-6", "3-2", "1 2", "x", "1-2-3", "99999999999"})
    CHECK(shell_in(folder, fmt::format("p/render-part {}", wrong)).err ==
          fmt::format("p/render-part: \"{}\" is neither a part from 0 to 5 nor a range of such as 3-7\n",
                      wrong));
  CHECK(code("p/render-part 6") == 2);
  CHECK_FALSE(fs::exists(folder.file("p/parts/0011-00000.film")));
  CHECK(code("p/render-part 00-01 && p/render-part 05 && p/render-part 4 && p/render-part 2") == 0);
  // What SIGUSR1 leaves of a part.
  write_text(folder.file("p/parts/0008-00000_partial.film"), "no film that is done");
  const ProcessResult merged = shell_in(folder, "p/merge-parts");
  CHECK(merged.exit_code == 1);
  CHECK(merged.err.find("samples 1:2 of 2 are missing") != std::string::npos);
  CHECK(fs::exists(folder.file("f0008.pfm")));
  CHECK_FALSE(fs::exists(folder.file("f0009.pfm")));
  CHECK(fs::exists(folder.file("f0010.pfm")));
  CHECK(code("p/render-part 3 && p/merge-parts 1") == 0);
  CHECK(fs::exists(folder.file("f0009.pfm")));
  for (const char* wrong : {"3", "x", "-1"})
    CHECK(shell_in(folder, fmt::format("p/merge-parts {}", wrong)).err ==
          fmt::format("p/merge-parts: \"{}\" is no number of a frame from 0 to 2\n", wrong));
  CHECK_FALSE(fs::exists(folder.file("f0011.pfm")));
}

TEST_CASE("each frame of a plan has a place for its picture") {
  const TemporaryFolder folder;
  fs::copy(box_scene, folder.file("s.dae"));
  fs::create_directory(folder.file("0005"));
  const ProcessResult planned =
      plan_in(folder, "s.dae -r 24 18 -s 2 --frames=5:6 --folder=p --jobs=1 -o %04d/x.png");
  CHECK(planned.exit_code == 1);
  CHECK(planned.err == "twinray: 0006/x.png: there is no folder 0006\n");
  CHECK(plan_in(folder, "s.dae --folder=p --jobs=1 --convert-textures -o x.png").exit_code == 2);
}

TEST_CASE("frames that are all the same picture are warned of, and refused where that is asked for") {
  const TemporaryFolder folder;
  const std::string words = quoted(box_scene) + " -r 24 18 -s 2 --frames=5:6 --jobs=1 -o x%d.png --folder=";
  const std::string same =
      "--frames: only the picture's name has a place for the number, so all frames are the same picture";
  const ProcessResult planned = plan_in(folder, words + "p");
  CHECK(planned.exit_code == 0);
  CHECK(planned.err == "warning: " + same + "\n");
  const ProcessResult strict = plan_in(folder, words + "q --strict");
  CHECK(strict.exit_code == 2);
  CHECK(strict.err.starts_with("twinray: " + same));
}

TEST_CASE("options of numbers may have the frame's number, and options of a frame are those of its picture") {
  const TemporaryFolder folder;
  const ProcessResult planned =
      plan_in(folder, quoted(box_scene) +
                          " -r 24 18 -s 4 --frames=3:4 --folder=p%d --jobs=2 -o f%d.exr --seed=%d "
                          "--layers=albedo --exr-compression=zip --strict");
  INFO(planned.err);
  REQUIRE(planned.exit_code == 0);
  render_by(folder, "p%d");
  for (const int frame : {3, 4}) {
    CHECK(shell_in(folder, fmt::format("{} {} -r 24 18 -s 4 -q --layers=albedo --seed={} -o b.exr",
                                       quoted(TWINRAY_PROGRAM), quoted(box_scene), frame))
              .exit_code == 0);
    CHECK(read_layers(folder.file(fmt::format("f{}.exr", frame))).values ==
          read_layers(folder.file("b.exr")).values);
  }
}

TEST_CASE("a part's minutes say how many parts there are") {
  const TemporaryFolder folder;
  const ProcessResult planned =
      plan_in(folder, quoted(box_scene) + " -s 1000000 -t 1 --folder=p --part-minutes=1 -o a.pfm");
  REQUIRE(planned.exit_code == 0);
  const std::string list = read_text(folder.file("p/commands.txt"));
  CHECK(std::count(list.begin(), list.end(), '\n') > 10);
  CHECK(planned.out.find("A part         ") != std::string::npos);
  const ProcessResult small =
      plan_in(folder, quoted(box_scene) + " -s 1000000 -t 1 --folder=q --part-minutes=0.05 -o a.pfm");
  const std::size_t begin = small.out.find("A part         ");
  REQUIRE(begin != std::string::npos);
  CHECK(small.out.substr(begin, small.out.find('\n', begin) - begin).find(" seconds on a machine") !=
        std::string::npos);
}

TEST_CASE("a plan's picture is a file, for its last job writes it") {
  const TemporaryFolder folder;
  const ProcessResult refused = plan_in(folder, quoted(box_scene) + " -s 4 --folder=p --jobs=2 -o -");
  CHECK(refused.exit_code == 2);
  CHECK(refused.err.find("--output=-: the last job of a plan writes its picture to a file") !=
        std::string::npos);
}

TEST_CASE("a place for a frame's number is that of printf") {
  CHECK(has_frame_number("a%04d.dae"));
  CHECK(has_frame_number("a%d"));
  CHECK_FALSE(has_frame_number("a%.dae"));
  CHECK_FALSE(has_frame_number("100%"));
  CHECK_FALSE(has_frame_number("a%0004d"));
  CHECK(with_frame_number("a%04d.dae", 37) == "a0037.dae");
  CHECK(with_frame_number("50%_%d.dae", 37) == "50%_37.dae");
  CHECK(with_frame_number("a%3d", 7) == "a  7");
  CHECK(with_frame_number("%d/a%04d_%d", 7) == "7/a0007_7");
  CHECK(with_frame_number("a.dae", 37) == "a.dae");
}

TEST_CASE("a task of Slurm queues itself again once its time is over, and not where it is cancelled") {
  const TemporaryFolder folder;
  FarmPlan plan{.name = "job", .folder = folder.path().string(), .parts = 2};
  write_text(folder.file("job.sh"), slurm_render_job(plan));
  // A part that keeps its checkpoint when it is stopped, and a Slurm that writes down what it is asked.
  write_text(folder.file("render-part"),
             "#!/bin/bash\ntrap 'exit 75' TERM\necho $$ >begun\nwhile :; do sleep 0.02; done\n");
  write_text(folder.file("scontrol"), "#!/bin/bash\necho \"$@\" >>calls\n");
  const auto code_after = [&](const std::string& signals) {
    return shell_in(folder,
                    "chmod +x render-part scontrol && rm -f begun calls && export PATH=\"$PWD:$PATH\" "
                    "SLURM_JOB_ID=77 SLURM_ARRAY_TASK_ID=1 && { bash job.sh & job=$!; } && "
                    "while [ ! -s begun ]; do sleep 0.02; done && " +
                        signals + "; wait $job")
        .exit_code;
  };
  CHECK(code_after("kill -USR2 $job") == 75);
  CHECK(read_text(folder.file("calls")) == "requeue 77\n");
  CHECK(code_after("kill -TERM $(cat begun) $job") == 75);
  CHECK_FALSE(fs::exists(folder.file("calls")));
  CHECK(code_after("kill -TERM $job; sleep 0.1; kill -TERM $(cat begun)") == 75);
  CHECK_FALSE(fs::exists(folder.file("calls")));
  CHECK(code_after("kill -USR2 $job") == 75);
  CHECK(read_text(folder.file("calls")) == "requeue 77\n");
}

TEST_CASE("a task of Slurm has the code of a part that ends just as the task is signalled") {
  const TemporaryFolder folder;
  const FarmPlan plan{.name = "job", .folder = folder.path().string(), .parts = 2};
  write_text(folder.file("job.sh"), slurm_render_job(plan));
  write_text(folder.file("render-part"),
             "#!/bin/bash\ntrap 'exit 75' TERM\necho $$ >begun\nwhile :; do :; done\n");
  write_text(folder.file("impatient"), "sleep() { command sleep 0.01; }\n");
  const ProcessResult result =
      shell_in(folder,
               "chmod +x render-part && export SLURM_ARRAY_TASK_ID=1 && for pause in $(seq 0 20 1180); do "
               "rm -f begun; BASH_ENV=\"$PWD/impatient\" bash job.sh & job=$!; "
               "while [ ! -s begun ]; do sleep 0.003; done; kill -TERM $(cat begun); "
               "while [ $pause -gt 0 ]; do pause=$((pause - 1)); done; kill -TERM $job; wait $job; echo $?; "
               "done | sort | uniq -c");
  CHECK(result.out == "     60 75\n");
}

TEST_CASE("more parts than a usual Slurm has tasks are several to a task, each in one of them") {
  const TemporaryFolder folder;
  const auto ranges = [&](std::uint32_t parts, std::uint32_t tasks) {
    const FarmPlan plan{.name = "job", .folder = folder.path().string(), .parts = parts};
    const std::string job = slurm_render_job(plan);
    CHECK(job.find(fmt::format("#SBATCH --array=0-{}\n", tasks - 1)) != std::string::npos);
    write_text(folder.file("job.sh"), job);
    write_text(folder.file("render-part"), "#!/bin/bash\necho $1\n");
    return shell_in(folder,
                    fmt::format("chmod +x render-part; for task in 0 {}; do SLURM_ARRAY_TASK_ID=$task bash "
                                "job.sh; done",
                                tasks - 1))
        .out;
  };
  CHECK(ranges(1000, 1000) == "0\n999\n");
  CHECK(ranges(1001, 501) == "0-1\n1000-1000\n");
  CHECK(ranges(3000, 1000) == "0-2\n2997-2999\n");
}

TEST_CASE("a folder of any name is that of Slurm's logs") {
  const TemporaryFolder folder;
  REQUIRE(plan_in(folder, quoted(box_scene) + " -q --folder='50%j it'\\''s' --jobs=2 -o a.pfm").exit_code ==
          0);
  write_text(folder.file("sbatch"), "#!/bin/bash\nfor word; do echo \"$word\"; done >>calls\necho 77\n");
  const ProcessResult submitted =
      shell_in(folder, "chmod +x sbatch && PATH=\"$PWD:$PATH\" '50%j it'\\''s/slurm/submit' --time=5");
  CHECK(submitted.out.starts_with("parts: job 77; merging: job 77; logs: "));
  const std::string calls = read_text(folder.file("calls"));
  // What %% means there is %.
  CHECK(contains(calls, "/50%%j it's/logs/render-%a.log\n--time=5\n"));
  CHECK(contains(calls, "/50%%j it's/logs/merge-%a.log\n--dependency=afterok:77\n"));
  CHECK(contains(calls, "/50%j it's/slurm/merge.sbatch\n"));
}

TEST_CASE("a plan's picture is none that its scene reads") {
  const TemporaryFolder folder;
  write_png(folder.file("a.png"), {4, 2, std::vector<std::uint8_t>(24, 200)});
  write_text(folder.file("a.mtl"), "newmtl a\nmap_Kd a.png\n");
  write_text(folder.file("a.obj"),
             "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nusemtl a\nf 1/1 2/1 3/1\n");
  const ProcessResult result = plan_in(folder, "a.obj --folder=p --jobs=2 -o a.png");
  CHECK(result.exit_code == 1);
  CHECK(result.err.starts_with("twinray: a.png: "));
  CHECK_FALSE(fs::exists(folder.file("p")));
}

TEST_CASE("what a plan cannot be is said before anything is written") {
  CHECK(error_of("--jobs=3") == "twinray: --folder=DIR is missing");
  CHECK(error_of("--folder=p") == "twinray: --jobs or --part-minutes is needed, and not both");
  CHECK(error_of("--folder=p --jobs=3 --part-minutes=4") ==
        "twinray: --jobs or --part-minutes is needed, and not both");
  CHECK(error_of("--folder=p --jobs=3 --frames=3:1") == "twinray: --frames: 3 is more than 1");
  CHECK(error_of("--folder=p --jobs=3 --frames=3") == "twinray: --frames: \"3\" is no range, as 1:100 is");
  CHECK(error_of("--folder=p --jobs=3 --frames=1:2") ==
        "twinray: --frames: the picture's name needs a place for the number, as in \"%04d\"; twinray.png has "
        "none");
  for (const auto& [option, word] : {std::pair("--output=FILM", "-o a.film"),
                                     {"--replay", "--replay 1 1 1"},
                                     {"--replay", "--replay 1 1 1 --replay-json=a.json"},
                                     {"--accel=check", "--accel=check"},
                                     {"--convert-textures", "--convert-textures"},
                                     {"--checkpoint", "--checkpoint=a"}})
    CHECK(
        error_of(fmt::format("--folder=p --jobs=3 {}", word)) ==
        fmt::format("twinray: {}: a plan is for pictures alone, and makes films, checkpoints and their names "
                    "itself",
                    option));
  CHECK(
      error_of("--folder=p --jobs=3 -o a.xyz").starts_with("twinray: a.xyz: a picture's name must end in "));
  CHECK(
      error_of("--folder=p --jobs=3 --seconds=3") ==
      "twinray: a part has as many samples as the picture's others; --seconds, --until and --noise-target do "
      "not go with a plan");
  CHECK(error_of("--folder=p --jobs=3 --frames=1:2 -o f%d.png --seed=%dx") ==
        "twinray: --seed: \"1x\" is not a whole number from 0 to 18446744073709551615");
  CHECK(error_of("--folder=p --jobs=3 --stats=s.json") ==
        "twinray: --stats: all parts would write the same file; their films have samples, rays and seconds");
  CHECK(error_of("--folder=p --jobs=3 --frames=1:2 -o f%d.png --metrics-file=m%d") ==
        "twinray: --metrics-file: all parts would write the same file; their films have samples, rays and "
        "seconds");
  CHECK(error_of("--folder=p -s 100 --jobs=100 --frames=0:10000 -o f%d.png") ==
        "twinray: 10001 frames in 100 parts each are more than the 1000000 parts that a plan may have");
  for (const char* option : {"--serve", "--tev"})
    CHECK(error_of(fmt::format("--folder=p --jobs=3 {}", option)) ==
          fmt::format("twinray: {}: the parts of a plan are rendered many at a time; there is no growing "
                      "picture to show",
                      option));
  CHECK(error_of("--folder=/proc/p --jobs=3").starts_with("twinray: /proc/p: this folder cannot be made: "));
  CHECK(error_of("--folder=p --jobs=3 -o none/a.png") == "twinray: none/a.png: there is no folder none");
  CHECK(error_of("--folder='p{{x}}' --jobs=3").starts_with("twinray: --folder: a line's end ends a command"));
  CHECK(error_of("--folder='p\nx' --jobs=3").starts_with("twinray: --folder: a line's end ends a command"));
  CHECK(error_of("--folder=. --jobs=3") ==
        "twinray: .: it is there already; a plan needs a folder of its own");
}

TEST_CASE("a render with --resume goes on where there is a checkpoint, and begins where there is none") {
  const TemporaryFolder folder;
  const std::string words = fmt::format("{} -r 48 36 -q --checkpoint={} --resume -o {} ", quoted(box_scene),
                                        quoted(folder.file("a.ck")), quoted(folder.file("a.pfm")));
  CHECK(run_program(words + "-s 8").exit_code == 0);
  CHECK(run_program(words + "-s 8 --seed=1").err.find("it was made without --seed 1") != std::string::npos);
  CHECK(run_program(words + "-s 20").exit_code == 0);
  CHECK(
      run_program(fmt::format("{} -r 48 36 -q -s 20 -o {}", quoted(box_scene), quoted(folder.file("b.pfm"))))
          .exit_code == 0);
  CHECK(read_text(folder.file("a.pfm")) == read_text(folder.file("b.pfm")));
  CHECK(run_program(quoted(box_scene) + " --resume")
            .err.starts_with("twinray: --resume goes with --checkpoint, which says what to go on with\n"));
}

}  // namespace twinray::test
