// SPDX-License-Identifier: Apache-2.0
#include "core/interiors.h"

#include <algorithm>
#include <type_traits>

#include "core/elementary.h"

namespace twinray {
namespace {

constexpr int slots = 4;

std::uint64_t slot(std::uint64_t bits, int i) { return bits >> (16 * i) & 0xffff; }

/// Whether a material is this one or, if that is a mix, a part of it.
bool is_part(std::uint32_t index, std::uint32_t of, std::span<const Material> materials) {
  const Mix* const mix = std::get_if<Mix>(&materials[of].model);
  return index == of ||
         (mix && (is_part(index, mix->first, materials) || is_part(index, mix->second, materials)));
}

struct Immersed {
  float ior;

  template <typename Model>
  SurfaceModel operator()(Model model) const {
    if constexpr (requires { model.ior; }) model.ior /= ior;
    if constexpr (requires { model.specular_ior; }) model.specular_ior /= ior;
    if constexpr (requires { model.coat_ior; }) model.coat_ior /= ior;
    if constexpr (requires { model.eta; }) model.eta = model.eta / ior, model.k = model.k / ior;
    return model;
  }
};

}  // namespace

void Interiors::leave(std::uint32_t material) {
  for (int i = 0; i < slots; ++i) {
    if (slot(bits_, i) != material + 1) continue;
    const std::uint64_t later = (std::uint64_t(1) << (16 * i)) - 1;
    bits_ = (bits_ & later) | (bits_ >> 16 & ~later);
    return;
  }
}

std::uint32_t Interiors::entered(std::uint32_t material, std::span<const Material> materials) const {
  for (int i = 0; i < slots && slot(bits_, i) != 0; ++i)
    if (const auto index = std::uint32_t(slot(bits_, i) - 1); is_part(index, material, materials))
      return index;
  return none;
}

std::uint32_t Interiors::prevailing(std::span<const Material> materials) const {
  std::uint32_t found = none;
  for (int i = 0; i < slots && slot(bits_, i) != 0; ++i) {
    const auto material = std::uint32_t(slot(bits_, i) - 1);
    if (found == none || materials[material].interior.priority > materials[found].interior.priority)
      found = material;
  }
  return found;
}

Interiors Interiors::shared_with(Interiors other) const {
  Interiors shared;
  for (int i = slots - 1; i >= 0; --i) {
    if (slot(bits_, i) == 0) continue;
    const auto material = std::uint32_t(slot(bits_, i) - 1);
    const std::uint64_t before = other.bits();
    other.leave(material);
    if (other.bits() != before) shared.enter(material);
  }
  return shared;
}

void forget_clear_interiors(std::span<Material> materials) {
  const auto matters = [](const Material& material) {
    return !is_black(material.interior.extinction()) || material.interior.priority != 0;
  };
  if (std::any_of(materials.begin(), materials.end(), matters)) return;
  for (Material& material : materials) material.interior.is_clear = false;
}

float ior_of(const SurfaceModel& model) {
  return std::visit(
      [](const auto& m) {
        if constexpr (requires { m.ior; }) return m.ior;
        if constexpr (requires { m.specular_ior; }) return m.specular_ior;
        return 1.0f;
      },
      model);
}

bool has_flights(std::span<const Material> materials) {
  return std::any_of(materials.begin(), materials.end(), [](const Material& material) {
    return scatters(material.interior) || material.interior.density != no_density;
  });
}

bool has_glow(std::span<const Material> materials) {
  return std::any_of(materials.begin(), materials.end(),
                     [](const Material& material) { return material.interior.emits(); });
}

bool has_uneven_glow(std::span<const Material> materials) {
  return std::any_of(materials.begin(), materials.end(), [](const Material& material) {
    return material.interior.emits() && material.interior.glow.is_uneven();
  });
}

const Interior* medium_in(std::span<const Material> materials, const Interiors& interiors) {
  return interiors.empty() ? nullptr : &materials[interiors.prevailing(materials)].interior;
}

Rgb transmittance(std::span<const Material> materials, const Interiors& interiors, float length) {
  if (interiors.empty()) return {1, 1, 1};
  return transmittance(materials[interiors.prevailing(materials)].interior.extinction(), length);
}

Rgb transmittance(const Rgb& extinction, float amount) {
  const auto channel = [&](float e) { return e >= least_extinction ? exp_of(-e * amount) : 1.0f; };
  return {channel(extinction.r), channel(extinction.g), channel(extinction.b)};
}

float opaque_amount(const Rgb& extinction) {
  constexpr float opaque = 88;  // exp_of() of less is 0.
  float most = 0;
  for (const float e : {extinction.r, extinction.g, extinction.b})
    if (e >= least_extinction) most = std::max(most, opaque / e);
  return most;
}

Surroundings surroundings_of(std::span<const Material> materials, std::uint32_t material, bool is_inside,
                             Interiors interiors) {
  const Material& surface = materials[material];
  if (is_inside) interiors.leave(material);
  const std::uint32_t around = interiors.prevailing(materials);
  const bool is_body = lets_light_in(surface);
  if (around == Interiors::none || (is_body && surface.interior.priority == 0)) return {};
  const int priority = materials[around].interior.priority;
  if (priority == 0) return {};
  return {is_body && priority > surface.interior.priority, ior_of(materials[around].model)};
}

SurfaceModel immersed(const SurfaceModel& model, float ior) { return std::visit(Immersed{ior}, model); }

}  // namespace twinray
