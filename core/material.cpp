// SPDX-License-Identifier: Apache-2.0
#include "core/material.h"

namespace twinray {
namespace {

struct LetsLightIn {
  bool operator()(const Refraction&) const { return true; }
  bool operator()(const Glass&) const { return true; }
  bool operator()(const Interface&) const { return true; }
  bool operator()(const Dielectric& model) const { return !model.is_thin; }
  bool operator()(const Principled& model) const {
    return model.transmission_weight > 0 && model.base_metalness < 1 && !model.geometry_thin_walled;
  }
  template <typename Model>
  bool operator()(const Model&) const {
    return false;
  }
};

}  // namespace

bool lets_light_in(const SurfaceModel& model) { return std::visit(LetsLightIn{}, model); }

}  // namespace twinray
