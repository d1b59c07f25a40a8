// SPDX-License-Identifier: Apache-2.0
// What a study is made of, before anything is rendered.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "cli/study/plan.h"
#include "cli/study/record.h"
#include "tests/support/catch.h"
#include "tests/support/own_scenes.h"
#include "tests/support/temporary_folder.h"

namespace twinray::study {
namespace {

namespace fs = std::filesystem;

/// A folder of these scenes, none of which has a file; those called "point" have only point lights.
SceneFolder folder_of(const std::vector<std::string>& names) {
  SceneFolder folder{"scenes", {}, {}};
  for (const std::string& name : names) folder.scenes.push_back({name, name + ".dae", 12, name == "point"});
  return folder;
}

const SceneFolder whole = folder_of({"CBbunny", "CBcoil", "CBdragon", "CBgems", "CBlucy", "CBspheres",
                                     "CBspheres_lambertian", "banana", "building", "bunny", "cow", "dragon",
                                     "maxplanck", "peter", "point", "teapot", "wall-e"});

/// Scene, samples and options of every picture of a part, as words.
std::vector<std::string> orders(const Part& part) {
  std::vector<std::string> all;
  for (const Picture& picture : pictures_of(part))
    all.push_back(fmt::format("{} -s {} {}{}{}", picture.scene, picture.samples,
                              fmt::join(picture.options, " "), picture.adaptive.empty() ? "" : " ",
                              fmt::join(picture.adaptive, " ")));
  return all;
}

/// Those of the wanted orders that a part does not have.
std::vector<std::string> missing(const Part& part, const std::vector<std::string>& wanted) {
  const std::vector<std::string> all = orders(part);
  std::vector<std::string> lost;
  for (const std::string& order : wanted)
    if (std::find(all.begin(), all.end(), order) == all.end()) lost.push_back(order);
  return lost;
}

const std::vector<std::string> none;

}  // namespace

TEST_CASE("scenes of one name in several folders have names of their own, and pictures by these") {
  const test::TemporaryFolder files;
  const std::vector<std::string> paths{"a/b/cow.dae", "a/cow.dae", "a_b/cow.dae", "cow.dae"};
  for (const std::string& path : paths) {
    fs::create_directories(fs::path(files.file(path)).parent_path());
    fs::copy_file(test::box_scene, files.file(path));
  }
  std::vector<std::string> names;
  for (const FoundScene& scene : read_scene_folder(files.path().string()).scenes) names.push_back(scene.name);
  CHECK(names == std::vector<std::string>{"cow", "a_cow", "a_b_cow", "cow_2"});
  fs::create_directories(files.file("d"));
  fs::copy_file(test::box_scene, files.file("d/COW_2.dae"));
  CHECK(pictures_of(plan_rays({read_scene_folder(files.path().string()), full})).size() == paths.size() + 1);
}

TEST_CASE("part 1 shades the normals of every scene") {
  const Part part = plan_rays({whole, full});
  CHECK(pictures_of(part).size() == whole.scenes.size());
  CHECK(missing(part, {"cow.dae -s 16 --integrator=normals", "wall-e.dae -s 16 --integrator=normals"}) ==
        none);
  CHECK(part.missing.empty());
}

TEST_CASE("part 2 has the large models, cow without and with a hierarchy, and every split") {
  const Part part = plan_hierarchy({whole, full});
  for (const char* scene : {"maxplanck", "CBlucy", "dragon", "wall-e", "building", "peter"})
    CHECK(missing(part, {fmt::format("{}.dae -s 16 --integrator=normals", scene)}) == none);
  CHECK(missing(part, {"cow.dae -s 1 --integrator=normals --accel=brute-force",
                       "cow.dae -s 1 --integrator=normals --accel=bvh"}) == none);
  for (const char* split : {"sah", "median", "midpoint", "mean"})
    CHECK(missing(part, {fmt::format(
                            "CBlucy.dae -s 16 --integrator=normals --accel=bvh --bvh-width=2 --bvh-split={}",
                            split)}) == none);
  CHECK(part.sections[2].figures.front().label == "sah");  // what the others are compared with
}

TEST_CASE("part 3 compares both estimators, a point light and light samples, each with a converged picture") {
  const Part part = plan_direct_light({whole, full});
  for (const char* scene : {"CBbunny", "CBspheres_lambertian"})
    for (const char* options :
         {"-s 16 -m 1 -l 8 -H", "-s 16 -m 1 -l 8", "-s 64 -m 1 -l 32 -H", "-s 64 -m 1 -l 32"})
      CHECK(missing(part, {fmt::format("{}.dae {}", scene, options)}) == none);
  CHECK(missing(part, {"point.dae -s 16 -m 1 -H", "point.dae -s 16 -m 1"}) == none);
  for (const char* scene : {"CBbunny", "CBspheres_lambertian", "dragon"})
    for (const int count : {1, 4, 16, 64})
      CHECK(missing(part, {fmt::format("{}.dae -s 1 -m 1 -l {}", scene, count)}) == none);
  for (const Section& section : part.sections)
    for (const Figure& figure : section.figures)
      CHECK((figure.converged.has_value() || figure.label == "converged"));
}

TEST_CASE("part 4 has both parts of the light, each depth, roulette and samples up to 1024") {
  const Part part = plan_global_light({whole, full});
  for (const char* scene : {"CBbunny", "CBspheres_lambertian"}) {
    CHECK(missing(part, {fmt::format("{}.dae -s 1024 --bounces=direct", scene),
                         fmt::format("{}.dae -s 1024 -m 5 --bounces=indirect", scene)}) == none);
    for (int depth = 0; depth <= 5; ++depth)
      CHECK(missing(part, {fmt::format("{}.dae -s 1024 -m {}", scene, depth),
                           fmt::format("{}.dae -s 1024 -m {} --bounces=last", scene, depth)}) == none);
    for (const char* rule : {"0.3", "0.5", "0.7", "throughput"})
      CHECK(missing(part, {fmt::format("{}.dae -s 1024 -m 100 --roulette={}", scene, rule)}) == none);
    for (const int samples : {1, 2, 4, 8, 16, 64, 1024})
      CHECK(missing(part, {fmt::format("{}.dae -s {} -l 4 -m 5", scene, samples)}) == none);
  }
}

TEST_CASE("part 5 samples three scenes adaptively, by both rules and without") {
  const Part part = plan_adaptive({whole, full});
  for (const char* scene : {"CBspheres_lambertian", "CBbunny", "wall-e"})
    CHECK(missing(part, {fmt::format("{}.dae -s 2048 -l 1 -m 5", scene),
                         fmt::format("{}.dae -s 2048 -l 1 -m 5 -a 64 0.05 --adaptive-rule=cs184", scene),
                         fmt::format("{}.dae -s 2048 -l 1 -m 5 -a 64 0.05 --adaptive-rule=careful",
                                     scene)}) == none);
}

TEST_CASE("a converged picture has another seed, and more samples than what it judges") {
  for (const Scale& scale : {quick, medium, full})
    for (const Part& part : plan_study({whole, scale}))
      for (const Section& section : part.sections)
        for (const Figure& figure : section.figures) {
          if (!figure.converged) continue;
          INFO(figure.picture.name << " at " << scale.name);
          const Words& options = figure.converged->options;
          CHECK(std::find(options.begin(), options.end(), "--seed") != options.end());
          CHECK(figure.converged->scene == figure.picture.scene);
          CHECK((figure.converged->samples > figure.picture.samples || figure.picture.samples == 1));
        }
}

TEST_CASE("pictures of one name are the same everywhere in a study, even where all stand in for others") {
  for (const SceneFolder& folder : {whole, folder_of({"CBdragon", "CBbunny", "CBspheres", "point"})})
    for (const Scale& scale : {quick, medium, full}) {
      std::map<std::string, std::string> orders_by_name;
      for (const Part& part : plan_study({folder, scale})) {
        const std::vector<Picture> pictures = pictures_of(part);
        const std::vector<std::string> all = orders(part);
        for (std::size_t i = 0; i < all.size(); ++i)
          CHECK(orders_by_name.try_emplace(pictures[i].name, all[i]).first->second == all[i]);
      }
    }
}

TEST_CASE("scenes that are not there are named by part, with what stands in for them") {
  const SceneFolder few = folder_of({"CBdragon", "CBspheres_lambertian"});
  CHECK(plan_adaptive({few, quick}).missing == std::vector<std::string>{"CBbunny.dae", "wall-e.dae"});
  CHECK(plan_direct_light({few, quick}).missing ==
        std::vector<std::string>{"CBbunny.dae", "any scene that is lit by point lights alone",
                                 "dragon.dae (CBdragon.dae stands in for it)"});
  const std::vector<std::string> second = plan_hierarchy({few, quick}).missing;
  CHECK(std::count(second.begin(), second.end(), "dragon.dae (CBdragon.dae stands in for it)") == 1);
}

TEST_CASE("a record is what was written, and nothing else is one") {
  Record record{.command = "twinray render 'a b.dae'",
                .program = "twinray 1",
                .scene_hash = 0xfedcba9876543210,
                .files_hash = 0x123456789abcdef,
                .engine = "bvh",
                .build_seconds = 0.25,
                .render_seconds = 1.5,
                .rays = 1234567890123,
                .camera_rays = 12,
                .tests_per_ray = 2.5};
  const std::optional<Record> again = parse_record(record_text(record));
  REQUIRE(again);
  CHECK(record_text(*again) == record_text(record));
  CHECK(again->scene_hash == record.scene_hash);
  CHECK(again->files_hash == record.files_hash);
  CHECK_FALSE(parse_record("{}"));
  CHECK_FALSE(parse_record(record_text(record).substr(0, 40)));
  CHECK(hash_of("") == 0xcbf29ce484222325);
  CHECK(hash_of("a") == 0xaf63dc4c8601ec8c);  // the authors' test vector
}

}  // namespace twinray::study
