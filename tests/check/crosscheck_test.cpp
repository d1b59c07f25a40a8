// SPDX-License-Identifier: Apache-2.0
// The crosscheck itself: what it says about engines that agree, about Embree's own triangles, and about
// engines with a planted defect.
#include "check/crosscheck.h"

#include "core/error.h"
#include "tests/support/catch.h"
#include "tests/support/crosscheck.h"
#include "tests/support/hard_meshes.h"
#include "tests/support/instances.h"
#include "tests/support/wrong_engine.h"

using namespace twinray;
using namespace twinray::test;

namespace {

constexpr std::uint64_t rays_of_a_class = 600, brute_force_every = 10;

template <Backend backend>
std::unique_ptr<Accelerator> make(std::shared_ptr<const Geometry> geometry) {
  return build_accelerator(backend, std::move(geometry));
}
std::unique_ptr<Accelerator> make_binary(std::shared_ptr<const Geometry> geometry) {
  return build_accelerator(Backend::bvh, std::move(geometry), {.bvh_width = 2});
}
std::unique_ptr<Accelerator> make_median(std::shared_ptr<const Geometry> geometry) {
  return build_accelerator(Backend::bvh, std::move(geometry),
                           {.bvh_width = 2, .bvh_split = BvhSplit::median, .max_leaf_size = 1});
}

/// Every engine of this build.
std::vector<EngineMaker> all_engines() {
  std::vector<EngineMaker> makers{
      {"bvh", make<Backend::bvh>}, {"bvh 2-wide", make_binary}, {"bvh median", make_median}};
#ifdef TWINRAY_WITH_EMBREE
  makers.push_back({"embree", make<Backend::embree>});
  makers.push_back({"embree-native", make<Backend::embree_native>, false});
#endif
  makers.push_back({"brute-force", make<Backend::brute_force>, true, brute_force_every});
  return makers;
}

/// All engines agree on the geometry, but for what the oracle explains; returns how many rays were shot.
void check_agreement(const std::shared_ptr<const Geometry>& geometry) {
  const std::vector<EngineMaker> makers = all_engines();
  const CrosscheckReport report = crosscheck(geometry, makers, rays_of_a_class);
  for (std::size_t engine = 0; engine < makers.size(); ++engine)
    for (const RayClass ray_class : shape_ray_classes()) {
      const Tally& tally = report.tally(engine, ray_class);
      INFO(makers[engine].name << " on " << ray_class_name(ray_class) << " rays");
      CHECK(tally.rays == rays_of_a_class / makers[engine].every);
      CHECK(tally.count(Difference::unexplained) == 0);
      if (makers[engine].is_canonical) CHECK(tally.count(Difference::identical) == tally.rays);
    }
}

/// After a class of rays with so many the next ones need not be shot.
constexpr std::uint64_t enough_findings = 20;

/// Plants one defect after the other.
void check_defects(const std::shared_ptr<const Geometry>& geometry) {
  const std::vector<EngineMaker> sound{
      {"bvh", make<Backend::bvh>},
      {"bvh 2-wide", make_binary},
      {"plain", [](auto g) { return build_wrong_engine(std::move(g), Defect::none); }}};
  CHECK(crosscheck(geometry, sound, rays_of_a_class).unexplained() == 0);

  for (const Defect defect : all_defects()) {
    INFO(defect_name(defect));
    const auto reference = build_accelerator(Backend::bvh, geometry);
    const auto wrong = build_wrong_engine(geometry, defect);
    const Crosscheck check(geometry, {{"bvh", reference.get()}, {"wrong", wrong.get()}});
    const ShapeRays rays(geometry, *reference, 7);
    CrosscheckReport report(2);
    for (const RayClass ray_class : shape_ray_classes())
      if (placement_of(ray_class) == Placement::file && report.unexplained() < enough_findings)
        for (std::uint64_t i = 0; i < rays_of_a_class; ++i)
          check.check(rays.ray(ray_class, i), ray_class, i, report);
    CHECK(report.unexplained() > 0);
    for (const RayClass ray_class : shape_ray_classes())
      for (const Finding& finding : report.findings(1, ray_class)) {
        CHECK(finding.difference == Difference::unexplained);
        CHECK(same_bits(ask(*wrong, finding.ray), finding.found));
        CHECK_FALSE(same_bits(ask(*reference, finding.ray), finding.found));
      }
  }
}

}  // namespace

TEST_CASE("nothing is unexplained on a closed sphere") { check_agreement(share({icosphere_mesh(4)})); }

