// SPDX-License-Identifier: Apache-2.0
#include "io/exchange/entry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/phase_function.h"

namespace twinray {
namespace {

constexpr float rounding = 1e-4f;

struct Bounds {
  float least, most;
  const char* words;
};

Bounds bounds_of(Valid valid) {
  constexpr float huge = std::numeric_limits<float>::max(), tiny = std::numeric_limits<float>::denorm_min();
  switch (valid) {
    case Valid::not_negative:
      return {0, huge, "a float, and not negative"};
    case Valid::positive:
      return {tiny, huge, "a float above 0"};
    case Valid::at_least_one:
      return {1, huge, "a float of 1 or more"};
    case Valid::part:
      return {0, 1, "from 0 to 1"};
    case Valid::film_thickness:
      return {0, 1000, "from 0 to 1000 micrometers"};
    case Valid::film_ior:
      return {1, 100, "from 1 to 100"};
    case Valid::anisotropy:
      return {-PhaseFunction::most_anisotropy, PhaseFunction::most_anisotropy, "from -0.99 to 0.99"};
    case Valid::any:
      break;
  }
  return {-huge, huge, "a float"};
}

}  // namespace

bool is_unit(const Vec3& v) { return std::fabs(length_squared(v) - 1) <= rounding; }
bool is_right_angle(const Vec3& a, const Vec3& b) { return std::fabs(dot(a, b)) <= rounding; }

Entry::Entry(const Json& json, std::string place, WarningList& warnings)
    : json_(json), place_(std::move(place)), warnings_(warnings) {
  if (!json.is_object()) fail("it must be an object");
}

void Entry::warn_of_unknown_keys() const {
  for (const auto& [key, value] : json_.items()) {
    if (key.starts_with('_') || std::find(asked_.begin(), asked_.end(), key) != asked_.end()) continue;
    const std::string nearest = nearest_name(key, asked_);
    warnings_.add([&] { return Place{.file = place_}; },
                  fmt::format("the key {} means nothing here{}",
                              Json(key).dump(-1, ' ', true, Json::error_handler_t::replace),
                              nearest.empty() ? "" : fmt::format("; is \"{}\" meant?", nearest)));
  }
}

void Entry::fail(const std::string& what) const { throw Error(fmt::format("{}: {}", place_, what)); }
void Entry::fail(const char* key, const std::string& what) const {
  fail(fmt::format("\"{}\" {}", key, what));
}

std::string Entry::place_of(const char* key) const { return fmt::format("{}: {}", place_, key); }
std::string Entry::place_of(const char* key, std::size_t i) const {
  return fmt::format("{}[{}]", place_of(key), i);
}

bool Entry::has(const char* key) const {
  asked_.push_back(key);
  return json_.contains(key);
}

const Json& Entry::at(const char* key) const {
  asked_.push_back(key);
  const auto found = json_.find(key);
  if (found == json_.end()) fail(key, "is missing");
  return *found;
}

const Json& Entry::list(const char* key) const {
  const Json& found = at(key);
  if (!found.is_array()) fail(key, "must be a list");
  return found;
}

const Json& Entry::list(const char* key, std::size_t count) const {
  const Json& found = list(key);
  if (found.size() != count) fail(key, fmt::format("has {} elements; it must have {}", found.size(), count));
  return found;
}

double Entry::real(const char* key, const Json& json) const {
  if (!json.is_number()) fail(key, "must be a number");
  return json.get<double>();
}

float Entry::number(const char* key, const Json& json, Valid valid) const {
  const Bounds bounds = bounds_of(valid);
  const double value = real(key, json);
  if (!(value >= double(bounds.least) && value <= double(bounds.most)))
    fail(key, fmt::format("is {}; it must be {}", json.dump(), bounds.words));
  return float(value);
}

std::vector<float> Entry::numbers(const char* key, std::size_t count, Valid valid) const {
  std::vector<float> found;
  for (const Json& each : list(key, count)) found.push_back(number(key, each, valid));
  return found;
}

std::uint32_t Entry::whole(const char* key, const Json& json, std::uint32_t least, std::uint32_t most) const {
  const auto is_valid = [&] {
    return json.is_number_unsigned() && json.get<std::uint64_t>() >= least &&
           json.get<std::uint64_t>() <= most;
  };
  if (!is_valid())
    fail(key, fmt::format("is {}; it must be a whole number from {} to {}",
                          json.is_structured() ? "no number"
                                               : json.dump(-1, ' ', true, Json::error_handler_t::replace),
                          least, most));
  return json.get<std::uint32_t>();
}

std::uint32_t Entry::index(const char* key) const {
  return whole(key, at(key), 0, std::numeric_limits<std::int32_t>::max());
}

std::string Entry::word(const char* key, const Json& json) const {
  if (!json.is_string()) fail(key, "must be a string");
  return json.get<std::string>();
}

bool Entry::flag(const char* key) const {
  if (!at(key).is_boolean()) fail(key, "must be true or false");
  return at(key).get<bool>();
}

std::string Entry::file_beside(const std::string& path) const {
  const std::filesystem::path name = word("file");
  const bool has_zero = name.native().find('\0') != std::string::npos;
  if (name.empty() || name != name.filename() || has_zero)
    fail("file", fmt::format("is \"{}\"; it must be the name of a file beside this one", name.string()));
  return (std::filesystem::path(path).parent_path() / name).string();
}

void MemberReader::operator()(const char* key, Rgb& member, Valid valid) const {
  const auto n = entry_.numbers(key, 3, valid);
  member = {n[0], n[1], n[2]};
}
void MemberReader::operator()(const char* key, Roughness& member, Valid valid) const {
  const auto n = entry_.numbers(key, 2, valid);
  member = {n[0], n[1]};
}
void MemberReader::operator()(const char* key, Vec2& member) const {
  const auto n = entry_.numbers(key, 2);
  member = {n[0], n[1]};
}
void MemberReader::operator()(const char* key, Vec3& member) const {
  const auto n = entry_.numbers(key, 3);
  member = {n[0], n[1], n[2]};
}

template <std::size_t rows, std::size_t columns>
void MemberReader::read_rows(const char* key, float (&matrix)[rows][columns]) const {
  const Json& list = entry_.list(key, rows);
  for (std::size_t row = 0; row < rows; ++row) {
    if (!list[row].is_array() || list[row].size() != columns)
      entry_.fail(key, fmt::format("must be {} rows of {} numbers", rows, columns));
    for (std::size_t column = 0; column < columns; ++column)
      matrix[row][column] = entry_.number(key, list[row][column]);
  }
}
template void MemberReader::read_rows(const char* key, float (&matrix)[2][3]) const;
template void MemberReader::read_rows(const char* key, float (&matrix)[3][4]) const;

void MemberReader::operator()(const char* key, Wrap& member) const {
  if (!entry_.at(key).is_array()) {
    member = entry_.named(key, words<WrapMode>());
    return;
  }
  const Json& both = entry_.list(key, 2);
  member = {entry_.named(key, both[0], words<WrapMode>()), entry_.named(key, both[1], words<WrapMode>())};
}

void MemberReader::operator()(const char* key, Transform& rotation) const {
  entry_.within(key, [&](const Entry& axes) {
    constexpr const char* names[] = {"x", "y", "z"};
    for (std::size_t column = 0; column < 3; ++column) {
      const Json& axis = axes.list(names[column], 3);
      for (std::size_t row = 0; row < 3; ++row) rotation.m[row][column] = axes.real(names[column], axis[row]);
    }
  });
}

void MemberReader::operator()(const char* key, Attenuation& member) const {
  entry_.within(key, [&](const Entry& entry) { members(MemberReader(entry), member); });
}

void MemberReader::direction(const char* key, Vec3& member) const {
  (*this)(key, member);
  if (!is_unit(member)) entry_.fail(key, "must be a vector of length 1");
}

void MemberReader::constant(const char* key, const char* word) const {
  if (const std::string found = entry_.word(key); found != word)
    entry_.fail(key, fmt::format("is \"{}\"; valid is {}", found, word));
}

}  // namespace twinray
