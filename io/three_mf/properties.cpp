// SPDX-License-Identifier: Apache-2.0
#include "io/three_mf/properties.h"

#include <fmt/format.h>

#include <charconv>

#include "io/picture/srgb.h"
#include "io/three_mf/package.h"

namespace twinray {
namespace {

/// "#RRGGBB", or with alpha behind it, which is left out.
Rgb color_of(const XmlElement& element, const char* attribute) {
  const std::string text = element.required_attribute(attribute);
  std::uint32_t bits = 0;
  const bool has_size = (text.size() == 7 || text.size() == 9) && text[0] == '#';
  const char* const end = text.data() + text.size();
  if (!has_size || std::from_chars(text.data() + 1, end, bits, 16).ptr != end)
    throw error_at(element.attribute_place(attribute),
                   fmt::format("\"{}\" is no colour; valid are \"#RRGGBB\" and \"#RRGGBBAA\"", text));
  if (text.size() == 9) bits >>= 8;
  const auto part = [&](int shift) { return decode_srgb(float(bits >> shift & 255) / 255); };
  return {part(16), part(8), part(0)};
}

bool is_group(std::string_view name) {
  return name == "basematerials" || name == "colorgroup" || name == "texture2dgroup" ||
         name == "compositematerials" || name == "multiproperties";
}

}  // namespace

ThreeMfProperties::ThreeMfProperties(const XmlElement& resources, WarningList& warnings) {
  for (const XmlElement& child : resources.children())
    if (is_group(local_name(child.name()))) add(child, warnings);
}

void ThreeMfProperties::add(const XmlElement& group, WarningList& warnings) {
  auto& found = groups_[group.required_index_attribute("id")];
  const std::string name = group.name();
  const bool has_materials = local_name(name) == "basematerials";
  if (!has_materials && local_name(name) != "colorgroup") {
    warnings.add([&] { return group.place(); },
                 fmt::format("<{}> is not rendered; its triangles are grey", name));
    return;
  }
  found.emplace();
  for (const XmlElement& one : group.children())
    if (has_materials && local_name(one.name()) == "base")
      found->push_back({one.attribute("name").value_or(""), color_of(one, "displaycolor")});
    else if (!has_materials && local_name(one.name()) == "color")
      found->push_back({one.required_attribute("color").substr(0, 7), color_of(one, "color")});
}

std::optional<ThreeMfProperty> ThreeMfProperties::find(const XmlElement& named_by,
                                                       const ThreeMfChoice& choice) const {
  const auto group = groups_.find(choice.group);
  if (group == groups_.end())
    named_by.fail(fmt::format("<resources> has no materials or colours with the id {}", choice.group));
  if (!group->second) return std::nullopt;
  if (choice.index >= group->second->size())
    named_by.fail(fmt::format("the index {} is out of range; the group {} has {}", choice.index, choice.group,
                              group->second->size()));
  return (*group->second)[choice.index];
}

}  // namespace twinray
