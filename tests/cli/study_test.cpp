// SPDX-License-Identifier: Apache-2.0
// A whole study of small scenes, as a user makes it.
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <map>
#include <set>
#include <thread>

#include "cli/study/page.h"
#include "io/html/page.h"
#include "io/picture/image_file.h"
#include "tests/support/catch.h"
#include "tests/support/collada_text.h"
#include "tests/support/html.h"
#include "tests/support/own_scenes.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

namespace fs = std::filesystem;

const std::string own = TWINRAY_SOURCE_DIR "/scenes/";

/// A triangle below a point light.
std::string point_scene() {
  return collada_text(
      collada_triangle() +
          "<library_lights><light id=\"lamp\"><technique_common><point><color>1 1 1</color></point>"
          "</technique_common></light></library_lights>",
      collada_shape_node() + "<node><translate>0.3 0.3 1</translate><instance_light url=\"#lamp\"/></node>");
}

/// Two boxes and a point light, under the names that a study looks for.
class Scenes {
 public:
  Scenes() {
    fs::create_directories(folder_.path() / "scenes/sky");
    fs::copy_file(own + "box.dae", folder_.path() / "scenes/sky/CBbunny.dae");
    fs::copy_file(own + "spheres.dae", folder_.path() / "scenes/CBspheres_lambertian.dae");
    write_text(folder_.file("scenes/cow.dae"), point_scene());
  }
  /// The arguments of a study of them; what it writes is in file("study/...").
  std::string arguments(const std::string& more = "") const {
    return fmt::format("study '{}' --output '{}' --quick -r 8 6 -t 2 {}", file("scenes"), file("study"),
                       more);
  }
  std::string file(const std::string& name) const { return folder_.file(name); }
  std::string page() const { return read_text(file("study/index.html")); }

 private:
  TemporaryFolder folder_;
};

/// The time of writing of every picture's record that is there.
std::map<std::string, fs::file_time_type> records(const Scenes& scenes) {
  std::map<std::string, fs::file_time_type> all;
  for (const auto& entry : fs::directory_iterator(scenes.file("study/pictures")))
    if (entry.path().extension() == ".json") all[entry.path().stem()] = fs::last_write_time(entry.path());
  return all;
}

/// The page's part of a number, to the next one.
std::string part_of(const std::string& page, int number) {
  const std::size_t begin = page.find(fmt::format("<section id=\"part{}\">", number));
  return page.substr(begin, page.find("</section>", begin) - begin);
}

std::string error_of(const Scenes& scenes, const std::string& picture, const std::string& converged) {
  const auto image = [&](const std::string& name) {
    return read_image(scenes.file("study/pictures/" + name + ".exr"));
  };
  return study::error_text(study::shown_error(image(picture), image(converged)));
}

}  // namespace

TEST_CASE("a study without scenes makes no folder") {
  const TemporaryFolder folder;
  fs::create_directory(folder.file("empty"));
  for (const std::string scenes : {"nowhere", "empty"}) {
    const ProcessResult result =
        run_program(fmt::format("study {} -o {}", quoted(folder.file(scenes)), quoted(folder.file("study"))));
    CHECK(result.exit_code == 1);
    CHECK_FALSE(fs::exists(folder.file("study")));
  }
}

