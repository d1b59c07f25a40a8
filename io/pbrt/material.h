// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/material.h"
#include "io/pbrt/context.h"
#include "io/pbrt/parameters.h"
#include "io/pbrt/texture.h"

namespace twinray {

/// The materials of a scene, in the order of the statements that make them. The first one is what holds
/// before any: diffuse, 0.5.
class PbrtMaterials {
 public:
  explicit PbrtMaterials(PbrtContext& context);

  /// The index of the material that a Material statement describes.
  std::uint32_t add(const std::string& type, const PbrtParameters& parameters);
  void add_named(const std::string& name, const PbrtParameters& parameters);
  /// The index of a named material; it may be made later.
  std::uint32_t named(const std::string& name, const PbrtPlace& place);
  /// Whether a material is pbrt's "interface": no surface at all.
  bool is_interface(std::uint32_t index) const { return entries_[index].is_interface; }
  /// Throws Error where a name was used that no statement gave.
  void check_all_made() const;

  PbrtTextures textures;
  std::vector<Material> materials;

 private:
  struct Entry {
    bool is_made = true, is_interface = false;
    PbrtPlace first_use;
    int mixes = 0;  ///< So many are in each other.
  };
  void make(std::uint32_t index, const std::string& type, const PbrtParameters& parameters);
  Mix read_mix(std::uint32_t index, float amount, const PbrtParameters& parameters);
  std::uint32_t new_entry(const std::string& name, const Entry& entry);

  PbrtContext& context_;
  std::vector<Entry> entries_;
  std::map<std::string, std::uint32_t> named_;
};

}  // namespace twinray
