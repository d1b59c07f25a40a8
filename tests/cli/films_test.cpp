// SPDX-License-Identifier: Apache-2.0
// Parts, merging and films that go on, as a user sees them.
#include <fmt/format.h>

#include <filesystem>
#include <thread>

#include "io/picture/image_file.h"
#include "io/picture/layered_image.h"
#include "tests/support/arguments.h"
#include "tests/support/film_commands.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/terminal.h"
#include "tests/support/text.h"

namespace twinray::test {
namespace {

namespace fs = std::filesystem;

}  // namespace

TEST_CASE("ranges of samples and tiles merge to the picture of one render, whatever engine made them") {
  const TemporaryFolder folder;
  const auto film = [&](const std::string& name) { return quoted(folder.file(name)); };
  const std::string scene = "-s 21 --layers=normal,cryptomatte-object,ids --denoise=own";
  run_well(box_words(scene + " -o " + film("whole.exr")));
  run_well(box_words(scene + " --sample-range=0:8 -t 1 -o " + film("a.film")));
  run_well(box_words(scene + " --sample-range=8:9 --accel=brute-force -o " + film("b.film")));
  run_well(box_words(scene + " --sample-range=9:21 --of=21 --accel=bvh --bvh-width=2 -o " + film("c.film")));
  run_well("merge -q " + film("c.film") + " " + film("a.film") + " " + film("b.film") + " -o " +
           film("m.exr"));
  const StoredLayers whole = read_layers(folder.file("whole.exr"));
  CHECK(read_layers(folder.file("m.exr")).values == whole.values);
  run_well(box_words(scene + " -a 8 0.3 -o " + film("adaptive.exr")));
  for (int i = 0; i < 3; ++i)
    run_well(box_words(fmt::format("{} -a 8 0.3 --tile-range={}:{} -o {}", scene, 3 * i, 3 * i + 3,
                                   film(fmt::format("tiles{}.film", i)))));
  run_well("merge -q " + film("tiles1.film") + " " + film("tiles0.film") + " " + film("tiles2.film") +
           " -o " + film("tiles.exr"));
  CHECK(read_layers(folder.file("tiles.exr")).values == read_layers(folder.file("adaptive.exr")).values);
  const auto rates = [&](const char* name) { return read_image(folder.file(name)).pixels; };
  CHECK(rates("tiles_rate.png") == rates("adaptive_rate.png"));
}

TEST_CASE("a picture names all engines that made it, also where one went on with what another began") {
  const TemporaryFolder folder;
  const auto file = [&](const std::string& name) { return quoted(folder.file(name)); };
  const auto engines_in = [&](const char* name) {
    const std::string bytes = read_text(folder.file(name)), key("twinray:engine\0string\0", 22);
    const std::size_t begin = bytes.find(key);  // Four bytes of its length, and the text.
    REQUIRE(begin != std::string::npos);
    const auto length = std::size_t(static_cast<unsigned char>(bytes[begin + key.size()]));
    return bytes.substr(begin + key.size() + 4, length);
  };
  run_well(box_words("-s 4 --accel=bvh --checkpoint=" + file("a.ck") + " -o " + file("a.exr")));
  CHECK(engines_in("a.exr") == "bvh");
  run_well("resume " + file("a.ck") + " -q -s 8 --accel=brute-force");
  CHECK(engines_in("a.exr") == "brute-force, bvh");
  run_well("resume " + file("a.ck") + " -q -s 12 --accel=bvh");
  CHECK(engines_in("a.exr") == "brute-force, bvh");
  run_well("verify -q " + file("a.exr"));
  run_well("merge -q " + file("a.ck") + " -o " + file("merged.exr"));
  CHECK(engines_in("merged.exr") == "brute-force, bvh");
}

TEST_CASE("films merge in steps, and a merged film takes more samples") {
  const TemporaryFolder folder;
  const auto film = [&](const std::string& name) { return quoted(folder.file(name)); };
  for (int i = 0; i < 4; ++i)
    run_well(box_words(fmt::format("--sample-range={}:{} --of=16 -o {}", 4 * i, 4 * i + 4,
                                   film(fmt::format("{}.film", i)))));
  run_well("merge -q " + film("1.film") + " " + film("0.film") + " -o " + film("01.film"));
  const ProcessResult later =
      run_program("merge " + film("2.film") + " " + film("3.film") + " -o " + film("23.film"));
  CHECK(later.exit_code == 0);
  CHECK(later.err.empty());
  CHECK(later.out.find("\nNot in it      samples 0:8 of 16\n") != std::string::npos);
  // In either order: what was missing before is not missing any more.
  for (const auto& [first, second] : {std::pair("23.film", "01.film"), std::pair("01.film", "23.film")}) {
    run_well("merge -q " + film(first) + " " + film(second) + " -o " + film("all.film"));
    run_well("merge -q " + film(first) + " " + film(second) + " -o " + film("all.png"));
    CHECK(run_program("verify -q " + film("all.png")).exit_code == 0);
  }
  const Words& said = open_film(folder.file("all.film")).notes.words;
  CHECK(std::count(said.begin(), said.end(), "--samples") == 1);
  CHECK(std::count(said.begin(), said.end(), "-s") == 0);
  run_well("resume " + film("all.film") + " -q -s 40 -o " + film("a.pfm"));
  run_well(box_words("-s 40 -o " + film("b.pfm")));
  CHECK(read_text(folder.file("a.pfm")) == read_text(folder.file("b.pfm")));
}

TEST_CASE(
    "a film goes on where it is, and keeps what there is of a picture, without a checkpoint of its own") {
  const TemporaryFolder folder;
  const auto film = [&](const std::string& name) { return quoted(folder.file(name)); };
  run_well(box_words("-s 4 -o " + film("a.film")));
  fs::rename(folder.file("a.film"), folder.file("b.film"));
  run_well("resume " + film("b.film") + " -q -s 6");
  CHECK_FALSE(fs::exists(folder.file("a.film")));
  CHECK(samples_in(folder.file("b.film")) == 6);
  run_well("resume " + film("b.film") + " -q -s 9 -o " + film("p.pfm"));
  CHECK(samples_in(folder.file("b.film")) == 9);
  run_well("resume " + film("b.film") + " -q -s 11 -o " + film("b.film"));
  run_well("resume " + film("b.film") + " -q -s 12 --checkpoint=" + film("c.ck") + " -o " + film("p.pfm"));
  CHECK(samples_in(folder.file("b.film")) == 11);
  CHECK(samples_in(folder.file("c.ck")) == 12);
  run_well(box_words("-s 12 -o " + film("q.pfm")));
  CHECK(read_text(folder.file("p.pfm")) == read_text(folder.file("q.pfm")));
}

TEST_CASE("a sample of a film is replayed without a word of the options of its picture") {
  const TemporaryFolder folder;
  const auto film = [&](const std::string& name) { return quoted(folder.file(name)); };
  run_well(box_words("-s 2 -t 1 --strict --checkpoint=" + film("a.ck") + " -o " + film("a.png")));
  const ProcessResult replayed = run_program("resume " + film("a.ck") + " --replay 3 4 1");
  CHECK(replayed.exit_code == 0);
  CHECK(replayed.err.empty());
  CHECK(replayed.out.find("Pixel 3 4, sample 1") != std::string::npos);
}

TEST_CASE("a list names more films than a command line has room for") {
  const TemporaryFolder folder;
  const auto film = [&](const std::string& name) { return quoted(folder.file(name)); };
  run_well(box_words("--sample-range=0:1 --of=3 -o " + film("a.film")));
  run_well(box_words("--sample-range=1:2 --of=3 -o " + film("b.film")));
  run_well(box_words("--sample-range=2:3 --of=3 -o " + film("c.film")));
  run_well(box_words("-s 3 -o " + film("x.pfm")));
  write_text(folder.file("list"), folder.file("b.film") + "\r\n\n" + folder.file("c.film"));
  run_well(fmt::format("merge -q {} @{} -o {}", film("a.film"), film("list"), film("y.pfm")));
  CHECK(read_text(folder.file("y.pfm")) == read_text(folder.file("x.pfm")));
  write_text(folder.file("list"), "\n");
  const auto error = [&](const std::string& list) {
    return told_error(fmt::format("merge @{} -o {}", film(list), film("z.pfm")));
  };
  check_says(error("list"), folder.file("list") + ": this list names no film");
  check_says(error("none"), folder.file("none") + ": there is no such file");
  write_text(folder.file("list"), "none.film");
  check_says(error("list"), "none.film: there is no such file");
}

TEST_CASE("films that are no parts of one render are refused by name") {
  const TemporaryFolder folder;
  const auto film = [&](const std::string& name) { return quoted(folder.file(name)); };
  const auto part = [&](const std::string& name, const std::string& more) {
    run_well(box_words(more + " -o " + film(name + ".film")));
  };
  const auto merge = [&](const std::string& names) {
    std::string all = "merge";
    for (const char name : names)
      if (name != ' ') all += " " + film(std::string(1, name) + ".film");
    return told_error(all + " -o " + film("x.pfm"));
  };
  part("a", "--sample-range=0:4 --of=8");
  part("b", "--sample-range=4:8 --of=8");
  part("c", "--sample-range=4:8 --of=8 --seed=1");
  part("d", "--sample-range=2:6 --of=8");
  part("e", "--sample-range=4:8 --of=9");
  part("f", "--sample-range=6:8 --of=8");
  part("g", "--tile-range=0:3 --of=8");
  part("h", "--sample-range=4:8 --of=8 --denoise=own");
  run_well(quoted(TWINRAY_SOURCE_DIR "/scenes/spheres.dae") + " -r 48 36 -q --sample-range=4:8 --of=8 -o " +
           film("i.film"));
  run_well(quoted(box_scene) + " -r 48 35 -q --sample-range=4:8 --of=8 -o " + film("j.film"));
  const std::string a = folder.file("a.film") + ": ", go = ": it does not go with " + a;
  check_says(merge("ac"), folder.file("c.film") + go + "it was made with --seed 1");
  check_says(merge("ad b"), folder.file("a.film") + " and " + folder.file("d.film") +
                                " overlap: samples 0:4 of 8, and samples 2:6 of 8");
  check_says(merge("ae"), folder.file("e.film") + go + "it is of 9 samples a pixel, and of 8 there");
  check_says(merge("a"), "samples 4:8 of 8 are missing; --allow-gaps merges what there is");
  check_says(merge("af"), "samples 4:6 of 8 are missing");
  check_says(merge("ag"), folder.file("g.film") + go + "one is a range of tiles, the other one of samples");
  check_says(merge("ah"), folder.file("h.film") + go + "one has halves of the samples, or other layers");
  check_says(merge("ai"),
             folder.file("i.film") + go + "its scene reads spheres.dae, which is not read there");
  check_says(merge("aj"), folder.file("j.film") + go + "its --resolution is 48 35, and 48 36 there");
  check_says(told_error("merge " + film("a.film")), "--output=FILE is missing");
  check_says(told_error("merge -o " + film("x.pfm")), "FILM is missing");
  const ProcessResult twice = run_program("merge -q " + film("a.film") + " " + film("b.film") + " " +
                                          film("a.film") + " -o " + film("x.pfm"));
  CHECK(twice.exit_code == 0);
  check_says(twice.err, a + "the same samples as in another film; they count once");
  run_well(box_words("-s 8 -o " + film("y.pfm")));
  CHECK(read_text(folder.file("x.pfm")) == read_text(folder.file("y.pfm")));
  const ProcessResult gap =
      run_program("merge -q --allow-gaps " + film("a.film") + " " + film("f.film") + " -o " + film("x.png"));
  CHECK(gap.exit_code == 0);
  check_says(gap.err, "samples 4:6 of 8 are missing");
  check_says(read_text(folder.file("x.png")), "twinray:missing");
  check_says(
      told_error("merge --allow-gaps " + film("a.film") + " " + film("f.film") + " -o " + film("x.film")),
      "x.film: samples 4:6 of 8 are missing amid it; a film is of a range without gaps");
}

TEST_CASE("the options of the first film make the picture, and a warning says what is different in others") {
  const TemporaryFolder folder;
  const auto film = [&](const std::string& name) { return quoted(folder.file(name)); };
  run_well(box_words("--sample-range=0:4 --of=8 --exposure=2 --tone=srgb -o " + film("a.film")));
  run_well(box_words("--sample-range=4:6 --of=8 --exposure=0 --tone=agx -o " + film("b.film")));
  run_well(box_words("--sample-range=6:8 --of=8 --exposure=2 -o " + film("c.film")));
  const auto merge = [&](const std::string& names) {
    std::string all = "merge -q";
    for (const char name : names) all += " " + film(std::string(1, name) + ".film");
    const ProcessResult result = run_program(all + " -o " + film("m.png"));
    CHECK(result.exit_code == 0);
    return result.err;
  };
  const std::string a = folder.file("a.film"), b = folder.file("b.film"), c = folder.file("c.film");
  CHECK(merge("abc") ==
        fmt::format("warning: {}: it was made with --tone agx; the options of {} make the picture\n", b, a));
  run_well(box_words("-s 8 --exposure=2 -o " + film("whole.png")));
  CHECK(read_image(folder.file("m.png")).pixels == read_image(folder.file("whole.png")).pixels);
  const auto warning = [&](const std::string& name) {
    return fmt::format("warning: {}: it was made with --exposure 2; the options of {} make the picture\n",
                       name, b);
  };
  CHECK(merge("bac") == warning(a) + warning(c));
}

TEST_CASE("an option whose value is its default changes no samples: films go with it and without it") {
  const TemporaryFolder folder;
  const auto film = [&](const std::string& name) { return quoted(folder.file(name)); };
  run_well(box_words("--sample-range=0:4 --of=8 --seed=0 --roulette=throughput -o " + film("a.film")));
  run_well(box_words("--sample-range=4:8 --of=8 --sampler=sobol -o " + film("b.film")));
  run_well("merge -q " + film("a.film") + " " + film("b.film") + " -o " + film("m.pfm"));
  run_well(box_words("-s 8 --checkpoint=" + film("a.ck") + " -o " + film("w.pfm")));
  CHECK(read_text(folder.file("m.pfm")) == read_text(folder.file("w.pfm")));
  run_well("resume " + film("a.ck") + " -q --seed=0 -s 9");
  check_says(told_error("resume " + film("a.ck") + " -q --seed=1"), "it was made without --seed 1");
}

TEST_CASE("the groups of lights of a film may be said again, and no others") {
  const TemporaryFolder folder;
  const std::string film = quoted(folder.file("a.film")), groups = "--light-group=a=sun --light-group=b=spot";
  run_well(quoted(TWINRAY_SOURCE_DIR "/scenes/lights.dae") +
           " -r 24 18 -q -s 2 --layers=light-groups --light-group=a=sun --light-group=b=spot -o " + film);
  run_well("resume " + film + " -q -s 3 " + groups);
  CHECK(samples_in(folder.file("a.film")) == 3);
  run_well("resume " + film + " -q -s 4");
  CHECK(samples_in(folder.file("a.film")) == 4);
  check_says(told_error("resume " + film + " -q -s 5 --light-group=a=sun"), "--light-group");
}

TEST_CASE("films of another triangle test go with films of the same engine alone") {
  const TemporaryFolder folder;
  const auto part = [&](const std::string& name, const std::string& words) {
    const ProcessResult result = run_program(box_words(words + " --of=8 -o " + quoted(folder.file(name))));
    CHECK(result.exit_code == 0);
    CHECK(result.err.empty() == contains(words, "--accel=bvh"));  // That the test has no effect.
  };
  const auto merge = [&](const std::string& first, const std::string& second) {
    return fmt::format("merge -q {} {} -o {}", quoted(folder.file(first)), quoted(folder.file(second)),
                       quoted(folder.file("m.pfm")));
  };
  const std::string own_test = " --triangle-test=moller-trumbore";
  part("a.film", "--sample-range=0:4 --accel=bvh" + own_test);
  part("b.film", "--sample-range=4:8 --accel=bvh" + own_test);
  part("c.film", "--sample-range=4:8 --accel=brute-force" + own_test);
  part("d.film", "--sample-range=0:4 --accel=bvh");
  run_well(merge("a.film", "b.film"));
  check_says(told_error(merge("a.film", "c.film")), "--accel bvh");
  check_says(told_error(merge("d.film", "b.film")), "it does not go with");
  run_well(merge("d.film", "c.film"));  // Both by the usual test.
}

TEST_CASE("films of path and of path-reference merge and go on, with the name of the first") {
  const TemporaryFolder folder;
  const auto film = [&](const std::string& name) { return quoted(folder.file(name)); };
  const auto part = [&](const std::string& name, const std::string& more) {
    run_well(box_words("--of=8 --layers=normal,light " + more + " -o " + film(name)));
  };
  part("a.film", "--sample-range=0:4 --integrator=path-reference");
  part("b.film", "--sample-range=4:8");
  part("c.film", "--sample-range=4:8 --integrator=path");
  run_well(box_words("-s 8 --layers=normal,light -o " + film("whole.exr")));
  for (const auto& [first, second] : {std::pair("a.film", "b.film"), {"c.film", "a.film"}}) {
    run_well(fmt::format("merge -q {} {} -o {}", film(first), film(second), film("m.exr")));
    const StoredLayers merged = read_layers(folder.file("m.exr"));
    CHECK(merged.values == read_layers(folder.file("whole.exr")).values);
    const std::string options = value_of(merged.metadata, "twinray:options");
    CHECK((options.find("--integrator=path-reference") != options.npos) == (first[0] == 'a'));
  }
  for (const auto& [begun, further] : {std::pair("path-reference", "path"), {"path", "path-reference"}}) {
    const std::string checkpoint = film(std::string(begun) + ".ck");
    const auto words = [&](int samples, const char* integrator) {
      return box_words(fmt::format("-s {} --integrator={} --checkpoint={} --resume -o {}", samples,
                                   integrator, checkpoint, film("r.pfm")));
    };
    run_well(words(4, begun));
    run_well(words(8, further));
    run_well(box_words("-s 8 -o " + film("w.pfm")));
    CHECK(read_text(folder.file("r.pfm")) == read_text(folder.file("w.pfm")));
  }
  part("d.film", "--sample-range=4:8 --integrator=direct");
  check_says(told_error(fmt::format("merge {} {} -o {}", film("a.film"), film("d.film"), film("x.exr"))),
             "it was made with --integrator direct");
}

TEST_CASE("films with layers make no picture that cannot hold them, as a render does not") {
  const TemporaryFolder folder;
  const auto film = [&](const std::string& name) { return quoted(folder.file(name)); };
  run_well(box_words("-s 2 --layers=normal -o " + film("a.film")));
  const std::string reason = "--layers: " + folder.file("a.png") + " cannot hold layers; ";
  check_says(told_error(box_words("-s 2 --layers=normal -o " + film("a.png"))), reason);
  check_says(told_error(fmt::format("merge {} -o {}", film("a.film"), film("a.png"))), reason);
  check_says(told_error(fmt::format("resume {} -s 4 -o {}", film("a.film"), film("a.png"))), reason);
  CHECK_FALSE(fs::exists(folder.file("a.png")));
}

TEST_CASE("where a scene file says how deep paths are, the default of --max-depth is an option like others") {
  const TemporaryFolder folder;
  const std::string scene = folder.file("a.pbrt"), film = quoted(folder.file("a.ck"));
  write_text(scene,
             "Integrator \"path\" \"integer maxdepth\" 3\nFilm \"rgb\" \"integer xresolution\" 8\n"
             "WorldBegin\nLightSource \"infinite\"\nShape \"sphere\"\n");
  run_well(quoted(scene) + " -q -s 2 --checkpoint=" + film + " -o " + quoted(folder.file("a.pfm")));
  const std::string depth = std::to_string(PathOptions{}.max_depth);
  check_says(told_error("resume " + film + " -q --max-depth=" + depth),
             "it was made without --max-depth " + depth);
}

TEST_CASE("a render that was begun without --denoise does not take it up") {
  const TemporaryFolder folder;
  const std::string film = quoted(folder.file("a.ck"));
  run_well(
      box_words("-s 16 --noise-target=1e-5 --checkpoint=" + film + " -o " + quoted(folder.file("a.png"))));
  check_says(
      told_error("resume " + film + " -q -s 20 --denoise=own"),
      "its halves have other layers; --denoise and --denoise-light-groups go with a render's beginning");
  run_well(box_words("-s 16 --denoise=own --checkpoint=" + film + " -o " + quoted(folder.file("a.png"))));
  run_well("resume " + film + " -q -s 20 --noise-target=1e-5");
}

TEST_CASE("a checkpoint of another scene, option or file does not go on") {
  const TemporaryFolder folder;
  const std::string scene = folder.file("scene.dae"), film = quoted(folder.file("a.ck"));
  fs::copy(box_scene, scene);
  run_well(quoted(scene) + " -r 48 36 -q -s 4 --max-depth=3 --checkpoint=" + film + " -o " +
           quoted(folder.file("a.pfm")));
  const std::string go = folder.file("a.ck") + ": this film cannot go on here: ";
  const auto resume = [&](const std::string& more) { return told_error("resume " + film + " " + more); };
  check_says(resume("--max-depth=4"), go + "its --max-depth is 3, and 4 here");
  check_says(resume("--filter=box"), go + "it was made without --filter box");
  check_says(resume("--sample-range=0:2 -o x.film"),
             go + "it has samples 0:4 of 4, and samples 0:2 of 4 are wanted here");
  check_says(resume("-s 1"),
             go + "it is of 4 samples a pixel, and of 1 here: the one sample of a pixel lies in its middle");
  check_says(resume("-s 2"), "4 samples of a pixel are there already, and 2 are wanted");
  check_says(
      resume("--denoise=own"),
      folder.file("a.ck") + ": it has no halves of the samples, which --denoise and --noise-target need");
  check_says(resume("--accel=check"),
             "--accel=check compares all rays of one render: it makes and resumes no films");
  check_says(resume("--nonsense"), "there is no option --nonsense");
  run_well("resume " + film + " -q --exposure=1 --accel=brute-force -o " + quoted(folder.file("b.png")));
  write_text(scene, read_text(scene) + "\n");
  check_says(resume("-q"), go + "scene.dae is another file here");
  fs::remove(scene);
  check_says(resume("-q"),
             scene + ": there is no such file; the render was begun in " + fs::current_path().string());
}

TEST_CASE("pictures on surfaces belong to a film, which may get more samples") {
  const TemporaryFolder folder;
  Image picture(2, 2);
  picture.pixels = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  write_image(folder.file("p.png"), picture);
  write_text(folder.file("a.pbrt"), R"(LookAt 0 0 3  0 0 0  0 1 0
Camera "perspective" "float fov" 40
Film "rgb" "integer xresolution" 24 "integer yresolution" 18
WorldBegin
LightSource "infinite"
Texture "p" "spectrum" "imagemap" "string filename" "p.png"
Material "diffuse" "texture reflectance" "p"
Shape "bilinearmesh" "point3 P" [-1 -1 0  1 -1 0  -1 1 0  1 1 0]
)");
  const std::string film = quoted(folder.file("a.ck")), to = " -q -o " + quoted(folder.file("a.pfm")) + " ";
  run_well(quoted(folder.file("a.pbrt")) + to + "-s 8 --checkpoint=" + film);
  run_well("resume " + film + to + "-s 16");
  run_well(quoted(folder.file("a.pbrt")) + " -q -s 16 -o " + quoted(folder.file("b.pfm")));
  CHECK(read_text(folder.file("a.pfm")) == read_text(folder.file("b.pfm")));
  picture.pixels[0] = {1, 1, 0};
  write_image(folder.file("p.png"), picture);
  check_says(told_error("resume " + film + to), "this film cannot go on here: p.png is another file here");
}

TEST_CASE("what a part or a checkpoint cannot be is said before it is begun") {
  CHECK(message_of({"--sample-range=0:4"}) ==
        "--sample-range: a part of a picture is kept as a film, to be merged; twinray.png does not end in "
        ".film");
  CHECK(message_of({"--sample-range=4", "-o", "a.film"}) == "--sample-range: \"4\" is no range, as 0:16 is");
  CHECK(message_of({"--sample-range=4:4", "-o", "a.film"}) == "--sample-range: 4 is not less than 4");
  CHECK(message_of({"--tile-range=1:-4", "-o", "a.film"})
            .starts_with("--tile-range: \"-4\" is not a whole number"));
  CHECK(message_of({"--sample-range=0:4", "--tile-range=0:4", "-o", "a.film"}) ==
        "--sample-range and --tile-range exclude each other");
  CHECK(message_of({"--sample-range=0:4", "-a", "8", "0.1", "-o", "a.film"}) ==
        "--sample-range: --adaptive looks at all samples of a pixel; --tile-range goes with it");
  for (const char* part : {"--sample-range=0:4", "--tile-range=0:4"}) {
    const std::string text = part;
    CHECK(message_of({part, "--allocation=error", "-o", "a.film"}) ==
          text.substr(0, text.find('=')) +
              ": --allocation=error looks at the whole picture, and has no parts");
  }
  CHECK(message_of({"--sample-range=0:4", "--seconds=3", "-o", "a.film"}) ==
        "--sample-range: a part has as many samples as the picture's others; --seconds and --noise-target do "
        "not go "
        "with it");
  CHECK(message_of({"--of=8", "-s", "9"}) == "--of: 8 samples, and --samples says 9");
  CHECK(parse({"--of=8"}).render.samples == 8);
  check_says(told_error(box_words("--checkpoint=/dev/null")),
             "/dev/null: a checkpoint is a file that can be replaced and read again");
  CHECK(parse({"--layers=albedo", "-o", "a.film"}).render.layers.size() == 2);
  CHECK(parse({"--checkpoint-seconds=3"}).without_effect ==
        std::vector<std::string>{"--checkpoint-seconds: no effect, for there is no --checkpoint"});
}

TEST_CASE("a checkpoint that cannot be written is a warning, the render goes on, and ends with 1") {
  const TemporaryFolder folder;
  // Room for the picture and not for the film.
  const ProcessResult result =
      run_program(box_words(fmt::format("-s 256 --checkpoint={} --checkpoint-seconds=0.01 -o {}",
                                        quoted(folder.file("a.ck")), quoted(folder.file("a.png")))),
                  "ulimit -f 16;");
  CHECK(result.exit_code == 1);  // The last one was not written either.
  // A slow machine has written one before, of a few samples. No other file is left.
  check_says(result.err,
             "warning: no checkpoint: " + folder.file("a.ck") + ": cannot be written: File too large; " +
                 (fs::exists(folder.file("a.ck")) ? "the one before is as it was" : "there is none"));
  std::size_t kept = 0;
  for (const char* name : {"a.png", "a.ck", "a.ck.before"}) kept += fs::exists(folder.file(name));
  CHECK(folder.file_count() == kept);
  CHECK(fs::exists(folder.file("a.png")));
}

}  // namespace twinray::test