TEST_CASE("a study is one page with all parts that needs nothing else") {
  const Scenes scenes;
  write_text(scenes.file("notes.md"), "Hello.\n\n# Part 4: light\nIt *bounces*.\n");
  const ProcessResult result =
      run_program(scenes.arguments(fmt::format("--notes '{}'", scenes.file("notes.md"))));
  REQUIRE(result.exit_code == 0);
  CHECK(result.out.find("\n0 of ") != std::string::npos);
  CHECK(result.err.find(fmt::format("warning: part 5: not in {}: wall-e.dae\n", scenes.file("scenes"))) !=
        std::string::npos);
  CHECK(count(result.err, "adds nothing to the picture; --direct=lights would show it\n") == 1);
  CHECK(count(result.err, "no effect") == 0);
  const std::string page = scenes.page();
  CHECK(html_fault(page) == "");
  CHECK(html_load(page) == "");
  CHECK(page.find(">nan") == std::string::npos);
  CHECK(page.find("Not made yet") == std::string::npos);
  CHECK(part_of(page, 5).find("Not in the folder: wall-e.dae.") != std::string::npos);

  CHECK(count(part_of(page, 1), "<img ") == 3);
  CHECK(count(part_of(page, 2), ">without</td>") == 2);
  for (const char* split : {"sah", "median", "midpoint", "mean"})
    CHECK(count(part_of(page, 2), fmt::format("--bvh-split={}", split)) >= 2);
  for (const int samples : {1, 4, 16, 64})
    CHECK(count(part_of(page, 3), fmt::format("<td>-s 1 -l {}</td>", samples)) == 2);
  CHECK(count(part_of(page, 3), "<td>hemisphere, -s 16</td>") == 1);
  for (int depth = 0; depth <= 5; ++depth)
    CHECK(count(part_of(page, 4), fmt::format(": -m {}, the last bounce\"", depth)) == 2);
  for (const char* rule : {"0.3", "0.5", "0.7", "throughput"})
    CHECK(count(part_of(page, 4), fmt::format("<td>--roulette={}</td>", rule)) == 2);
  CHECK(count(part_of(page, 4), "<svg") == 1);
  CHECK(count(part_of(page, 5), "sample rates\"") == 4);

  // Errors are those of the linear pictures; no light at all is an error of about all light.
  const std::string samples = error_of(scenes, "CBbunny_m5_l4_s16", "CBbunny_converged_m5");
  CHECK(count(part_of(page, 4), fmt::format("<td>{}</td>", samples)) >= 1);
  CHECK(std::stod(error_of(scenes, "cow_direct_point_hemisphere_s16", "cow_direct_point_converged")) >= 100);

  CHECK(part_of(page, 4).find("</h2>\n<div class=\"notes\">\n<p>It <em>bounces</em>.</p>\n</div>") !=
        std::string::npos);
  CHECK(page.find("<p>Hello.</p>") < page.find("<section"));
}

TEST_CASE("the command beside a picture of a study makes the very file") {
  const Scenes scenes;
  REQUIRE(run_program(scenes.arguments("-q")).exit_code == 0);
  const std::string name = "CBspheres_lambertian_m5_l4_s8";
  const study::Record record =
      study::parse_record(read_text(scenes.file("study/pictures/" + name + ".json"))).value();
  const std::string& command = record.command;
  CHECK(count(scenes.page(), html::whole_words(command)) == 1);
  REQUIRE(command.starts_with("twinray render "));
  REQUIRE(run_shell(fmt::format("cd '{}' && '{}' {}", scenes.file("."), TWINRAY_PROGRAM, command.substr(8)))
              .exit_code == 0);
  CHECK(read_text(scenes.file(name + ".png")) == read_text(scenes.file("study/pictures/" + name + ".png")));
}

TEST_CASE(
    "a picture is made again where its file is gone or damaged, its command or scene another, and no other") {
  const Scenes scenes;
  REQUIRE(run_program(scenes.arguments("-q")).exit_code == 0);
  auto before = records(scenes);
  const std::string pictures = scenes.file("study/pictures/");
  fs::remove(pictures + "cow_normals.png");
  write_text(pictures + "CBbunny_m5_l4_s1.json", "{}");
  std::string other = read_text(pictures + "CBbunny_m5_l4_s2.json");
  other.replace(other.find("-s 2"), 4, "-s 3");
  write_text(pictures + "CBbunny_m5_l4_s2.json", other);
  write_text(pictures + "CBbunny_m5_l4_s4.png", "");
  write_text(pictures + "CBbunny_m5_l4_s8.exr", read_text(pictures + "CBbunny_m5_l4_s16.exr"));
  const std::set<std::string> damaged{"cow_normals", "CBbunny_m5_l4_s1", "CBbunny_m5_l4_s2",
                                      "CBbunny_m5_l4_s4", "CBbunny_m5_l4_s8"};
  const ProcessResult again = run_program(scenes.arguments());
  REQUIRE(again.exit_code == 0);
  CHECK(again.out.starts_with(fmt::format(
      "1 of {} pictures are there, but are made again: their command (with -t, ", before.size())));
  CHECK(again.out.find(fmt::format("\n{} of {} pictures", before.size() - damaged.size(), before.size())) !=
        std::string::npos);
  for (const auto& [name, time] : records(scenes)) {
    INFO(name);
    CHECK((time != before.at(name)) == damaged.contains(name));
  }
  before = records(scenes);
  write_text(scenes.file("scenes/cow.dae"), point_scene() + "<!-- changed -->\n");
  REQUIRE(run_program(scenes.arguments("-q")).exit_code == 0);
  for (const auto& [name, time] : records(scenes))
    CHECK((time != before.at(name)) == name.starts_with("cow_"));
}

