// SPDX-License-Identifier: Apache-2.0
#include "cli/light_groups.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <string_view>

#include "core/error.h"
#include "core/interiors.h"

namespace twinray {
namespace {

/// Whether a name is that of the pattern, in which * stands for any text, or none. Each * takes as little as
/// it can: what is behind it is looked for from there on, and the last part of the pattern at the end.
bool matches(std::string_view pattern, std::string_view name) {
  const std::size_t first_star = pattern.find('*');
  if (first_star == pattern.npos) return pattern == name;
  const std::string_view begin = pattern.substr(0, first_star), end = pattern.substr(pattern.rfind('*') + 1);
  if (name.size() < begin.size() + end.size() || !name.starts_with(begin) || !name.ends_with(end))
    return false;
  name = name.substr(begin.size(), name.size() - begin.size() - end.size());
  pattern = pattern.substr(begin.size(), pattern.size() - begin.size() - end.size());
  while (!pattern.empty()) {
    const std::string_view part = pattern.substr(0, pattern.find('*'));
    const std::size_t at = name.find(part);
    if (at == name.npos) return false;
    name.remove_prefix(at + part.size());
    pattern.remove_prefix(std::min(part.size() + 1, pattern.size()));
  }
  return true;
}

bool names(const LightGroupRule& rule, const std::string& light) {
  return std::any_of(rule.lights.begin(), rule.lights.end(),
                     [&](const std::string& pattern) { return matches(pattern, light); });
}

/// The names of groups, as lights ask for them.
class GroupNames {
 public:
  explicit GroupNames(std::span<const LightGroupRule> rules) : rules_(rules) {}

  const std::string& of(const Light& light) {
    for (const LightGroupRule& rule : rules_)
      if (names(rule, light.name)) return rule.name;
    const std::string own = light.name.empty() ? "light" : light.name;
    const auto known = own_.find(own);
    return known != own_.end() ? known->second : own_.emplace(own, word_for(own)).first->second;
  }

 private:
  /// Names that are one word in a layer's letters are numbered: "lamp_1", "lamp_1_2".
  std::string word_for(const std::string& own) const {
    const std::string word = layer_word(own);
    for (const LightGroupRule& rule : rules_)
      if (rule.name == word)
        throw Error(
            fmt::format("--light-group: the light \"{}\" is no part of the group \"{}\", and has its "
                        "name; give the group another one",
                        own, word));
    std::string numbered = word;
    for (int n = 2; is_taken(numbered); ++n) numbered = fmt::format("{}_{}", word, n);
    return numbered;
  }
  bool is_taken(const std::string& word) const {
    return std::any_of(own_.begin(), own_.end(), [&](const auto& known) { return known.second == word; });
  }

  const std::span<const LightGroupRule> rules_;
  std::map<std::string, std::string> own_;  ///< Of lights that no rule names, by their names.
};

/// The lights' names in quotes, the first few of them.
std::string list_lights(const Scene& scene) {
  constexpr std::size_t most = 10;
  std::vector<std::string> quoted;
  for (std::size_t i = 0; i < std::min(most, scene.lights.size()); ++i)
    quoted.push_back(fmt::format("\"{}\"", scene.lights[i].name));
  return fmt::format("{}{}", fmt::join(quoted, ", "), scene.lights.size() > most ? ", ..." : "");
}

/// What all media that emit light count as.
constexpr const char* media_light = "media";

void check_rule(const LightGroupRule& rule, const Scene& scene) {
  for (const std::string& pattern : rule.lights)
    if (std::none_of(scene.lights.begin(), scene.lights.end(),
                     [&](const Light& light) { return matches(pattern, light.name); }) &&
        !(has_glow(scene.materials) && matches(pattern, media_light)))
      throw Error(fmt::format("--light-group: no light is called \"{}\"; the scene {}", pattern,
                              scene.lights.empty() ? "has none" : "has " + list_lights(scene)));
}

/// The lights of a group may all belong to groups before it.
void check_groups(const std::vector<std::string>& groups, std::span<const LightGroupRule> rules) {
  for (const LightGroupRule& rule : rules)
    if (std::find(groups.begin(), groups.end(), rule.name) == groups.end())
      throw Error(
          fmt::format("--light-group: all lights of \"{}\" belong to the groups before it", rule.name));
}

}  // namespace

std::string layer_word(const std::string& name) {
  std::string word = name;
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
  };
  std::replace_if(
      word.begin(), word.end(), [&](char c) { return !is_plain(c); }, '_');
  return word;
}

LightGroupRule parse_light_group(const std::string& text) {
  const std::size_t equals = text.find('=');
  LightGroupRule rule{text.substr(0, equals), {}};
  if (equals != text.npos) {
    std::istringstream list(text.substr(equals + 1));
    for (std::string light; std::getline(list, light, ',');) rule.lights.push_back(light);
  }
  if (rule.lights.empty() || rule.name.empty() || rule.name != layer_word(rule.name))
    throw UsageError(
        fmt::format("--light-group: \"{}\" is no group; valid is NAME=LIGHT,... where the name has letters, "
                    "digits, \"-\" and \"_\", and * in a light's name stands for any text",
                    text));
  return rule;
}

void group_lights(Scene& scene, std::span<const LightGroupRule> rules) {
  for (const LightGroupRule& rule : rules) check_rule(rule, scene);
  std::vector<std::string>& groups = scene.light_groups;
  groups.clear();
  GroupNames group_names(rules);
  const auto group_of = [&](const Light& light) {
    const std::string& name = group_names.of(light);
    const auto known = std::find(groups.begin(), groups.end(), name);
    const auto group = std::uint32_t(known - groups.begin());
    if (known == groups.end()) groups.push_back(name);
    if (groups.size() > most_light_groups)
      throw Error(
          fmt::format("--layers=light-groups: the scene's {} lights are more than {} groups; "
                      "--light-group=NAME=LIGHT,... makes one of several, * stands for any text",
                      scene.lights.size(), most_light_groups));
    return group;
  };
  for (Light& light : scene.lights) light.group = group_of(light);
  scene.media_group = has_glow(scene.materials) ? group_of({media_light, AmbientLight{}}) : no_light;
  check_groups(groups, rules);
}

}  // namespace twinray
