// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstring>

#include "accel/build/binary_tree.h"
#include "accel/build/cost_model.h"
#include "accel/bvh/build.h"
#include "accel/bvh/invariants.h"
#include "accel/bvh/traversal.h"
#include "accel/canonical/checked_ray.h"
#include "accel/canonical/slab.h"
#include "core/error.h"
#include "tests/support/catch.h"
#include "tests/support/shapes.h"

using namespace twinray;
using namespace twinray::test;

namespace {

constexpr BvhSplit all_splits[] = {BvhSplit::sah, BvhSplit::median, BvhSplit::midpoint, BvhSplit::mean};

Bvh build(const Geometry& geometry, const BuildOptions& options = {}) {
  std::vector<BuildPhase> phases;
  return make_bvh(geometry, options, phases);
}

/// Every split method, and every other builder of this build.
std::vector<BuildOptions> all_builds(int max_leaf_size) {
  std::vector<BuildOptions> all;
  for (const BvhSplit split : all_splits)
    all.push_back({.bvh_width = 2, .bvh_split = split, .max_leaf_size = max_leaf_size});
  for (const BvhBuilder builder : available_builders())
    if (builder != BvhBuilder::own)
      all.push_back({.bvh_width = 2, .bvh_builder = builder, .max_leaf_size = max_leaf_size});
  return all;
}

Occurrence occurrence(const BuildOptions& options) {
  return options.bvh_builder == BvhBuilder::embree_high ? Occurrence::in_pieces : Occurrence::once;
}

std::string fault(const Geometry& geometry, const BuildOptions& options) {
  return find_fault(build(geometry, options), geometry, options.max_leaf_size, occurrence(options));
}

/// Primitives that are unit cubes around points of the x axis.
BuildPrimitives cubes_at(const std::vector<float>& places) {
  BuildPrimitives primitives;
  for (const float x : places)
    primitives.push_back(
        {{{x - 0.5f, -0.5f, -0.5f}, {x + 0.5f, 0.5f, 0.5f}}, {0, std::uint32_t(primitives.size())}});
  return primitives;
}

/// The ids of the first `count` primitives, sorted.
std::vector<std::uint32_t> first_ids(const BuildPrimitives& primitives, std::size_t count) {
  std::vector<std::uint32_t> ids;
  for (std::size_t i = 0; i < count; ++i) ids.push_back(primitives[i].id.primitive);
  std::sort(ids.begin(), ids.end());
  return ids;
}

using Ids = std::vector<std::uint32_t>;

/// Triangles whose distance from the origin doubles from one to the next, through 160 powers of two.
Mesh exponential_triangles() {
  Mesh mesh;
  for (int i = -120; i < 39; ++i) {
    const float x = std::ldexp(1.0f, i);
    add_triangle(mesh, {x, 0, 0}, {x, x, 0}, {x, 0, x});
  }
  return mesh;
}

bool same_trees(const Bvh& a, const Bvh& b) {
  const auto same_block = [](const PrimitiveBlock& x, const PrimitiveBlock& y) {
    return std::memcmp(x.corners, y.corners, sizeof x.corners) == 0 &&
           std::memcmp(x.ids, y.ids, sizeof x.ids) == 0 && x.count == y.count && x.triangles == y.triangles;
  };
  return a.box == b.box && a.root == b.root && a.pairs.size() == b.pairs.size() &&
         std::memcmp(a.pairs.data(), b.pairs.data(), a.pairs.size() * sizeof(NodePair)) == 0 &&
         std::equal(a.blocks.begin(), a.blocks.end(), b.blocks.begin(), b.blocks.end(), same_block);
}

}  // namespace

TEST_CASE("every split and leaf size gives a tree without a fault") {
  const auto geometry = share({soup(700, 0.1f, 1), random_spheres(60, 0.2f, 2), soup(300, 1.0f, 3)});
  for (const int leaf : {1, 2, 3, 4, 5, 8, 32})
    for (const BuildOptions& options : all_builds(leaf)) {
      CAPTURE(int(options.bvh_split), int(options.bvh_builder), leaf);
      CHECK(fault(*geometry, options) == "");
    }
  for (const BvhSplit split : all_splits)
    CHECK(fault(*geometry, {.bvh_split = split, .max_leaf_size = 255}) == "");
  for (const int bins : {2, 3, 256}) CHECK(fault(*geometry, {.bvh_bins = bins}) == "");
}

