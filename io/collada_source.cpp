// SPDX-License-Identifier: Apache-2.0
#include "io/collada_source.h"

#include <fmt/format.h>

#include <algorithm>

namespace twinray {
namespace {

/// Which numbers of an element are used: those whose <param> has a name.
std::vector<std::size_t> named_params(const XmlElement& accessor, std::size_t stride) {
  std::vector<std::size_t> used;
  const auto params = accessor.children("param");
  for (std::size_t i = 0; i < std::min(params.size(), stride); ++i)
    if (params[i].attribute("name")) used.push_back(i);
  if (params.empty())
    for (std::size_t i = 0; i < std::min<std::size_t>(stride, 4); ++i) used.push_back(i);
  return used;
}

std::vector<float> read_float_array(const XmlElement& array) {
  std::vector<float> values = array.floats();
  const std::size_t count = array.required_index_attribute("count");
  if (values.size() != count)
    throw error_at(array.attribute_place("count"),
                   fmt::format("count says {}, and the array has {} numbers", count, values.size()));
  return values;
}

}  // namespace

SourceValues read_source(const XmlElement& source, std::size_t width, const ColladaDocument& document) {
  const XmlElement accessor = source.required_child("technique_common").required_child("accessor");
  const std::vector<float> array = read_float_array(document.resolve(accessor, "source", "float_array"));
  const std::size_t count = accessor.required_index_attribute("count");
  const std::size_t offset = accessor.index_attribute("offset", 0),
                    stride = accessor.index_attribute("stride", 1);
  const std::vector<std::size_t> used = named_params(accessor, stride);
  if (used.size() < width)
    accessor.fail(fmt::format("{} named parameters are needed, and the accessor has {} (its stride is {})",
                              width, used.size(), stride));
  // Positions stay below 2^64: each factor is below 2^32.
  if (count > 0 && offset + stride * (count - 1) + used[width - 1] >= array.size())
    accessor.fail(
        fmt::format("{} elements of stride {} from offset {} reach beyond the {} numbers of the array", count,
                    stride, offset, array.size()));
  SourceValues result;
  result.width = width;
  result.values.reserve(count * width);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < width; ++k) result.values.push_back(array[offset + stride * i + used[k]]);
  return result;
}

}  // namespace twinray
