// SPDX-License-Identifier: Apache-2.0
#include "integrators/interaction.h"

#include "core/surface_model.h"
#include "core/warp.h"

namespace twinray {
namespace {

/// What a path is in at a surface. A body of a mix has at each point the surface of one of its parts: seen
/// from inside, that part stands for the one by which the path went in, so that it is left.
Interiors here(const Scene& scene, const SurfacePoint& point, std::uint32_t material, Side side,
               Interiors interiors) {
  const std::uint32_t body = scene.bindings[point.shape].material;
  if (side == Side::outside || body == material) return interiors;
  const std::uint32_t entered = interiors.entered(body, scene.materials);
  if (entered == material || entered == Interiors::none) return interiors;
  interiors.leave(entered);
  if (has_interior(scene.materials[material])) interiors.enter(material);
  return interiors;
}

/// What is behind a surface to a viewer who sees its outside or inside.
Interiors behind(const Material& material, std::uint32_t index, Side side, Interiors before) {
  if (!has_interior(material)) return before;
  if (side == Side::outside)
    before.enter(index);
  else
    before.leave(index);
  return before;
}

float share(float part, float whole) { return part < whole ? part / whole : whole > 0 ? 1.0f : 0.0f; }

}  // namespace

Side side_of(const SurfacePoint& point, const Vec3& wo) {
  const bool is_before = dot(point.geometric_normal, wo) > 0;
  const bool points_outside = dot(point.geometric_normal, point.shading_normal) >= 0;
  return is_before == points_outside ? Side::outside : Side::inside;
}

Rgb Interaction::diffuse_share(const Vec3& wi) const {
  if (is_emerging()) return {1, 1, 1};
  const Vec3 local = to_local(wi);
  const Rgb all = value_of_part(local).value;
  Rgb diffuse = bsdf_->diffuse(wo_local_, local);
  if (part_ == Part::above) diffuse = at_least_zero(diffuse - bsdf_->of_below(wo_local_, local));
  return {share(diffuse.r, all.r), share(diffuse.g, all.g), share(diffuse.b, all.b)};
}

Interaction::Meeting Interaction::meet(const Scene& scene, const SurfacePoint& point, const Vec3& wo,
                                       const Interiors& interiors) {
  const std::uint32_t material = material_at(scene, point);
  const Side side = side_of(point, wo);
  return {material, side, here(scene, point, material, side, interiors)};
}

Interiors Interaction::interiors_behind(const Scene& scene, const SurfacePoint& point, const Vec3& wo,
                                        const Interiors& before) {
  const Meeting met = meet(scene, point, wo, before);
  return behind(scene.materials[met.material], met.material, met.side, met.within);
}

Interaction::Interaction(const BsdfTable& bsdfs, const SurfacePoint& point, const Vec3& wo,
                         const Viewing& viewing)
    : Interaction(bsdfs, point, wo, viewing, meet(bsdfs.scene(), point, wo, viewing.interiors)) {}

Interaction::Interaction(const BsdfTable& bsdfs, const SurfacePoint& point, const Vec3& wo,
                         const Viewing& viewing, const Meeting& meeting)
    : point_(point),
      material_(meeting.material),
      wo_(wo),
      facing_normal_(facing(point.geometric_normal, wo)),
      shading_(shading_frame(bsdfs.scene(), bsdfs.scene().materials[material_], point, wo)),
      wo_local_(shading_.frame.to_local(wo)),
      bsdf_(bsdfs.at(material_, point, meeting.side, {viewing.materials, meeting.within})),
      before_(viewing.interiors),
      behind_(behind(bsdfs.scene().materials[material_], material_, meeting.side, meeting.within)),
      side_(meeting.side),
      is_fibre_(std::holds_alternative<Hair>(bsdfs.scene().materials[material_].model)) {}

Interaction::Interaction(PhaseFunction phase, std::uint32_t material, const SurfacePoint& point,
                         const Vec3& wo, const Interiors& interiors)
    : point_(point),
      material_(material),
      wo_(wo),
      facing_normal_(wo),
      shading_{Frame(wo)},
      wo_local_{0, 0, 1},
      bsdf_(Bsdf(Interface{})),
      phase_(phase),
      before_(interiors),
      behind_(interiors) {}

Interaction Interaction::in_medium(const Scene& scene, const Vec3& position, const Vec3& wo,
                                   const Viewing& viewing) {
  const std::uint32_t medium = viewing.interiors.prevailing(scene.materials);
  SurfacePoint point;
  point.position = position;
  point.geometric_normal = point.shading_normal = wo;
  return {PhaseFunction(scene.materials[medium].interior.anisotropy), medium, point, wo, viewing.interiors};
}

Interaction Interaction::emerging(const BsdfTable& bsdfs, const SurfacePoint& point, std::uint32_t material,
                                  const Vec3& outward, const Viewing& viewing) {
  const Vec3 normal = facing(point.geometric_normal, outward);
  Interaction at(bsdfs, point, normal, viewing, {material, side_of(point, normal), viewing.interiors});
  at.part_ = Part::emerging;
  return at;
}

bool Interaction::is_below(float lobe) const {
  const BelowSurface below = bsdf_->below(wo_local_);
  return lobe >= below.first && lobe < below.first + below.probability;
}

BsdfSample Interaction::sample_below(Vec2 u) const {
  const BelowSurface below = bsdf_->below(wo_local_);
  const auto channel = [](float part, float whole) { return whole > 0 ? part / whole : 0; };
  const Rgb &all = below.albedo, &base = below.reflectance;
  const Rgb passed{channel(all.r, base.r), channel(all.g, base.g), channel(all.b, base.b)};
  const Vec3 above = square_to_cosine_hemisphere(u);
  return {.wi = {above.x, above.y, -above.z},
          .value = passed / pi,
          .pdf = below.probability * cosine_hemisphere_pdf(above.z),
          .is_diffuse = true};
}

BsdfValue Interaction::value_of_layers(const Vec3& local) const {
  const float pdf = local.z > 0 ? cosine_hemisphere_pdf(local.z) : 0;
  if (is_emerging()) return {bsdf_->from_below(local), pdf};
  const BsdfValue all = bsdf_->evaluate(wo_local_, local);
  return {at_least_zero(all.value - bsdf_->of_below(wo_local_, local)),
          std::max(all.pdf - pdf * bsdf_->below(wo_local_).probability, 0.0f)};
}

BsdfValue Interaction::phase_value(const Vec3& local) const {
  const float density = phase_->evaluate(-local.z);
  return {{density, density, density}, density};
}

BsdfSample Interaction::sample(float lobe, Vec2 u) const {
  if (phase_) {
    const Vec3 wi = phase_->sample(u);
    const auto [value, pdf] = phase_value(wi);
    return {.wi = wi, .value = value, .pdf = pdf};
  }
  if (is_emerging()) {
    const Vec3 wi = square_to_cosine_hemisphere(u);
    const auto [value, pdf] = value_of_layers(wi);
    return {.wi = wi, .value = value, .pdf = pdf, .is_diffuse = true};
  }
  if (goes_below(lobe)) return sample_below(u);
  BsdfSample sample = bsdf_->sample(wo_local_, lobe, u);
  if (part_ == Part::whole || sample.pdf == 0 || sample.is_delta) return sample;
  const auto [value, pdf] = value_of_layers(sample.wi);
  sample.value = value;
  sample.pdf = pdf;
  return sample;
}

}  // namespace twinray