TEST_CASE("a study that was killed goes on where it was, and its page is that of one that was not") {
  const Scenes scenes;
  const std::string command =
      fmt::format("exec '{}' {}", TWINRAY_PROGRAM, scenes.arguments("-q 2>/dev/null"));
  const char* const words[] = {"sh", "-c", command.c_str(), nullptr};
  pid_t child = 0;
  REQUIRE(posix_spawn(&child, "/bin/sh", nullptr, nullptr, const_cast<char* const*>(words), environ) == 0);
  while (!fs::exists(scenes.file("study/pictures/CBbunny_normals_sah.json")) &&
         waitpid(child, nullptr, WNOHANG) == 0)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  const auto before = records(scenes);
  REQUIRE(before.size() >= 4);
  const ProcessResult result = run_program(scenes.arguments());
  REQUIRE(result.exit_code == 0);
  CHECK(html_fault(scenes.page()) == "");
  CHECK(scenes.page().find("Not made yet") == std::string::npos);
  const auto after = records(scenes);
  for (const auto& [name, time] : before) CHECK(after.at(name) == time);
}

TEST_CASE("a scene that cannot be read is named, and ends a study of the others with 1") {
  const Scenes scenes;
  fs::copy_file(TWINRAY_SOURCE_DIR "/tests/bad/nan.dae", scenes.file("scenes/teapot.dae"));
  const ProcessResult result = run_program(scenes.arguments("-q"));
  CHECK(result.exit_code == 1);
  CHECK(result.err.find(fmt::format("warning: {}: left out, for it cannot be read:\n",
                                    scenes.file("scenes/teapot.dae"))) != std::string::npos);
  CHECK(scenes.page().find("These scenes cannot be read:") != std::string::npos);
  CHECK(count(part_of(scenes.page(), 1), "<img ") == 3);
}

TEST_CASE("a study of a folder that may not be read says so") {
  const TemporaryFolder folder;
  const std::string closed = folder.file("closed");
  fs::create_directories(closed + "/inner");
  fs::copy_file(box_scene, closed + "/inner/box.dae");
  fs::permissions(closed, fs::perms::none);
  for (const std::string& name : {closed, closed + "/inner"}) {
    const ProcessResult result =
        run_shell(without_rights() +
                  fmt::format("'{}' study '{}' --output '{}'", TWINRAY_PROGRAM, name, folder.file("study")));
    CHECK(result.exit_code == 1);
    CHECK(result.err == fmt::format("twinray: {}: this folder cannot be read: Permission denied\n", name));
  }
  fs::permissions(closed, fs::perms::owner_all);
  CHECK(folder.file_count() == 1);
}

TEST_CASE("what a study cannot begin with is said before anything is rendered") {
  const TemporaryFolder folder;
  const auto says = [&](const std::string& arguments, int code, const std::string& message) {
    const ProcessResult result = run_program("study " + arguments);
    INFO(result.err);
    CHECK(result.exit_code == code);
    CHECK(result.err.find(message) == 0);
  };
  const auto quoted = [&](const std::string& name) { return fmt::format("'{}'", folder.file(name)); };
  const std::string scenes = fmt::format("'{}'", own), output = " --output " + quoted("study");
  says("", 2, "twinray: FOLDER is missing\nusage: twinray study FOLDER --output DIR");
  says(scenes, 2, "twinray: --output is missing: the folder that page and pictures go to\n");
  says(scenes + " --quick --full" + output, 2, "twinray: --quick and --full exclude each other\n");
  says(quoted("none") + output, 1,
       fmt::format("twinray: {}: there is no such folder\n", folder.file("none")));
  fs::create_directory(folder.file("empty"));
  says(quoted("empty") + output, 1,
       fmt::format("twinray: {}: no COLLADA scene (.dae) is in this folder or below it\n",
                   folder.file("empty")));
  says(fmt::format("{} --output {}", scenes, quoted("a/b")), 1,
       fmt::format("twinray: {}: this folder cannot be made: No such file or directory\n",
                   folder.file("a/b")));
  write_text(folder.file("taken"), "");
  says(fmt::format("{} --output {}", scenes, quoted("taken")), 1,
       fmt::format("twinray: {}: this folder cannot be made: there is a file of that name\n",
                   folder.file("taken")));
  says(scenes + " --notes none.md" + output, 1, "twinray: none.md: there is no such file\n");
}

}  // namespace twinray::test
