// SPDX-License-Identifier: Apache-2.0
// Principled surfaces (core/material.h) that tests are about.
#pragma once
#include "core/material.h"

namespace twinray::test {

inline Principled varnished() {
  Principled m;
  m.base_color = {0.7f, 0.3f, 0.1f};
  m.base_diffuse_roughness = 0.4f;
  m.base_metalness = 0.3f;
  m.specular_roughness = 0.6f;
  m.specular_color = {0.9f, 0.8f, 1};
  m.coat_weight = 0.7f;
  m.coat_color = {1, 0.9f, 0.6f};
  m.coat_roughness = 0.5f;
  m.fuzz_weight = 0.5f;
  m.fuzz_color = {0.8f, 0.2f, 0.9f};
  return m;
}

inline Principled brushed() {
  Principled m;
  m.base_metalness = 1;
  m.specular_roughness = 0.6f;
  m.specular_roughness_anisotropy = 0.7f;
  return m;
}

inline Principled clear() {
  Principled m;
  m.transmission_weight = 0.8f;
  m.transmission_color = {0.5f, 0.9f, 0.7f};
  m.specular_roughness = 0.7f;
  m.coat_weight = 0.5f;
  m.coat_roughness = 0.6f;
  return m;
}

inline Principled sheet() {
  Principled m = clear();
  m.geometry_thin_walled = true;
  return m;
}

/// A film on gloss.
inline Principled oiled() {
  Principled m;
  m.base_color = {0.4f, 0.3f, 0.5f};
  m.specular_roughness = 0.5f;
  m.thin_film_weight = 1;
  m.thin_film_thickness = 0.35f;
  m.thin_film_ior = 1.8f;
  return m;
}

/// A film on a metal, below a coat.
inline Principled anodised() {
  Principled m = oiled();
  m.base_color = {0.8f, 0.7f, 0.6f};
  m.base_metalness = 1;
  m.thin_film_weight = 0.8f;
  m.coat_weight = 0.5f;
  m.coat_roughness = 0.5f;
  return m;
}

inline Principled bubble() {
  Principled m = oiled();
  m.specular_ior = 1;
  m.thin_film_ior = 1.33f;
  m.transmission_weight = 1;
  m.geometry_thin_walled = true;
  return m;
}

/// Denser than the tables of reflectances reach.
inline Principled dense() {
  Principled m;
  m.specular_ior = 10;
  m.specular_roughness = 0.7f;
  return m;
}

/// A film on the boundary of a clear body.
inline Principled iridescent() {
  Principled m = clear();
  m.thin_film_weight = 0.9f;
  m.thin_film_thickness = 0.35f;
  m.thin_film_ior = 2;
  return m;
}

/// Nothing of it absorbs.
inline Principled whitened(Principled m) {
  m.base_color = m.specular_color = m.transmission_color = m.coat_color = m.fuzz_color = white;
  return m;
}

}  // namespace twinray::test
