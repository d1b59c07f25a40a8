// SPDX-License-Identifier: Apache-2.0
#include "accel/engines.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "core/error.h"

namespace twinray {
namespace {

bool is_available(const Engine& engine) {
  const std::vector<Backend> backends = available_backends();
  const std::vector<BvhBuilder> builders = available_builders();
  return std::find(backends.begin(), backends.end(), engine.backend) != backends.end() &&
         std::find(builders.begin(), builders.end(), engine.build.bvh_builder) != builders.end();
}

std::vector<Engine> available(std::vector<Engine> all) {
  std::erase_if(all, [](const Engine& engine) { return !is_available(engine); });
  return all;
}

void add_bvh_variants(std::vector<Engine>& all) {
  const auto add = [&](const char* name, const BuildOptions& build, const char* what) {
    all.push_back({name, Backend::bvh, build, what});
  };
  add("bvh-fast", {.bvh_quality = BvhQuality::fast}, "our BVH, built in less time");
  add("bvh-high", {.bvh_quality = BvhQuality::high}, "our BVH, built with more care");
  add("bvh-compact", {.memory_mode = MemoryMode::compact}, "our BVH in half of the memory");
  add("bvh-2-median", {.bvh_width = 2, .bvh_split = BvhSplit::median}, "split into halves by count");
  add("bvh-2-midpoint", {.bvh_width = 2, .bvh_split = BvhSplit::midpoint}, "split in the middle");
  add("bvh-2-mean", {.bvh_width = 2, .bvh_split = BvhSplit::mean}, "split at the mean centroid");
  add("bvh-moller-trumbore", {.triangle_test = TriangleTest::moller_trumbore},
      "the readable BVH with another triangle test: other bits");
}

void add_builder_variants(std::vector<Engine>& all) {
  constexpr std::pair<BvhBuilder, const char*> builders[] = {
      {BvhBuilder::embree_low, "Embree's Morton builder"},
      {BvhBuilder::embree_medium, "Embree's binned builder"},
      {BvhBuilder::embree_high, "Embree's builder with spatial splits"}};
  for (const auto& [builder, what] : builders) {
    const std::string name = builder_name(builder);
    all.push_back(
        {"bvh-" + name, Backend::bvh, {.bvh_builder = builder}, fmt::format("our BVH over {}", what)});
    all.push_back({"bvh-2-" + name,
                   Backend::bvh,
                   {.bvh_width = 2, .bvh_builder = builder},
                   fmt::format("the readable BVH over {}", what)});
  }
}

void add_native_variants(std::vector<Engine>& all) {
  const auto add = [&](const char* name, EmbreeMode mode, EmbreeQuality quality, const char* what) {
    all.push_back({name,
                   Backend::embree_native,
                   {.embree_mode = mode, .embree_quality = quality, .embree_isa = "default"},
                   what});
  };
  add("embree-native-default", EmbreeMode::robust, EmbreeQuality::medium,
      "Embree as it comes: its own triangles, robust, the instruction set that it chooses");
  add("embree-native-fast", EmbreeMode::fast, EmbreeQuality::medium,
      "the same in fast mode: rays may slip through edges");
  add("embree-native-fast-high", EmbreeMode::fast, EmbreeQuality::high,
      "fast mode over a tree with spatial splits");
}

/// Each instruction set of this machine but the one that is taken anyway.
void add_instruction_sets(std::vector<Engine>& all) {
  for (const std::string& simd : available_instruction_sets()) {
    if (simd == BuildOptions{}.simd) continue;
    all.push_back({"bvh-" + simd, Backend::bvh, {.simd = simd}, fmt::format("our BVH with {}", simd)});
    all.push_back({"embree-leaf-" + simd,
                   Backend::embree,
                   {.simd = simd},
                   fmt::format("Embree's traversal, our leaf with {}", simd)});
  }
  for (const char* isa : {"sse2", "sse4.2", "avx", "avx2", "avx512", "default"})
    if (isa != BuildOptions{}.embree_isa)
      all.push_back({fmt::format("embree-{}", isa),
                     Backend::embree,
                     {.embree_isa = isa},
                     fmt::format("Embree's traversal with {}, our leaf", isa)});
}

}  // namespace

std::vector<Engine> engines() {
  return available(
      {{"bvh", Backend::bvh, {}, "our BVH of eight children a node"},
       {"embree", Backend::embree, {}, "Embree's traversal with our canonical leaf"},
       {"bvh-2", Backend::bvh, {.bvh_width = 2}, "our readable BVH of two children a node"},
       {"embree-native", Backend::embree_native, {}, "Embree with its own triangles, with AVX2 at most"},
       {"brute-force", Backend::brute_force, {}, "every ray against every primitive"}});
}

std::vector<Engine> engine_variants() {
  std::vector<Engine> all;
  add_bvh_variants(all);
  add_builder_variants(all);
  add_native_variants(all);
  add_instruction_sets(all);
  return available(std::move(all));
}

std::vector<std::string> engine_names() {
  std::vector<std::string> names;
  for (const Engine& engine : engines()) names.push_back(engine.name);
  return names;
}

std::optional<Engine> find_engine(const std::string& name) {
  for (const std::vector<Engine>& table : {engines(), engine_variants()})
    for (const Engine& engine : table)
      if (engine.name == name) return engine;
  return std::nullopt;
}

Engine named_engine(const std::string& name, const BuildOptions& build) {
  std::optional<Engine> found = find_engine(name);
  const std::vector<std::string> names = engine_names();
  if (!found) {
    std::vector<std::string> all = names;
    for (const Engine& variant : engine_variants()) all.push_back(variant.name);
    throw Error(
        fmt::format("there is no engine \"{}\" in this build; valid are {}", name, fmt::join(all, ", ")));
  }
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    found->build.threads = build.threads;
  } else {
    const bool is_binary = found->build.bvh_width == 2;
    found->build = build;
    if (is_binary) found->build.bvh_width = 2;
  }
  return *std::move(found);
}

}  // namespace twinray