TEST_CASE("every split, builder and leaf size is what it says") {
  const auto geometry = share({soup(2000, 0.1f, 21)});
  std::vector<std::size_t> nodes;
  for (const BuildOptions& options : all_builds(4)) {
    const AccelStats stats = build_accelerator(Backend::bvh, geometry, options)->stats();
    CHECK(stats.primitives == 2000);
    CHECK(stats.tree->nodes == 2 * stats.tree->leaves - 1);
    nodes.push_back(stats.tree->nodes);
  }
  std::sort(nodes.begin(), nodes.end());
  CHECK(std::adjacent_find(nodes.begin(), nodes.end()) == nodes.end());
}

TEST_CASE("a builder that is not part of the build is refused, and so are leaves beyond its own bound") {
  const auto geometry = share({soup(20, 0.1f, 22)});
#ifdef TWINRAY_WITH_EMBREE
  CHECK(available_builders().size() == 4);
  CHECK_THROWS_WITH(
      build_accelerator(Backend::bvh, geometry,
                        {.bvh_width = 2, .bvh_builder = BvhBuilder::embree_medium, .max_leaf_size = 33}),
      "Embree's builders make leaves of up to 32 primitives");
#else
  CHECK(available_builders() == std::vector{BvhBuilder::own});
  CHECK_THROWS_WITH(build_accelerator(Backend::bvh, geometry, {.bvh_builder = BvhBuilder::embree_low}),
                    "the builder embree-low is not part of this build");
#endif
}

TEST_CASE("the invariants name what is wrong with a tree") {
  const auto geometry = share({soup(40, 1, 1)});
  const Bvh good = build(*geometry);
  CHECK(find_fault(good, *geometry, 4) == "");
  CHECK(find_fault(good, *geometry, 1).find("a leaf holds ") == 0);

  Bvh bad = good;
  bad.pairs.back().planes[0][0] = -10;
  CHECK(find_fault(bad, *geometry, 4).find("leaves its parent") != std::string::npos);
  bad = good;
  bad.blocks[0].ids[0].primitive = 40;
  CHECK(find_fault(bad, *geometry, 4) == "there is no primitive 40 of shape 0");
  bad = good;
  bad.blocks[0].ids[0] = bad.blocks[1].ids[0];
  CHECK(find_fault(bad, *geometry, 4) != "");
  bad = good;
  bad.root = {0, 1};
  CHECK(find_fault(bad, *geometry, 4).find("lies in 0 leaves") != std::string::npos);
}

TEST_CASE("the tree has the same bits on any number of threads") {
  const auto geometry = share({soup(90000, 0.02f, 7)});
  REQUIRE(geometry->primitive_count() > parallel_range);
  for (BuildOptions options : all_builds(4)) {
    CAPTURE(int(options.bvh_split), int(options.bvh_builder));
    options.threads = 1;
    const Bvh one = build(*geometry, options);
    for (const int threads : {2, 7}) {
      options.threads = threads;
      CHECK(same_trees(one, build(*geometry, options)));
    }
  }
}

TEST_CASE("degenerate geometry builds") {
  for (const auto& geometry : degenerate_geometries())
    for (const BuildOptions& options : all_builds(2)) {
      CAPTURE(geometry->primitive_count(), int(options.bvh_split), int(options.bvh_builder));
      CHECK(fault(*geometry, options) == "");
    }
}

