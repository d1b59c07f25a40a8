// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace twinray {

/// The names of a scene's assets, each once, in the order of their first use.
class AssetNames {
 public:
  /// The index of a name.
  std::uint32_t index_of(const std::string& name) {
    const auto [known, is_new] = indices_.try_emplace(name, std::uint32_t(names_.size()));
    if (is_new) names_.push_back(name);
    return known->second;
  }
  const std::vector<std::string>& names() const { return names_; }

 private:
  std::vector<std::string> names_;
  std::map<std::string, std::uint32_t> indices_;
};

}  // namespace twinray
