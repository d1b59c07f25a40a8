// SPDX-License-Identifier: Apache-2.0
#include "io/collada_document.h"

#include <fmt/format.h>

#include "io/number_list.h"

namespace twinray {
namespace {

const XmlElement& checked_root(const XmlElement& root) {
  if (!root.is("COLLADA"))
    root.fail(fmt::format("not COLLADA: the root element is <{}>; it must be <COLLADA version=\"1.4.1\">",
                          root.name()));
  const std::string version = root.required_attribute("version");
  if (version.rfind("1.4", 0) != 0 || (version.size() > 3 && version[3] != '.'))
    throw error_at(root.attribute_place("version"),
                   fmt::format("COLLADA version \"{}\" is not read; valid are 1.4.0 and 1.4.1", version));
  return root;
}

}  // namespace

ColladaDocument::ColladaDocument(const XmlDocument& document, const LoadOptions& options)
    : root_(checked_root(document.root())), options_(options), warnings_(options.strict) {
  index_ids(root_);
  read_asset();
}

void ColladaDocument::index_ids(const XmlElement& element) {
  if (const auto id = element.attribute("id"); id && !id->empty())
    if (!ids_.emplace(*id, element).second)
      warn([&] { return element.attribute_place("id"); },
           fmt::format("the id \"{}\" is used before; references mean the first element that has it", *id));
  for (const XmlElement& child : element.children()) index_ids(child);
}

void ColladaDocument::read_asset() {
  const auto asset = root_.child("asset");
  if (!asset) return;
  if (const auto axis = asset->child("up_axis")) {
    const std::string text = axis->text();
    if (text != "X_UP" && text != "Y_UP" && text != "Z_UP")
      axis->fail(fmt::format("\"{}\" is not an up axis; valid are X_UP, Y_UP and Z_UP", text));
    up_axis_ = text[0];
  }
  const auto unit = asset->child("unit");
  if (!unit) return;
  unit_name_ = unit->attribute("name").value_or(unit_name_);
  if (const auto meter = unit->attribute("meter")) {
    try {
      const auto numbers = parse_doubles(*meter);
      if (numbers.size() != 1 || numbers[0] <= 0)
        throw NumberError{0, "\"meter\" must be one number above 0"};
      unit_meters_ = numbers[0];
    } catch (const NumberError& error) {
      throw error_at(unit->attribute_place("meter"), error.message);
    }
  }
}

Transform ColladaDocument::to_y_up() const {
  if (up_axis_ == 'Z') return {{{-1, 0, 0, 0}, {0, 0, 1, 0}, {0, 1, 0, 0}}};
  if (up_axis_ == 'X') return {{{0, 1, 0, 0}, {1, 0, 0, 0}, {0, 0, -1, 0}}};
  return {};
}

XmlElement ColladaDocument::resolve(const XmlElement& from, const char* attribute,
                                    std::string_view kind) const {
  const std::string url = from.required_attribute(attribute);
  const auto place = [&] { return from.attribute_place(attribute); };
  if (url[0] != '#')
    throw error_at(
        place(), fmt::format("\"{}\" is not a reference within this file, which has the form \"#id\"", url));
  const auto found = ids_.find(std::string_view(url).substr(1));
  if (found != ids_.end() && found->second.is(kind)) return found->second;
  if (found != ids_.end())
    throw error_at(place(),
                   fmt::format("\"{}\" is a <{}>; a <{}> is needed", url, found->second.name(), kind));
  throw error_at(
      place(), fmt::format("no <{}> has the id \"{}\"{}", kind, url.substr(1), suggest(url.substr(1), kind)));
}

std::string ColladaDocument::suggest(std::string_view wanted, std::string_view kind) const {
  std::vector<std::string_view> known;
  for (const auto& [id, element] : ids_)
    if (element.is(kind)) known.push_back(id);
  const std::string nearest = nearest_name(wanted, known);
  if (!nearest.empty()) return fmt::format("; did you mean \"#{}\"?", nearest);
  constexpr std::size_t most_listed = 8;
  if (known.empty()) return "; the file has none";
  return known.size() > most_listed ? "" : fmt::format("; there is {}", list_names(known));
}

std::string display_name(const XmlElement& element) {
  for (const char* attribute : {"name", "id"})
    if (const auto value = element.attribute(attribute); value && !value->empty()) return *value;
  return "unnamed";
}

double number_in(const XmlElement& element, double least, double most) {
  const double value = element.number();
  if (value < least || value > most)
    throw error_at(element.number_place(0), fmt::format("<{}> is {}; it must lie in [{:g}, {:g}]",
                                                        element.name(), value, least, most));
  return value;
}

Rgb read_color(const XmlElement& element, float most) {
  const auto values = element.floats();
  if (values.size() != 3 && values.size() != 4)
    element.fail(fmt::format("<{}> has {} numbers; a color has 3 (red, green, blue), or 4 with alpha",
                             element.name(), values.size()));
  for (std::size_t i = 0; i < 3; ++i)
    if (values[i] < 0 || values[i] > most)
      throw error_at(element.number_place(i),
                     fmt::format("a component of <{}> is {}; it must lie in [0, {:g}]", element.name(),
                                 values[i], most));
  return {values[0], values[1], values[2]};
}

bool is_cgl_profile(std::string_view profile) { return profile == "CGL" || profile == "CMU462"; }

std::optional<XmlElement> cgl_technique(const XmlElement& element) {
  for (const XmlElement& extra : element.children("extra"))
    for (const XmlElement& technique : extra.children("technique"))
      if (is_cgl_profile(technique.attribute("profile").value_or(""))) return technique;
  return std::nullopt;
}

}  // namespace twinray
