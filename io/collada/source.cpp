// SPDX-License-Identifier: Apache-2.0
#include "io/collada/source.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace twinray {
namespace {

bool is_array(const XmlElement& element) { return element.is("float_array") || element.is("int_array"); }

constexpr std::size_t absent = std::size_t(-1);  ///< A parameter that is 0.

/// How an accessor walks over its array.
struct Layout {
  std::size_t offset = 0, stride = 1;
  std::vector<std::size_t> used;  ///< Which numbers of an element.
  std::optional<std::size_t> stated;
};

/// The numbers whose <param> has a name; where none has one, all.
std::vector<std::size_t> used_params(const std::vector<XmlElement>& params, std::size_t stride) {
  std::vector<std::size_t> named, all;
  for (std::size_t i = 0; i < std::min(params.size(), stride); ++i)
    if (params[i].attribute("name")) named.push_back(i);
  constexpr std::size_t most = 4;
  for (std::size_t i = 0; i < std::min(stride, params.empty() ? most : params.size()); ++i) all.push_back(i);
  return named.empty() ? all : named;
}

Layout read_accessor(const XmlElement& accessor, std::size_t width, ColladaDocument& document) {
  Layout layout;
  const auto params = accessor.children("param");
  layout.offset = accessor.index_attribute("offset", 0);
  layout.stride = accessor.index_attribute("stride", 1);
  if (!accessor.attribute("stride") && params.size() > 1) {
    layout.stride = params.size();
    document.warn(accessor,
                  fmt::format("this <accessor> has no stride, which would be 1; it has {} parameters, "
                              "and that is taken to be its stride",
                              params.size()));
  }
  layout.used = used_params(params, layout.stride);
  if (params.size() == 2 && layout.used.size() == 2 && width == 3) {
    document.warn(accessor, "this <accessor> has two parameters, and three are needed; the third is 0");
    layout.used = {layout.used[0], layout.used[1], absent};
  }
  if (layout.used.size() < width)
    accessor.fail(fmt::format("{} named parameters are needed, and the accessor has {} (its stride is {})",
                              width, layout.used.size(), layout.stride));
  if (accessor.attribute("count")) layout.stated = accessor.required_index_attribute("count");
  return layout;
}

/// Without an accessor: one element after the other.
Layout plain_layout(const XmlElement& source, std::size_t width, ColladaDocument& document) {
  document.warn(
      source,
      fmt::format("this <source> has no <accessor>; its array is read as elements of {} numbers", width));
  Layout layout;
  layout.stride = width;
  for (std::size_t i = 0; i < width; ++i) layout.used.push_back(i);
  return layout;
}

/// The array that the accessor names; where there is none, with a warning, a source's only one.
XmlElement find_array(const XmlElement& source, const std::optional<XmlElement>& accessor,
                      ColladaDocument& document) {
  std::vector<XmlElement> own;
  for (const XmlElement& child : source.children())
    if (is_array(child)) own.push_back(child);
  if (!accessor && own.empty()) source.fail("this <source> has no <float_array> with numbers");
  if (!accessor) return own[0];
  const std::string url = accessor->attribute("source").value_or("");
  for (const XmlElement& array : own)
    if (const auto id = array.attribute("id"); id && url == "#" + *id) return array;
  const bool is_elsewhere =
      !url.empty() && (url[0] != '#' || document.find(source, url.substr(1), "float_array"));
  if (is_elsewhere || own.size() != 1) return document.resolve(*accessor, "source", "float_array");
  document.warn(*accessor,
                fmt::format("no <{0}> is \"{1}\"; this <accessor> is taken to mean the only one of its "
                            "<source>",
                            own[0].name(), url));
  return own[0];
}

std::vector<float> read_array(const XmlElement& array, ColladaDocument& document) {
  std::vector<float> values = array.floats_or_nan();
  if (!array.attribute("count"))
    document.warn(
        array, fmt::format("this <{}> has no count, which it needs; all its numbers are read", array.name()));
  else if (const std::size_t count = array.required_index_attribute("count"); count != values.size())
    document.warn([&] { return array.attribute_place("count"); },
                  fmt::format("count says {}, and the array has {} numbers; all of them are read", count,
                              values.size()));
  return values;
}

/// How many elements the array holds. Positions stay below 2^64: each factor is below 2^32.
std::size_t elements_held(const Layout& layout, std::size_t width, std::size_t numbers) {
  const std::size_t last = layout.used[width - 1] == absent ? layout.used[width - 2] : layout.used[width - 1];
  const std::size_t first_end = layout.offset + last + 1;
  return first_end > numbers ? 0 : (numbers - first_end) / layout.stride + 1;
}

}  // namespace

SourceValues read_source(const XmlElement& source, std::size_t width, ColladaDocument& document) {
  const auto common = source.child("technique_common");
  const auto accessor = common ? common->child("accessor") : std::nullopt;
  const Layout layout =
      accessor ? read_accessor(*accessor, width, document) : plain_layout(source, width, document);
  const std::vector<float> array = read_array(find_array(source, accessor, document), document);
  const std::size_t held = elements_held(layout, width, array.size());
  if (layout.stated.value_or(0) > held)
    document.warn(*accessor, fmt::format("count says {}, and the array holds {} elements of stride {} from "
                                         "offset {}; these are read",
                                         *layout.stated, held, layout.stride, layout.offset));
  SourceValues result;
  result.width = width;
  result.stated = std::min(layout.stated.value_or(held), held);
  result.values.reserve(held * width);
  for (std::size_t i = 0; i < held; ++i)
    for (std::size_t k = 0; k < width; ++k)
      result.values.push_back(
          layout.used[k] == absent ? 0 : array[layout.offset + layout.stride * i + layout.used[k]]);
  result.has_nan =
      std::any_of(result.values.begin(), result.values.end(), [](float x) { return std::isnan(x); });
  return result;
}

SourceNames read_names(const XmlElement& source) {
  SourceNames result;
  const auto ids = source.child("IDREF_array");
  const auto names = ids ? ids : source.child("Name_array");
  if (!names) source.fail("this <source> has neither an <IDREF_array> nor a <Name_array>");
  result.are_ids = ids.has_value();
  std::istringstream words(names->text());
  for (std::string word; words >> word;) result.names.push_back(word);
  return result;
}

bool SourceValues::is_finite(std::size_t element) const {
  if (!has_nan) return true;
  const auto begin = values.begin() + std::ptrdiff_t(element * width);
  return std::none_of(begin, begin + std::ptrdiff_t(width), [](float x) { return std::isnan(x); });
}

std::shared_ptr<const SourceValues> ColladaSources::get(const XmlElement& source, std::size_t width) {
  auto& known = known_[{source, width}];
  if (!known) known = std::make_shared<const SourceValues>(read_source(source, width, document_));
  return known;
}

}  // namespace twinray
