// SPDX-License-Identifier: Apache-2.0
#include "check/oracle.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "accel/bvh/build.h"
#include "accel/bvh/traversal.h"

namespace twinray {
namespace {

using Standing = Testimony::Standing;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double ulp = 0x1p-24;
/// Two triangles lie in one plane where the sine of the angle between their normals is at most this.
constexpr double parallel_sine = 1e-5;

double length_of(const Vec3& v) {
  return std::sqrt(double(v.x) * v.x + double(v.y) * v.y + double(v.z) * v.z);
}

double longest_edge(const Vec3& a, const Vec3& b, const Vec3& c) {
  return std::max(length_of(b - a), std::max(length_of(c - b), length_of(a - c)));
}

/// On what size, in the space of an instance, its transform rounds; 0 without an instance. Who goes by float
/// matrices rounds on the size of the origin and the translation, as far as the inverse stretches them, and
/// its inverse is off by as many ulps as the transform's condition is large.
double rounding_of(const Geometry& geometry, const Ray& ray, std::uint32_t instance) {
  if (instance == no_instance) return 0;
  const Transform &to_world = geometry.instances()[instance].to_world,
                  &to_object = geometry.placed()[instance].to_object;
  double size = max_abs(ray.origin);
  for (const auto& row : to_world.m) size += std::fabs(row[3]);
  return size * to_object.stretch() * to_object.stretch() * to_world.stretch();
}

/// The ray as engines take it where a primitive is; false for an invalid one.
bool engine_ray(const Geometry& geometry, const Ray& ray, std::uint32_t instance, CheckedRay& checked) {
  if (!load_ray_into(geometry, ray, checked)) return false;
  if (instance == no_instance) return true;
  Ray moved{.origin = {}, .direction = {}, .t_min = checked.t_min, .t_max = checked.t_max};
  move_into(geometry.placed()[instance], checked, moved);
  if (!load_ray(moved, checked)) return false;
  checked.instance = instance;
  return true;
}

/// The direction as engines take it.
Vec3 scaled_direction(const Geometry& geometry, const Ray& ray, std::uint32_t instance) {
  CheckedRay checked;
  return engine_ray(geometry, ray, instance, checked) ? checked.direction : ray.direction;
}

/// The least difference that floats at t, and the smallest floats, can have.
double float_ulp(double t) { return std::max(std::fabs(t) * ulp, 0x1p-149); }

/// Fills in the standing by the ends of the ray's interval; false where t lies clearly outside.
bool stands_in_interval(const Ray& ray, Testimony& testimony) {
  const double reach = rounding_ulps * testimony.t_ulp;
  if (std::isnan(testimony.t)) return true;
  const double t_max = std::min(ray.t_max, std::numeric_limits<float>::max());
  if (testimony.t < ray.t_min - reach || testimony.t > t_max + reach) return false;
  const bool is_clear = testimony.t > ray.t_min + reach && testimony.t < t_max - reach;
  if (!is_clear && testimony.standing == Standing::firm) testimony.standing = Standing::interval_end;
  return true;
}

Standing standing_of(const TriangleJudgement& judgement) {
  if (judgement.position == LinePosition::edge_on || judgement.cosine < grazing_cosine)
    return Standing::grazing;
  return std::fabs(judgement.edge_margin_ulps()) <= rounding_ulps ? Standing::edge : Standing::firm;
}

/// Of hits with weights within rounding of the true ones, of a mesh with holes, how many count of nine.
int accepted_of_nine(const Geometry& geometry, const Ray& ray, const Testimony& testimony) {
  CheckedRay checked;
  if (!engine_ray(geometry, ray, testimony.instance, checked)) return 0;
  const double reach = rounding_ulps * testimony.weight_ulp;
  int accepted = 0;
  for (const double du : {-reach, 0.0, reach})
    for (const double dv : {-reach, 0.0, reach})
      accepted += geometry.accepts(checked.origin, checked.direction,
                                   {.u = float(testimony.weights[1] + du),
                                    .v = float(testimony.weights[2] + dv),
                                    .primitive = testimony.primitive,
                                    .mesh = testimony.mesh,
                                    .instance = testimony.instance});
  return accepted;
}

/// Fills in the standing of a firm hit by the shape's holes; false where it clearly lies in one.
bool stands_beside_holes(const Geometry& geometry, const Ray& ray, Testimony& testimony) {
  if (testimony.standing != Standing::firm || geometry.is_opaque(testimony.mesh)) return true;
  // Whether a sphere's hit counts is asked by one function in all engines: at most its rounding differs.
  const bool has_weights = geometry.mesh(testimony.mesh) && testimony.divisor >= smallest_divisor;
  const int accepted = has_weights ? accepted_of_nine(geometry, ray, testimony) : 1;
  if (accepted < 9) testimony.standing = Standing::cut_out;
  return accepted > 0;
}

void testify_triangle(const Geometry& geometry, const Ray& ray, const OwnRay& own, Testimony testimony,
                      std::vector<Testimony>& all) {
  const Mesh& mesh = *geometry.mesh(testimony.mesh);
  const auto [i, j, k] = mesh.triangles[testimony.primitive];
  const Vec3 &a = mesh.positions[i], &b = mesh.positions[j], &c = mesh.positions[k];
  TriangleJudgement judgement = judge_triangle(own.ray, a, b, c);
  judgement.scale = std::max(judgement.scale, rounding_of(geometry, ray, own.instance));
  testimony.standing = standing_of(judgement);
  if (testimony.standing == Standing::firm && !judgement.crosses()) return;
  testimony.is_met = judgement.hits();
  const double longest = longest_edge(a, b, c);
  const bool is_tiny =
      testimony.standing != Standing::firm && longest < rounding_ulps * ulp * judgement.scale;
  if (is_tiny) testimony.standing = Standing::tiny;
  if (is_tiny || judgement.position == LinePosition::edge_on) {
    testimony.t = nan;
    all.push_back(testimony);
    return;
  }
  testimony.t = std::ldexp(judgement.t.value, -own.exponent);
  const double parameters = length_of(own.ray.direction) * judgement.conditioning;
  testimony.t_ulp = std::ldexp(ulp * judgement.scale / parameters, -own.exponent) + float_ulp(testimony.t);
  testimony.weight_ulp = ulp * (1 + judgement.scale / (longest * judgement.conditioning));
  std::copy_n(judgement.weights, 3, testimony.weights);
  testimony.divisor = 2 * judgement.conditioning * longest * longest *
                      length_of(scaled_direction(geometry, ray, own.instance));
  if (stands_in_interval(ray, testimony) && stands_beside_holes(geometry, ray, testimony))
    all.push_back(testimony);
}

void testify_sphere(const Geometry& geometry, const Ray& ray, const OwnRay& own, Testimony testimony,
                    std::vector<Testimony>& all) {
  const Sphere& sphere = geometry.sphere_set(testimony.mesh)->spheres[testimony.primitive];
  SphereJudgement judgement = judge_sphere(own.ray, sphere);
  judgement.scale = std::max(judgement.scale, rounding_of(geometry, ray, own.instance));
  if (!(sphere.radius > 0) || judgement.margin_ulps() < -rounding_ulps) return;
  if (judgement.margin_ulps() <= rounding_ulps) {
    testimony.standing = Standing::edge;
    testimony.is_met = judgement.hits(0) || judgement.hits(1);
    testimony.t = nan;
    all.push_back(testimony);
    return;
  }
  for (const int root : {0, 1}) {
    Testimony of_root = testimony;
    of_root.is_met = judgement.hits(root);
    of_root.t = std::ldexp(judgement.t[root].value, -own.exponent);
    const double ulps = ulp * judgement.scale / length_of(own.ray.direction);
    of_root.t_ulp = std::ldexp(ulps, -own.exponent) + float_ulp(of_root.t);
    if (stands_in_interval(ray, of_root) && stands_beside_holes(geometry, ray, of_root))
      all.push_back(of_root);
  }
}

/// About a primitive, in the space of its instance.
void testify(const Geometry& geometry, const Ray& ray, const OwnRay& own, const PrimitiveId& id,
             std::vector<Testimony>& all) {
  const Testimony testimony{.mesh = id.mesh, .primitive = id.primitive, .instance = own.instance};
  (geometry.mesh(id.mesh) ? testify_triangle : testify_sphere)(geometry, ray, own, testimony, all);
}

/// About the primitive of a hit.
void testify(const Geometry& geometry, const Ray& ray, const Hit& hit, std::vector<Testimony>& all) {
  testify(geometry, ray, ray_in(geometry, ray, hit.instance), {hit.mesh, hit.primitive}, all);
}

/// Whether two parameters are the same but for rounding.
bool are_close(const Testimony& a, double t, double other_ulp) {
  return std::isnan(a.t) || std::fabs(a.t - t) <= rounding_ulps * (a.t_ulp + other_ulp);
}

/// The testimony about a hit's own shape; null where there is none for its t.
const Testimony* find(const std::vector<Testimony>& all, const Hit& hit) {
  for (const Testimony& testimony : all)
    if (testimony.mesh == hit.mesh && testimony.primitive == hit.primitive &&
        testimony.instance == hit.instance && are_close(testimony, hit.t, 0))
      return &testimony;
  return nullptr;
}

/// `claimed`: about the shapes that the answers name; `firm`: shapes that no engine may miss.
bool is_defensible(const std::vector<Testimony>& claimed, const std::vector<Testimony>& firm,
                   const Answer& answer) {
  if (answer.any ? claimed.empty() : !firm.empty()) return false;
  if (answer.closest.is_miss()) return firm.empty();
  const Testimony* own = find(claimed, answer.closest);
  return own && std::none_of(firm.begin(), firm.end(), [&](const Testimony& other) {
           return other.t < answer.closest.t && !are_close(other, answer.closest.t, own->t_ulp);
         });
}

Difference difference_of(Standing standing) {
  switch (standing) {
    case Standing::edge:
      return Difference::edge;
    case Standing::grazing:
      return Difference::grazing;
    case Standing::interval_end:
      return Difference::interval_end;
    case Standing::tiny:
      return Difference::tiny;
    case Standing::cut_out:
      return Difference::cut_out;
    default:
      return Difference::unexplained;
  }
}

/// Why two shapes that are both claimed as the closest may be.
Difference difference_of(const Testimony& nearer, const Testimony& other) {
  return difference_of(nearer.standing != Standing::firm ? nearer.standing : other.standing);
}

/// Whether a look in double is enough to see that a triangle is not firm: it is smaller than the rounding at
/// its distance, or the ray passes clearly beside it (a vertex is farther away than the longest edge).
bool is_surely_not_firm(const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c) {
  constexpr double margin = 1e-6, distance_error = 1e-12;
  const double longest = longest_edge(a, b, c);
  const double x = double(a.x) - ray.origin.x, y = double(a.y) - ray.origin.y, z = double(a.z) - ray.origin.z;
  const double scale = std::max(std::fabs(x), std::max(std::fabs(y), std::fabs(z)));
  if (longest < rounding_ulps * ulp * scale) return true;
  const double dx = ray.direction.x, dy = ray.direction.y, dz = ray.direction.z;
  const double mx = dy * z - dz * y, my = dz * x - dx * z, mz = dx * y - dy * x;
  const double beside = std::sqrt((mx * mx + my * my + mz * mz) / (dx * dx + dy * dy + dz * dz));
  return beside > longest * (1 + margin) + distance_error * scale;
}

}  // namespace

std::string difference_name(Difference difference) {
  constexpr const char* names[difference_count] = {"identical", "rounding",  "tie",          "overlap",
                                                   "edge",      "grazing",   "interval end", "tiny",
                                                   "cut-out",   "underflow", "unexplained"};
  return names[std::size_t(difference)];
}

Oracle::Oracle(std::shared_ptr<const Geometry> geometry) : geometry_(std::move(geometry)) {
  std::vector<BuildPhase> phases;
  tree_ = std::make_unique<const SceneBvh>(make_scene_bvh(*geometry_, {}, phases));
}

Oracle::~Oracle() = default;

template <typename Visit>
void Oracle::visit_blocks(const CheckedRay& ray, const Visit& visit) const {
  traverse_scene(*tree_, *geometry_, ray, ray.t_max, NoCounts{},
                 [&](const CheckedRay& own, const PrimitiveBlock& block) {
                   visit(block, own.instance);
                   return false;
                 });
}

std::vector<Testimony> Oracle::testimonies(const Ray& ray) const {
  std::vector<Testimony> all;
  CheckedRay checked;
  if (!load_ray_into(*geometry_, ray, checked)) return all;
  // Hits just outside of the interval count, too: the boxes are asked for all t >= 0.
  checked.t_min = 0;
  checked.t_max = std::numeric_limits<float>::infinity();
  visit_blocks(checked, [&](const PrimitiveBlock& block, std::uint32_t instance) {
    const OwnRay own = ray_in(*geometry_, ray, instance);
    for (std::uint32_t lane = 0; lane < block.count; ++lane)
      testify(*geometry_, ray, own, block.ids[lane], all);
  });
  return all;
}

std::vector<Testimony> Oracle::firm_testimonies(const Ray& ray, float t_max) const {
  std::vector<Testimony> all;
  CheckedRay checked;
  if (!load_ray_into(*geometry_, ray, checked)) return all;
  if (t_max < ray.t_max) checked.t_max = float(std::min(t_max / checked.t_scale, double(checked.t_max)));
  visit_blocks(checked, [&](const PrimitiveBlock& block, std::uint32_t instance) {
    const OwnRay own = ray_in(*geometry_, ray, instance);
    for (std::uint32_t lane = 0; lane < block.count; ++lane) {
      const bool is_triangle = block.triangles >> lane & 1;
      if (is_triangle && is_surely_not_firm(own.ray, block.corner(0, int(lane)), block.corner(1, int(lane)),
                                            block.corner(2, int(lane))))
        continue;
      testify(*geometry_, ray, own, block.ids[lane], all);
    }
  });
  std::erase_if(all, [](const Testimony& testimony) { return testimony.standing != Standing::firm; });
  return all;
}

Difference Oracle::classify(const Ray& ray, const Answer& a, const Answer& b) const {
  if (same_bits(a, b)) return Difference::identical;
  if (CheckedRay checked; !load_ray_into(*geometry_, ray, checked))
    return Difference::unexplained;  // It must miss.
  if (!a.closest && !b.closest) return classify_without_claims(ray);
  const bool is_same_shape = a.closest && b.closest && same_shape(a.closest, b.closest);
  if (is_same_shape && a.any == b.any) return classify_same_shape(ray, a.closest, b.closest);

  std::vector<Testimony> claimed;
  if (a.closest) testify(*geometry_, ray, a.closest, claimed);
  if (b.closest) testify(*geometry_, ray, b.closest, claimed);
  // Behind the farther claim nothing matters; behind a miss's, which is infinite, everything may.
  const std::vector<Testimony> firm = firm_testimonies(ray, std::max(a.closest.t, b.closest.t));
  if (!is_defensible(claimed, firm, a) || !is_defensible(claimed, firm, b)) return Difference::unexplained;
  const Testimony* const of_a = a.closest ? find(claimed, a.closest) : nullptr;
  const Testimony* const of_b = b.closest ? find(claimed, b.closest) : nullptr;
  if (!of_a || !of_b || is_same_shape) return difference_of((of_a ? of_a : of_b)->standing);
  if (are_close(*of_a, b.closest.t, of_b->t_ulp) && of_a->is_met && of_b->is_met)
    return of_a->standing == Standing::firm && of_b->standing == Standing::firm && are_coplanar(*of_a, *of_b)
               ? Difference::overlap
               : Difference::tie;
  return a.closest.t < b.closest.t ? difference_of(*of_a, *of_b) : difference_of(*of_b, *of_a);
}

Difference Oracle::classify_without_claims(const Ray& ray) const {
  const std::vector<Testimony> all = testimonies(ray);
  const auto is_firm = [](const Testimony& testimony) { return testimony.standing == Standing::firm; };
  if (all.empty() || std::any_of(all.begin(), all.end(), is_firm)) return Difference::unexplained;
  return difference_of(all.front().standing);
}

Difference Oracle::classify_same_shape(const Ray& ray, const Hit& a, const Hit& b) const {
  std::vector<Testimony> all;
  testify(*geometry_, ray, a, all);
  const bool is_triangle = geometry_->mesh(a.mesh) != nullptr;
  for (const Testimony& truth : all) {
    const auto has_true_weights = [&](const Hit& hit) {
      return !is_triangle || (std::fabs(truth.weights[1] - hit.u) <= rounding_ulps * truth.weight_ulp &&
                              std::fabs(truth.weights[2] - hit.v) <= rounding_ulps * truth.weight_ulp);
    };
    if (!std::isnan(truth.t) && are_close(truth, a.t, 0) && are_close(truth, b.t, 0)) {
      if (has_true_weights(a) && has_true_weights(b)) return Difference::rounding;
      if (is_triangle && truth.divisor < smallest_divisor) return Difference::underflow;
    }
    if (truth.standing == Standing::grazing || truth.standing == Standing::tiny)
      return difference_of(truth.standing);
  }
  return Difference::unexplained;
}

bool Oracle::are_coplanar(const Testimony& a, const Testimony& b) const {
  const auto normal_of = [&](const Testimony& testimony) -> Vec3 {
    const Mesh* mesh = geometry_->mesh(testimony.mesh);
    if (!mesh) return {};
    const auto [i, j, k] = mesh->triangles[testimony.primitive];
    const Vec3 normal = cross(normalize(mesh->positions[j] - mesh->positions[i]),
                              normalize(mesh->positions[k] - mesh->positions[i]));
    const Transform* const to_world = geometry_->to_world(testimony.instance);
    return to_world ? to_world->front(normal) : normalize(normal);
  };
  return length_of(cross(normal_of(a), normal_of(b))) <= parallel_sine;
}

}  // namespace twinray
