// SPDX-License-Identifier: Apache-2.0
#include "accel/engines.h"

#include <algorithm>
#include <set>

#include "accel/fastest_engine.h"
#include "core/error.h"
#include "tests/support/catch.h"
#include "tests/support/shapes.h"

using namespace twinray;
using namespace twinray::test;

TEST_CASE("each engine and each variant has a name of its own, and can be built") {
  const auto geometry = share({soup(40, 0.3f, 1), random_spheres(4, 0.2f, 2)});
  const Ray ray = random_rays(1, geometry->bounds(), 3).front();
  const Hit expected = build_accelerator(Backend::brute_force, geometry)->closest_hit(ray);
  std::set<std::string> names;
  for (const std::vector<Engine>& table : {engines(), engine_variants()})
    for (const Engine& engine : table) {
      CAPTURE(engine.name);
      CHECK(names.insert(engine.name).second);
      CHECK(!engine.what.empty());
      CHECK(find_engine(engine.name)->name == engine.name);
      const auto built = build_accelerator(engine.backend, geometry, engine.build);
      if (engine.is_canonical()) CHECK(built->closest_hit(ray) == expected);
    }
  CHECK(names.size() > engine_names().size() + 6);
}

TEST_CASE("the engines to choose among are those of the table, and bvh comes first") {
#ifdef TWINRAY_WITH_EMBREE
  CHECK(engine_names() == std::vector<std::string>{"bvh", "embree", "bvh-2", "embree-native", "brute-force"});
#else
  CHECK(engine_names() == std::vector<std::string>{"bvh", "bvh-2", "brute-force"});
#endif
}

TEST_CASE("a named engine takes the other options, but keeps what its name says") {
  const BuildOptions given{.threads = 3, .bvh_width = 8, .max_leaf_size = 2};
  CHECK(named_engine("bvh", given).build.max_leaf_size == 2);
  CHECK(named_engine("bvh", {.bvh_width = 2}).build.bvh_width == 2);
  CHECK(named_engine("bvh-2", given).build.bvh_width == 2);
  CHECK(named_engine("bvh-2", given).build.max_leaf_size == 2);
  const Engine median = named_engine("bvh-2-median", given);
  CHECK(median.build.bvh_split == BvhSplit::median);
  CHECK(median.build.threads == 3);
  CHECK(median.build.max_leaf_size == BuildOptions{}.max_leaf_size);
  CHECK(!find_engine("bvh-16"));
  std::string valid;
  for (const std::string& name : engine_names()) valid += (valid.empty() ? "" : ", ") + name;
  for (const Engine& variant : engine_variants()) valid += ", " + variant.name;
  CHECK_THROWS_WITH(named_engine("bvh-16"),
                    "there is no engine \"bvh-16\" in this build; valid are " + valid);
}

TEST_CASE("only engines that promise the canonical bits are called canonical") {
  CHECK(named_engine("bvh").is_canonical());
  CHECK(named_engine("bvh-2").is_canonical());
  CHECK(named_engine("brute-force").is_canonical());
  CHECK(!named_engine("bvh-moller-trumbore").is_canonical());
  if (const auto native = find_engine("embree-native")) CHECK(!native->is_canonical());
}

TEST_CASE("the fastest engine is canonical, keeps the options, and is named with its reason") {
  const Geometry small({soup(10, 0.3f, 1)}), middle({soup(5000, 0.3f, 1)}), large({soup(10000, 0.1f, 1)}),
      empty;
  for (const std::string& simd : available_instruction_sets())
    for (const Geometry* geometry : {&small, &middle, &large, &empty}) {
      const EngineChoice choice = fastest_engine(*geometry, {.threads = 2, .simd = simd});
      CAPTURE(simd, choice.engine.name);
      CHECK(choice.engine.is_canonical());
      CHECK(choice.engine.build.threads == 2);
      CHECK(choice.engine.build.simd == simd);
      const std::string in_the_middle = find_engine("embree") ? "embree" : "bvh";
      const bool is_slow = simd == "scalar" && geometry != &large;
      CHECK(choice.engine.name == (!is_slow ? "bvh" : geometry == &middle ? in_the_middle : "bvh-2"));
      const std::string sets = simd == "scalar" ? "without vector instructions" : "with ";
      CHECK(choice.reason.find(sets) == 0);
    }
}
