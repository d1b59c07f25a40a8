// SPDX-License-Identifier: Apache-2.0
// What of a scene its file wants to be seen.
#pragma once
#include <set>
#include <string>
#include <vector>

#include "io/collada/document.h"

namespace twinray {

/// The <render>s of the first <evaluate_scene> of a visual scene that is not disabled.
std::vector<XmlElement> renders_of(const XmlElement& visual_scene);

/// The layers that a visual scene's <render>s name; all, where one of them names none.
class SceneLayers {
 public:
  SceneLayers() = default;
  explicit SceneLayers(const XmlElement& visual_scene);

  /// Whether what a node instances is to be seen: it belongs to one of the layers.
  bool show(const XmlElement& node) const;

 private:
  std::set<std::string> names_;
};

/// Whether an exporter's <visibility> in the <extra> of a node is 0 or false: it and all below it are hidden.
bool is_hidden(const XmlElement& node);

}  // namespace twinray
