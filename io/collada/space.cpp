// SPDX-License-Identifier: Apache-2.0
#include "io/collada/space.h"

#include <fmt/format.h>

#include "io/number_list.h"

namespace twinray {
namespace {

/// Some programs write decimals as their user's language has them.
std::string with_decimal_point(const XmlElement& unit, const std::string& text, WarningList& warnings) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos || text.find_first_of(",.", comma + 1) != std::string::npos) return text;
  std::string result = text;
  result[comma] = '.';
  warnings.add([&] { return unit.attribute_place("meter"); },
               fmt::format("\"{}\" is read as {}: decimals have a point", text, result));
  return result;
}

double read_meters(const XmlElement& unit, const std::string& text, WarningList& warnings) {
  try {
    const auto numbers = parse_doubles(with_decimal_point(unit, text, warnings));
    if (numbers.size() != 1 || numbers[0] <= 0) throw NumberError{0, "\"meter\" must be one number above 0"};
    return numbers[0];
  } catch (const NumberError& error) {
    throw error_at(unit.attribute_place("meter"), error.message);
  }
}

char read_axis(const XmlElement& axis) {
  const std::string text = axis.text();
  if (text != "X_UP" && text != "Y_UP" && text != "Z_UP")
    axis.fail(fmt::format("\"{}\" is not an up axis; valid are X_UP, Y_UP and Z_UP", text));
  return text[0];
}

/// COLLADA's turn of an up axis to Y; each row has one 1 or -1.
Transform standard_turn(char up_axis) {
  if (up_axis == 'X') return {{{0, -1, 0, 0}, {1, 0, 0, 0}, {0, 0, 1, 0}}};
  if (up_axis == 'Z') return {{{1, 0, 0, 0}, {0, 0, 1, 0}, {0, -1, 0, 0}}};
  return {};
}

Transform transposed(const Transform& t) {
  Transform result;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) result.m[row][column] = t.m[column][row];
  return result;
}

}  // namespace

ColladaSpace read_space(const XmlElement& asset, const ColladaSpace& outside, WarningList& warnings) {
  ColladaSpace space = outside;
  if (const auto axis = asset.child("up_axis")) {
    if (axis->text().empty())
      warnings.add([&] { return axis->place(); },
                   fmt::format("<up_axis> is empty; {}_UP is taken, which holds around it", space.up_axis));
    else
      space.up_axis = read_axis(*axis);
  }
  const auto unit = asset.child("unit");
  if (!unit) return space;
  const auto meter = unit->attribute("meter");
  space.unit_name = unit->attribute("name").value_or(ColladaSpace{}.unit_name);
  space.unit_meters = meter ? read_meters(*unit, *meter, warnings) : 1;
  return space;
}

Transform conversion(const ColladaSpace& from, const ColladaSpace& to) {
  if (from.unit_meters == to.unit_meters && from.up_axis == to.up_axis) return {};
  const double scale = from.unit_meters / to.unit_meters;
  return transposed(standard_turn(to.up_axis)) * standard_turn(from.up_axis) *
         Transform::scaling(scale, scale, scale);
}

Transform turn_to_y_up(char up_axis) {
  if (up_axis == 'Z') return {{{-1, 0, 0, 0}, {0, 0, 1, 0}, {0, 1, 0, 0}}};
  if (up_axis == 'X') return {{{0, 1, 0, 0}, {1, 0, 0, 0}, {0, 0, -1, 0}}};
  return {};
}

}  // namespace twinray
