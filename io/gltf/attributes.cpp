// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/attributes.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "io/diagnostic.h"

namespace twinray {
namespace {

/// Names of one attribute, and of those that have numbers.
struct Names {
  std::vector<std::string_view> single, numbered;
};

Names names_of(std::string_view object) {
  if (object == "EXT_mesh_gpu_instancing") return {{"TRANSLATION", "ROTATION", "SCALE"}, {}};
  Names names{{"POSITION", "NORMAL", "TANGENT"}, {"TEXCOORD_", "COLOR_"}};
  if (object != "target") names.numbered.insert(names.numbered.end(), {"JOINTS_", "WEIGHTS_"});
  return names;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// A number without zeros before it.
bool is_number(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), is_digit) &&
         (text.size() == 1 || text[0] != '0');
}

bool is_known(const Names& names, std::string_view name) {
  return std::find(names.single.begin(), names.single.end(), name) != names.single.end() ||
         std::any_of(names.numbered.begin(), names.numbered.end(), [&](std::string_view start) {
           return name.starts_with(start) && is_number(name.substr(start.size()));
         });
}

/// Of those with numbers the one of the name's own last digit.
std::string nearest(const Names& names, std::string_view name) {
  const char digit = !name.empty() && is_digit(name.back()) ? name.back() : '0';
  std::vector<std::string> numbered;
  for (const std::string_view start : names.numbered) numbered.push_back(std::string(start) + digit);
  std::vector<std::string_view> known = names.single;
  known.insert(known.end(), numbered.begin(), numbered.end());
  return nearest_name(name, known);
}

}  // namespace

std::string fault_of_attribute(std::string_view object, std::string_view name) {
  const Names names = names_of(object);
  if (name.starts_with('_') || is_known(names, name)) return "";
  const std::string other = nearest(names, name);
  return fmt::format("\"{}\" is not a known attribute{}", name,
                     other.empty() ? "" : fmt::format("; did you mean \"{}\"?", other));
}

std::vector<std::string> needed_beside(std::string_view name) {
  constexpr std::string_view joints = "JOINTS_", weights = "WEIGHTS_";
  const std::string_view own = name.starts_with(joints) ? joints : weights;
  if (!name.starts_with(own) || !is_number(name.substr(own.size()))) return {};
  const std::string_view number = name.substr(own.size());
  std::vector<std::string> others{fmt::format("{}{}", own == joints ? weights : joints, number)};
  if (number.size() == 1 && number != "0") others.push_back(fmt::format("{}{}", own, char(number[0] - 1)));
  return others;
}

}  // namespace twinray