TEST_CASE("nothing is unexplained on a soup with spheres") {
  check_agreement(share({soup(400, 0.3f, 1), random_spheres(30, 0.3f, 2)}));
}

TEST_CASE("nothing is unexplained on slivers") { check_agreement(share({slivers()})); }

TEST_CASE("nothing is unexplained on coplanar layers and duplicates") {
  check_agreement(share({layers(), layers()}));
}

TEST_CASE("nothing is unexplained where triangles have no area") {
  check_agreement(share({with_degenerate()}));
}

TEST_CASE("nothing is unexplained far from the origin of coordinates") {
  check_agreement(share({far_sphere()}));
}

TEST_CASE("nothing is unexplained with one huge triangle among tiny ones") {
  check_agreement(share({huge_among_tiny()}));
}

TEST_CASE("nothing is unexplained where some vertices lie far outside") {
  check_agreement(share({with_thrown_vertices()}));
}

TEST_CASE("nothing is unexplained without any shape") { check_agreement(share({})); }

TEST_CASE("nothing is unexplained on instances of each kind") {
  for (const Kind kind : kinds) {
    INFO("kind " << int(kind));
    check_agreement(
        share_instanced({soup(100, 0.5f, 3)}, {{icosphere_mesh(2)}, {soup(60, 0.4f, 4)}}, {kind}, 5, 5));
  }
}

TEST_CASE("each planted defect is found, and its rays are named") {
  for (const auto& geometry :
       {share({layers(), layers(), icosphere_mesh(3)}),
        share_instanced({layers()}, {{layers(), icosphere_mesh(3)}}, {Kind::rigid, Kind::scaled}, 2, 9)})
    check_defects(geometry);
}

TEST_CASE("a witness with a defect is not excused") {
  // The same engines, as if their differences were to be judged: only rounding is.
  const auto geometry = share({icosphere_mesh(3), soup(200, 0.3f, 5)});
  const auto reference = build_accelerator(Backend::bvh, geometry);
  for (const Defect defect : {Defect::skipped_child, Defect::right_never_looked_at, Defect::t_max_lags,
                              Defect::last_primitive_lost, Defect::minus_zero_ignored}) {
    INFO(defect_name(defect));
    const auto wrong = build_wrong_engine(geometry, defect);
    const Crosscheck check(geometry, {{"bvh", reference.get()}, {"wrong", wrong.get(), false}});
    const ShapeRays rays(geometry, *reference, 7);
    CrosscheckReport report(2);
    for (const RayClass ray_class : {RayClass::random, RayClass::axes, RayClass::vertices})
      for (std::uint64_t i = 0; i < 2000; ++i) check.check(rays.ray(ray_class, i), ray_class, i, report);
    CHECK(report.unexplained() > 0);
  }
}

TEST_CASE("reports add up in any order") {
  const auto geometry = share({icosphere_mesh(3)});
  const auto reference = build_accelerator(Backend::bvh, geometry);
  const auto wrong = build_wrong_engine(geometry, Defect::skipped_child);
  const Crosscheck check(geometry, {{"bvh", reference.get()}, {"wrong", wrong.get()}});
  const ShapeRays rays(geometry, *reference, 3);
  CrosscheckReport parts[3] = {CrosscheckReport(2, 4), CrosscheckReport(2, 4), CrosscheckReport(2, 4)};
  for (std::uint64_t i = 0; i < 900; ++i)
    check.check(rays.ray(RayClass::random, i), RayClass::random, i, parts[i % 3]);
  CrosscheckReport forward(2, 4), backward(2, 4);
  for (const int i : {0, 1, 2}) forward += parts[i];
  for (const int i : {2, 1, 0}) backward += parts[i];
  CHECK(forward.tally(1, RayClass::random) == backward.tally(1, RayClass::random));
  const auto& a = forward.findings(1, RayClass::random);
  const auto& b = backward.findings(1, RayClass::random);
  REQUIRE(a.size() == 4);
  REQUIRE(b.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) CHECK(a[i].number == b[i].number);
}

TEST_CASE("a crosscheck needs a canonical reference") {
  const auto geometry = share({icosphere_mesh(1)});
  const auto engine = build_accelerator(Backend::bvh, geometry);
  CHECK_THROWS_AS(Crosscheck(geometry, {{"bvh", engine.get()}}), Error);
  CHECK_THROWS_AS(Crosscheck(geometry, {{"a", engine.get(), false}, {"b", engine.get()}}), Error);
}
