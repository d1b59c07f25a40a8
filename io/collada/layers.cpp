// SPDX-License-Identifier: Apache-2.0
#include "io/collada/layers.h"

#include <sstream>

namespace twinray {
namespace {

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

bool is_off(const std::string& value) {
  return value == "false" || (!value.empty() && value.find_first_not_of("0.") == std::string::npos);
}

}  // namespace

std::vector<XmlElement> renders_of(const XmlElement& visual_scene) {
  for (const XmlElement& evaluate : visual_scene.children("evaluate_scene"))
    if (!is_off(evaluate.attribute("enable").value_or(""))) return evaluate.children("render");
  return {};
}

SceneLayers::SceneLayers(const XmlElement& visual_scene) {
  for (const XmlElement& render : renders_of(visual_scene)) {
    const auto layers = render.children("layer");
    if (layers.empty()) {
      names_.clear();
      return;
    }
    for (const XmlElement& layer : layers) names_.insert(layer.text());
  }
}

bool SceneLayers::show(const XmlElement& node) const {
  if (names_.empty()) return true;
  for (const std::string& name : words_of(node.attribute("layer").value_or("")))
    if (names_.count(name) > 0) return true;
  return false;
}

bool is_hidden(const XmlElement& node) {
  for (const XmlElement& extra : node.children("extra"))
    for (const XmlElement& technique : extra.children("technique"))
      if (const auto visibility = technique.child("visibility"); visibility && is_off(visibility->text()))
        return true;
  return false;
}

}  // namespace twinray
