// SPDX-License-Identifier: Apache-2.0
#include "core/lobes/principled.h"

#include <algorithm>
#include <cmath>

#include "core/fresnel.h"
#include "core/warp.h"

namespace twinray {
namespace {

float mix(float a, float b, float part) { return a + (b - a) * part; }
Rgb mix(const Rgb& a, const Rgb& b, float part) { return a + (b - a) * part; }

/// The alphas of a roughness, longer along the tangent; OpenPBR's.
Ggx facets_of(float roughness, float anisotropy) {
  const float alpha = roughness * roughness, narrow = 1 - anisotropy;
  const float along = alpha * std::sqrt(2 / (1 + narrow * narrow));
  return {std::clamp(along, least_alpha, 1.0f), std::clamp(along * narrow, least_alpha, 1.0f)};
}

/// How widely facets scatter, from 0 of a mirror to 1.
float width_of(const Ggx& facets) { return std::sqrt(std::sqrt(facets.alpha_x() * facets.alpha_y())); }

/// A rough coat spreads what is below it as well.
float coated_roughness(const Principled& m) {
  const auto fourth = [](float x) { return x * x * x * x; };
  const float spread = std::min(1.0f, fourth(m.specular_roughness) + 2 * fourth(m.coat_roughness));
  return mix(m.specular_roughness, std::sqrt(std::sqrt(spread)), m.coat_weight);
}

/// The index of the base to what is above it, after OpenPBR's weight: a factor of the reflectance along the
/// normal.
float weighted_ior(const Principled& m, float above) {
  const float ior = m.specular_ior / above;
  const float scaled = std::min(std::sqrt(m.specular_weight) * (ior - 1) / (ior + 1), 0.99999f);
  return (1 + scaled) / (1 - scaled);
}

/// Of the gloss to the coat; as in OpenPBR, a denser coat is taken the other way round.
float gloss_ior(const Principled& m, bool is_inside) {
  const float ior = weighted_ior(m, is_inside ? 1 : mix(1, m.coat_ior, m.coat_weight));
  return ior < 1 ? 1 / ior : ior;
}

/// On the side of a surface that is seen; below the coat.
std::optional<PartialFilm> film_of(const Principled& m, float above) {
  if (m.thin_film_weight == 0) return std::nullopt;
  constexpr float nanometers = 1000;
  return PartialFilm{.film = ThinFilm(m.thin_film_thickness * nanometers, m.thin_film_ior, above),
                     .weight = m.thin_film_weight,
                     .coat_ior = above};
}

/// Of light that passes a layer in and out, by what that lets through along both ways and in the mean. What
/// is scattered widely comes out in the mean; what is mirrored meets the layer along the same angle again and
/// again, until it has passed.
float past_both(float in, float out, float mean, float width) {
  const float both = in * out;
  return both > 0 ? both / mix(std::sqrt(both), mean, width) : 0;
}

/// Of light from all directions: the integral of 2 cos f(cos).
template <typename F>
Rgb average_over_directions(const F& f) {
  constexpr int parts = 16;
  Rgb sum;
  for (int i = 0; i < parts; ++i) sum += f(std::sqrt((float(i) + 0.5f) / parts));
  return sum / parts;
}

/// Channel by channel; of nothing it is nothing.
Rgb part_of(const Rgb& part, const Rgb& whole) {
  const auto channel = [](float p, float w) { return w > 0 ? p / w : 0; };
  return {channel(part.r, whole.r), channel(part.g, whole.g), channel(part.b, whole.b)};
}

std::variant<RoughDielectricLobe, ThinDielectricLobe> boundary_of(const Principled& m, const Ggx& facets,
                                                                  bool is_inside) {
  const Rgb tint = m.transmission_depth > 0 ? white : m.transmission_color;
  const float ior = weighted_ior(m, 1);
  // Both sides of a sheet have a film; where nothing else is there, the film is the sheet.
  if (m.geometry_thin_walled || ior == 1)
    return ThinDielectricLobe(ior, m.specular_color, tint, film_of(m, 1),
                              !m.geometry_thin_walled || ior == 1);
  std::optional<PartialFilm> film = film_of(m, 1);
  if (film) film->is_below = is_inside;
  return RoughDielectricLobe(facets, is_inside ? 1 / ior : ior, m.specular_color, tint, film);
}

}  // namespace

TintedFresnel::TintedFresnel(const Rgb& normal, const Rgb& rim) : normal_(normal) {
  // The cosine of 82 degrees, nearly, where Schlick's curve is times the tint.
  constexpr float c = 1.0f / 7, d = 1 - c;
  const Rgb schlick = normal + (white - normal) * (d * d * d * d * d);
  dip_ = schlick * (white - rim) / (c * d * d * d * d * d * d);
}

Rgb TintedFresnel::operator()(float cosine) const {
  const float x = 1 - cosine, x5 = x * x * x * x * x;
  return within_unit(normal_ + (white - normal_) * x5 - dip_ * (cosine * x5 * x));
}

Rgb TintedFresnel::average() const {
  // Of the curve before it is cut off at 0, where a dark metal's tint takes more than there is.
  const Rgb mean = normal_ + (white - normal_) / 21 - dip_ / 126;
  return {std::max(0.0f, mean.r), std::max(0.0f, mean.g), std::max(0.0f, mean.b)};
}

PrincipledLobe::PrincipledLobe(const Principled& m, bool is_inside)
    : metal_(m.base_metalness),
      opaque_((1 - m.base_metalness) * (1 - m.transmission_weight)),
      clear_((1 - m.base_metalness) * m.transmission_weight),
      specular_weight_(m.specular_weight),
      coat_weight_(is_inside ? 0 : m.coat_weight),
      fuzz_weight_(is_inside ? 0 : m.fuzz_weight),
      specular_color_(m.specular_color),
      fuzz_color_(m.fuzz_color),
      facets_(
          facets_of(is_inside ? m.specular_roughness : coated_roughness(m), m.specular_roughness_anisotropy)),
      width_(width_of(facets_)),
      multiple_(facets_),
      metal_fresnel_(m.base_color * m.base_weight, m.specular_color),
      metal_average_(metal_fresnel_.average()),
      gloss_(gloss_ior(m, is_inside), facets_),
      gloss_average_(white * gloss_.average_reflectance()),
      subsurface_weight_(m.subsurface_weight),
      subsurface_color_(m.subsurface_color),
      reflectance_(mix(m.base_color * m.base_weight, m.subsurface_color, m.subsurface_weight)),
      diffuse_(gloss_.diffuse_below(reflectance_)),
      subsurface_(part_of(m.subsurface_color * m.subsurface_weight, reflectance_)),
      rough_(white, m.base_diffuse_roughness) {
  if (clear_ > 0) boundary_ = boundary_of(m, facets_, is_inside);
  if (!is_inside) set_film(m);
  metal_multiple_ = multiple_.absorption(metal_average_);
  if (coat_weight_ > 0) set_coat(m);
  if (fuzz_weight_ == 0) return;
  fuzz_.emplace(m.fuzz_roughness);
  through_.fuzz = 1 - fuzz_weight_ * fuzz_->average_reflectance();
}

void PrincipledLobe::set_coat(const Principled& m) {
  const Ggx facets = facets_of(m.coat_roughness, 0);
  coat_.emplace(m.coat_ior, facets);
  coat_width_ = width_of(facets);
  through_.coat = 1 - coat_weight_ * coat_->average_reflectance();
  // What the coat reflects back down is absorbed in part, once more and again.
  const float back = coat_->average_reflectance_below();
  const auto darkened = [&](float albedo) {
    return mix(1, albedo < 1 ? (1 - back) / (1 - albedo * back) : 1, m.coat_darkening);
  };
  const Rgb base = base_albedo();
  const Rgb darkening{darkened(base.r), darkened(base.g), darkened(base.b)};
  below_coat_ = mix(white, m.coat_color * darkening, coat_weight_);
}

void PrincipledLobe::set_film(const Principled& m) {
  film_ = film_of(m, mix(1, m.coat_ior, m.coat_weight));
  if (!film_) return;
  metal_ior_ = index_of_reflectance(m.base_color * m.base_weight);
  metal_average_ = average_over_directions([&](float cosine) { return metal_reflectance(cosine); });
  gloss_average_ = average_over_directions(
      [&](float cosine) { return white - through_gloss(cosine, gloss_.reflectance(cosine)); });
  // As Coat::diffuse_below, of a boundary that lets so much through in each channel, both ways.
  const float squared_ior = gloss_.ior() * gloss_.ior();
  const Rgb& color = reflectance_;
  const auto channel = [&](float r, float reflected) {
    const float kept = (1 - r) * squared_ior + r * (1 - reflected);
    return kept > 0 ? r / kept : 0;
  };
  diffuse_ = {channel(color.r, gloss_average_.r), channel(color.g, gloss_average_.g),
              channel(color.b, gloss_average_.b)};
}

std::optional<BarePrincipled> PrincipledLobe::bare() const {
  const bool has_more = film_ || boundary_ || coat_ || fuzz_ || subsurface_weight_ > 0;
  if (has_more || !facets_.has_one_alpha()) return std::nullopt;
  return BarePrincipled{.metal = metal_ * specular_weight_,
                        .opaque = opaque_,
                        .metal_fresnel = metal_fresnel_,
                        .multiple = multiple_,
                        .metal_multiple = metal_multiple_,
                        .gloss = gloss_,
                        .specular_color = specular_color_,
                        .diffuse = diffuse_,
                        .rough = rough_};
}

Rgb PrincipledLobe::metal_reflectance(float cosine) const {
  const Rgb bare = metal_fresnel_(cosine);
  if (!film_ || metal_ == 0) return bare;
  // The film takes away from what is absorbed, or adds to it, what it does where the metal's index is one of
  // a dielectric: so a film of no thickness changes nothing.
  const float bent = film_->below_coat(cosine);
  const Rgb filmed = film_->film.reflectance(bent, metal_ior_);
  const auto channel = [&](float r, float with_film, float index) {
    const float without = fresnel_dielectric(bent, index);
    return without < 1 ? 1 - (1 - r) * (1 - with_film) / (1 - without) : r;
  };
  const Rgb changed =
      within_unit(Rgb{channel(bare.r, filmed.r, metal_ior_.r), channel(bare.g, filmed.g, metal_ior_.g),
                      channel(bare.b, filmed.b, metal_ior_.b)});
  return mix(bare, changed, film_->weight);
}

Rgb PrincipledLobe::gloss_reflectance(float cosine) const {
  return film_ ? film_->reflectance(cosine, gloss_.ior()) : white * fresnel_dielectric(cosine, gloss_.ior());
}

Rgb PrincipledLobe::through_gloss(float cosine, float reflectance) const {
  const Rgb bare = white * (1 - reflectance);
  if (!film_) return bare;
  // Of what meets facets as it meets the surface, all but what they lose to each other.
  const Rgb change = gloss_reflectance(cosine) - white * fresnel_dielectric(cosine, gloss_.ior());
  return within_unit(bare - change * (1 - multiple_.loss(cosine)));
}

Rgb PrincipledLobe::base_albedo() const {
  const Rgb reflected = gloss_average_, through = white - reflected;
  const float loss = multiple_.average_loss();
  const Rgb metal = metal_average_ * (1 - loss) + metal_multiple_ * loss;
  const Rgb clear =
      boundary_ ? std::visit([](const auto& lobe) { return lobe.albedo(); }, *boundary_) : Rgb{};
  return metal * (metal_ * specular_weight_) + clear * clear_ +
         (specular_color_ * reflected + diffuse_ * (through * through)) * opaque_;
}

Rgb PrincipledLobe::albedo() const {
  const Rgb coat = white * (1 - through_.coat), fuzz = fuzz_color_ * (1 - through_.fuzz);
  return fuzz + (coat + below_coat_ * base_albedo() * through_.coat) * through_.fuzz;
}

BsdfValue PrincipledLobe::evaluate_opaque(const Seen& from, const Vec3& wi, const Layers& out,
                                          const Rgb& of_facets) const {
  const Vec3& wo = from.wo;
  const Rgb of_diffuse = through_layers(from.past, out, 1);
  const FacetReflection facets = facets_.reflection(wo, wi);
  BsdfValue all{{}, from.choice.facets * facets.pdf + from.choice.diffuse * cosine_hemisphere_pdf(wi.z)};
  if (metal_ > 0) {
    const Rgb once = metal_reflectance(facets.cosine) * facets.value;
    const Rgb several = metal_multiple_ * multiple_.evaluate(wo, wi);
    all.value += (once * of_facets + several * of_diffuse) * (metal_ * specular_weight_);
  }
  if (opaque_ > 0) {
    const Rgb gloss = specular_color_ * (gloss_reflectance(facets.cosine) * facets.value);
    const Rgb through = from.through_gloss * through_gloss(wi);
    all.value += (gloss * of_facets + matte(wo, wi) * through * of_diffuse) * opaque_;
  }
  return all;
}

PrincipledLobe::Layers PrincipledLobe::past(float cosine) const {
  if (!(cosine > 0)) return through_;
  return {coat_ ? 1 - coat_weight_ * coat_->reflectance(cosine) : 1,
          fuzz_ ? 1 - fuzz_weight_ * fuzz_->reflectance(cosine) : 1};
}

Rgb PrincipledLobe::through_layers(const Layers& in, const Layers& out, float width) const {
  return below_coat_ * past_both(in.coat, out.coat, through_.coat, width) *
         past_both(in.fuzz, out.fuzz, through_.fuzz, width);
}

BsdfValue PrincipledLobe::evaluate(const Vec3& wo, const Vec3& wi) const {
  if (!(wo.z > 0) || wi.z == 0) return {};
  return from(wo, [&](const Seen& seen) { return evaluate(seen, wi); });
}

BsdfValue PrincipledLobe::evaluate(const Seen& from, const Vec3& wi) const {
  const Vec3& wo = from.wo;
  const Choice& p = from.choice;
  const Layers out = past(wi.z);
  const Rgb of_facets = through_layers(from.past, out, wi.z > 0 ? width_ : 1);
  BsdfValue all = wi.z > 0 ? evaluate_opaque(from, wi, out, of_facets) : BsdfValue{};
  const auto add = [&](const Rgb& value, float pdf) { all = {all.value + value, all.pdf + pdf}; };
  if (boundary_) {
    const BsdfValue clear = std::visit([&](const auto& lobe) { return lobe.evaluate(wo, wi); }, *boundary_);
    add(clear.value * of_facets * clear_, p.clear * clear.pdf);
  }
  if (coat_ && wi.z > 0) {
    const FacetReflection coat = coat_->reflection(wo, wi);
    const float of_coat = past_both(from.past.fuzz, out.fuzz, through_.fuzz, coat_width_);
    add(white * (coat_weight_ * coat.value * of_coat), p.coat * coat.pdf);
  }
  if (fuzz_ && wi.z > 0)
    add(fuzz_color_ * (fuzz_weight_ * fuzz_->evaluate(wo, wi)), p.fuzz * cosine_hemisphere_pdf(wi.z));
  return all;
}

Rgb PrincipledLobe::diffuse(const Vec3& wo, const Vec3& wi) const {
  if (!(wo.z > 0 && wi.z > 0)) return {};
  return from(wo, [&](const Seen& seen) {
    const Rgb base = matte(wo, wi) * through_all(seen, wi);
    return fuzz_ ? base + fuzz_color_ * (fuzz_weight_ * fuzz_->evaluate(wo, wi)) : base;
  });
}

BelowSurface PrincipledLobe::below(const Vec3& wo) const {
  if (!(wo.z > 0)) return {};
  return from(wo, [&](const Seen& seen) -> BelowSurface {
    // In the mean about all directions, through_layers() leaves what passes along wo.
    const Rgb through =
        seen.through_gloss * (white - gloss_average_) * through_layers(seen.past, through_, 1) * opaque_;
    return {seen.choice.fuzz, seen.choice.diffuse * subsurface_weight_, diffuse_ * subsurface_ * through,
            subsurface_color_};
  });
}

Rgb PrincipledLobe::of_below(const Vec3& wo, const Vec3& wi) const {
  if (!(wo.z > 0 && wi.z > 0)) return {};
  return from(wo,
              [&](const Seen& seen) { return diffuse_ * subsurface_ * through_all(seen, wi) * (1 / pi); });
}

Rgb PrincipledLobe::from_below(const Vec3& wi) const {
  if (!(wi.z > 0)) return {};
  const Layers out = past(wi.z);
  const float layers = out.coat * out.fuzz / (through_.coat * through_.fuzz);
  return part_of(through_gloss(wi), white - gloss_average_) * (layers / pi);
}

PrincipledLobe::Seen PrincipledLobe::seen(const Vec3& wo) const {
  if (!(wo.z > 0)) return {};
  Seen seen{.wo = wo, .through_gloss = opaque_ > 0 ? through_gloss(wo) : white, .past = past(wo.z)};
  seen.choice = choice(seen);
  return seen;
}

PrincipledLobe::Choice PrincipledLobe::choice(const Seen& from) const {
  const float cosine = from.wo.z;
  float facets = 0, diffuse = 0;
  if (opaque_ > 0) {
    const Rgb& through = from.through_gloss;
    const float reflected = film_ ? max_component(white - through) : gloss_.reflectance(from.wo);
    facets = opaque_ * max_component(specular_color_) * reflected;
    diffuse = opaque_ * max_component(diffuse_) * max_component(through);
  }
  if (const float metal = metal_ * specular_weight_; metal > 0) {
    const float loss = multiple_.loss(from.wo);
    facets += metal * max_component(metal_reflectance(cosine)) * (1 - loss);
    diffuse += metal * max_component(metal_multiple_) * loss;
  }
  const float sum = facets + diffuse + clear_;
  const float fuzz = max_component(fuzz_color_) * (1 - from.past.fuzz);
  const float coat = (1 - fuzz) * (1 - from.past.coat);
  const float rest = 1 - fuzz - coat;
  if (!(sum > 0)) return {fuzz, coat, 0, rest, 0};
  return {fuzz, coat, rest * facets / sum, rest * diffuse / sum, rest * clear_ / sum};
}

BsdfSample PrincipledLobe::sample(const Vec3& wo, float lobe, Vec2 u) const {
  if (!(wo.z > 0)) return {};
  return from(wo, [&](const Seen& seen) { return sample(seen, lobe, u); });
}

BsdfSample PrincipledLobe::sample(const Seen& from, float lobe, Vec2 u) const {
  const Vec3& wo = from.wo;
  const Choice& p = from.choice;
  const float diffuse = p.fuzz + p.diffuse, coat = diffuse + p.coat, facets = coat + p.facets;
  if (lobe >= facets && p.clear > 0)
    return sample_clear(from, std::min((lobe - facets) / p.clear, 0x1.fffffep-1f), u);
  const Vec3 wi = lobe < diffuse ? square_to_cosine_hemisphere(u)
                  : lobe < coat  ? coat_->sample(wo, u)
                                 : reflected(wo, facets_.sample_visible(wo, u));
  if (!(wi.z > 0)) return {};
  const auto [value, pdf] = evaluate(from, wi);
  return {.wi = wi, .value = value, .pdf = pdf, .is_diffuse = lobe < diffuse};
}

BsdfSample PrincipledLobe::sample_clear(const Seen& from, float lobe, Vec2 u) const {
  BsdfSample sample = std::visit([&](const auto& l) { return l.sample(from.wo, lobe, u); }, *boundary_);
  if (sample.pdf == 0 || sample.wi.z == 0) return {};
  if (sample.is_delta) {
    const float width = sample.wi.z > 0 ? 0 : 1;
    sample.value = sample.value * clear_ * through_layers(from.past, past(sample.wi.z), width);
    sample.pdf *= from.choice.clear;
    return sample;
  }
  const auto [value, pdf] = evaluate(from, sample.wi);
  sample.value = value;
  sample.pdf = pdf;
  return sample;
}

}  // namespace twinray