TEST_CASE("coincident centres are divided by halves") {
  Mesh mesh;
  for (int i = 0; i < 64; ++i) add_triangle(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const auto geometry = share({mesh});
  const auto bvh = build_accelerator(Backend::bvh, geometry, {.bvh_width = 2, .max_leaf_size = 1});
  CHECK(bvh->stats().tree->depth == 6);
  CHECK(bvh->stats().tree->leaves == 64);
}

TEST_CASE("no tree is deeper than the stack") {
  const auto geometry = share({exponential_triangles()});
  for (const BuildOptions& options : all_builds(1)) {
    CAPTURE(int(options.bvh_split), int(options.bvh_builder));
    CHECK(fault(*geometry, options) == "");
  }
  // Without the bound each midpoint would split off one triangle.
  const auto midpoint = build_accelerator(
      Backend::bvh, geometry, {.bvh_width = 2, .bvh_split = BvhSplit::midpoint, .max_leaf_size = 1});
  CHECK(midpoint->stats().tree->depth > free_bvh_depth);
  CHECK(midpoint->stats().tree->depth <= max_bvh_depth);
}

TEST_CASE("median parts halves by centre along the longest axis") {
  BuildPrimitives primitives = cubes_at({9, 1, 100, 3, 2});
  CHECK(divide_by_median(NodeRange(primitives)) == 2);
  CHECK(first_ids(primitives, 2) == Ids{1, 4});
  for (BuildPrimitive& primitive : primitives)
    for (Vec3* corner : {&primitive.box.lower, &primitive.box.upper}) std::swap(corner->x, corner->z);
  CHECK(NodeRange(primitives).longest_axis() == 2);
  CHECK(divide_by_median(NodeRange(primitives)) == 2);
  CHECK(first_ids(primitives, 2) == Ids{1, 4});
}

TEST_CASE("midpoint parts at the middle of the centres' box") {
  BuildPrimitives primitives = cubes_at({9, 1, 100, 3, 2});
  CHECK(divide_by_midpoint(NodeRange(primitives)) == 4);
  CHECK(first_ids(primitives, 4) == Ids{0, 1, 3, 4});
}

TEST_CASE("midpoint halves where no float lies between the centres") {
  const float x = 1, next = std::nextafter(1.0f, 2.0f);
  BuildPrimitives primitives;
  for (std::uint32_t i = 0; i < 6; ++i) {
    const float p = i < 5 ? x : next;
    primitives.push_back({{{p, 0, 0}, {p, 0, 0}}, {0, i}});
  }
  const NodeRange range(primitives);
  REQUIRE(!range.is_coincident());
  const std::size_t count = divide_by_midpoint(range);
  CHECK(count > 0);
  CHECK(count < 6);
}

TEST_CASE("mean parts at the mean of the centres") {
  BuildPrimitives primitives = cubes_at({9, 1, 100, 30, 2});
  CHECK(divide_by_mean(NodeRange(primitives)) == 3);
  CHECK(first_ids(primitives, 3) == Ids{0, 1, 4});
}

TEST_CASE("sah parts two clusters between them") {
  BuildPrimitives primitives = cubes_at({0, 100, 1, 101, 2, 102, 103});
  const BuildOptions options{.max_leaf_size = 1};
  CHECK(divide_by_sah(NodeRange(primitives), options) == 3);
  CHECK(first_ids(primitives, 3) == Ids{0, 2, 4});
}

TEST_CASE("a leaf is kept when every split costs more") {
  // Two cubes that overlap by nine tenths: each half is almost as large as the whole.
  BuildPrimitives primitives = cubes_at({0, 0.1f});
  CHECK(divide(NodeRange(primitives), {}) == 0);
  // Where a leaf of two is not allowed, they are divided all the same.
  CHECK(divide(NodeRange(primitives), {.max_leaf_size = 1}) == 1);
  // Where looking at a box costs next to nothing, parting the two pays.
  CHECK(divide(NodeRange(primitives), {.traversal_cost = 1e-3}) == 1);
  // Two cubes far apart are divided unless primitives are cheap.
  primitives = cubes_at({0, 100});
  CHECK(divide(NodeRange(primitives), {.traversal_cost = 0.5}) == 1);
  CHECK(divide(NodeRange(primitives), {.traversal_cost = 4}) == 0);
}

TEST_CASE("a cost by blocks fills leaves") {
  // By primitives three and two lie tightest; by blocks of four, which take the same for any number of
  // primitives, four and one.
  BuildPrimitives primitives = cubes_at({0, 1, 2, 4, 7});
  CHECK(divide_by_sah(NodeRange(primitives), {.max_leaf_size = 4}) == 3);
  CHECK(divide_by_sah(NodeRange(primitives), {.max_leaf_size = 4, .leaf_block = 4}) == 4);
  // Even far apart, two in one block are cheaper than two blocks.
  primitives = cubes_at({0, 100});
  CHECK(divide(NodeRange(primitives), {.leaf_block = 1, .traversal_cost = 0.5}) == 1);
  CHECK(divide(NodeRange(primitives), {.leaf_block = 4, .traversal_cost = 8}) == 0);
  const auto geometry = share({icosphere_mesh(4)});
  const auto blocks = [&](int block) {
    return double(build(*geometry, {.leaf_block = block}).blocks.size());
  };
  CHECK(blocks(4) < 0.75 * blocks(1));
  CHECK(fault(*geometry, {.leaf_block = 4}) == "");
}

TEST_CASE("the sah cost of a tree is the expected cost of a ray") {
  const auto one =
      build_accelerator(Backend::bvh, share({soup(1, 1, 1)}), {.bvh_width = 2, .intersection_cost = 3});
  CHECK(one->stats().tree->sah_cost == 3);
  // A root with two leaves of one: traversal, and each child by its share of the area.
  Mesh mesh;
  add_triangle(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  add_triangle(mesh, {3, 0, 0}, {4, 0, 0}, {3, 1, 0});
  const auto two = build_accelerator(Backend::bvh, share({mesh}), {.bvh_width = 2, .max_leaf_size = 1});
  CHECK(two->stats().tree->nodes == 3);
  CHECK(two->stats().tree->leaves == 2);
  CHECK(two->stats().tree->depth == 1);
  constexpr double padding = 1e-5;  // The boxes are widened by 2^-21 of their coordinates.
  CHECK(two->stats().tree->sah_cost == Approx(1 + 2 * 0.25).epsilon(padding));
}

TEST_CASE("both boxes of a pair are tested with the bits of the canonical box test") {
  Random random(5);
  for (int i = 0; i < 20000; ++i) {
    NodePair pair;
    Aabb boxes[2];
    for (int child = 0; child < 2; ++child) {
      boxes[child].extend(random.in_cube());
      boxes[child].extend(random.in_cube());
      pair.set_box(child, padded(boxes[child]));
    }
    Ray ray{.origin = random.in_cube(2), .direction = random.in_cube()};
    if (random.below(3) == 0) ray.direction[random.below(3)] = random.below(2) ? -0.0f : 0.0f;
    CheckedRay checked;
    if (!load_ray(ray, checked)) continue;
    const PairIntervals intervals = PairRay(checked).intersect(pair, checked.t_max);
    for (int child = 0; child < 2; ++child) {
      const SlabInterval interval = intersect_slab(checked, padded(boxes[child]));
      REQUIRE(intervals.entry(child) == std::max(interval.near, 0.0f));
      REQUIRE(intervals.exits[2 + child] == interval.far);
      REQUIRE(bool(intervals.met >> child & 1) == (interval.near <= interval.far && interval.far >= 0));
    }
  }
}

TEST_CASE("counting changes no answer and counts what was done") {
  const auto geometry = share({soup(500, 0.2f, 1), random_spheres(20, 0.2f, 2)});
  const auto bvh = build_accelerator(Backend::bvh, geometry, {.bvh_width = 2});
  QueryCounts closest, any;
  const auto rays = random_rays(500, geometry->bounds(), 4);
  for (const Ray& ray : rays) {
    CHECK(bvh->closest_hit({ray, &closest}) == bvh->closest_hit(ray));
    CHECK(bvh->any_hit({ray, &any}) == bvh->any_hit(ray));
  }
  CHECK(closest.boxes == rays.size() + 2 * closest.nodes);
  CHECK(closest.leaves > 0);
  CHECK(closest.primitives >= closest.leaves);
  CHECK(closest.primitives <= 4 * closest.leaves);
  CHECK(any.nodes < closest.nodes);
}

TEST_CASE("a tree has statistics") {
  const auto geometry = share({soup(500, 0.2f, 1)});
  const AccelStats stats = build_accelerator(Backend::bvh, geometry, {.bvh_width = 2})->stats();
  CHECK(stats.primitives == 500);
  CHECK(stats.tree->nodes == 2 * stats.tree->leaves - 1);
  CHECK(stats.bytes > 500 * sizeof(Triangle));
  CHECK(stats.tree->depth > 5);
  CHECK(stats.tree->sah_cost > 1);
  REQUIRE(stats.phases.size() == 3);
  CHECK(stats.phases[1].name == "tree");
}
