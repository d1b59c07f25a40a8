// SPDX-License-Identifier: Apache-2.0
// Private: what stands in the exchange form's JSON, taken out with checks.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "core/error.h"
#include "io/diagnostic.h"
#include "io/exchange/json.h"
#include "io/exchange/words.h"

namespace twinray {

/// Whether a vector has length 1, but for the rounding of a file's numbers.
bool is_unit(const Vec3& v);
/// Whether two such are at right angles.
bool is_right_angle(const Vec3& a, const Vec3& b);

/// An object of the file, with its place for messages, such as "a.json: lights[2]". What it gives is as
/// asked; all throw Error where it is not, with the place and what would be valid.
class Entry {
 public:
  /// Calls take(entry) for an object, then warns of its keys that were not asked for: each may be a misspelt
  /// one. Those that begin with "_" are remarks.
  template <typename Take>
  static void read(const Json& json, std::string place, WarningList& warnings, const Take& take) {
    const Entry entry(json, std::move(place), warnings);
    take(entry);
    entry.warn_of_unknown_keys();
  }
  Entry(const Entry&) = delete;
  Entry& operator=(const Entry&) = delete;

  const std::string& place() const { return place_; }
  [[noreturn]] void fail(const std::string& what) const;
  [[noreturn]] void fail(const char* key, const std::string& what) const;

  bool has(const char* key) const;
  const Json& at(const char* key) const;
  /// Calls take(entry) for an object.
  template <typename Take>
  void within(const char* key, const Take& take) const {
    read(at(key), place_of(key), warnings_, take);
  }
  /// Of a list, which may have to have so many.
  const Json& list(const char* key) const;
  const Json& list(const char* key, std::size_t count) const;
  /// Calls take(entry) for each object of a list.
  template <typename Take>
  void for_each(const char* key, const Take& take) const {
    std::size_t i = 0;
    for (const Json& each : list(key)) read(each, place_of(key, i++), warnings_, take);
  }

  float number(const char* key, Valid valid = Valid::any) const { return number(key, at(key), valid); }
  /// Of a list's element.
  float number(const char* key, const Json& json, Valid valid = Valid::any) const;
  double real(const char* key, const Json& json) const;
  std::vector<float> numbers(const char* key, std::size_t count, Valid valid = Valid::any) const;
  /// A whole number in [least, most].
  std::uint32_t whole(const char* key, const Json& json, std::uint32_t least, std::uint32_t most) const;
  /// One that counts entries.
  std::uint32_t index(const char* key) const;
  std::string word(const char* key) const { return word(key, at(key)); }
  std::string word(const char* key, const Json& json) const;
  bool flag(const char* key) const;
  /// The path of the file that it names: one in the folder of the file that it stands in.
  std::string file_beside(const std::string& path) const;
  /// The value whose name stands there.
  template <typename Value>
  Value named(const char* key, const Words<Value>& values) const {
    return named(key, at(key), values);
  }
  /// Of a list's element.
  template <typename Value>
  Value named(const char* key, const Json& json, const Words<Value>& values) const {
    const std::string found = word(key, json);
    std::string valid;
    for (const auto& [name, value] : values) {
      if (found == name) return value;
      valid += (valid.empty() ? "" : ", ") + name;
    }
    fail(key, "is \"" + found + "\"; valid are " + valid);
  }

 private:
  Entry(const Json& json, std::string place, WarningList& warnings);

  void warn_of_unknown_keys() const;
  std::string place_of(const char* key) const;
  std::string place_of(const char* key, std::size_t i) const;

  const Json& json_;
  const std::string place_;
  WarningList& warnings_;
  mutable std::vector<std::string_view> asked_;  ///< The keys that were asked for, once or more often.
};

/// What reading a file, or making something of what stands in one, gives; its Error begins with the place.
template <typename Read>
auto at_place(const std::string& place, const Read& read) {
  try {
    return read();
  } catch (const Error& error) {
    throw Error(place + ": " + error.what());
  }
}

/// Reads members out of an object, which must outlive it.
class MemberReader {
 public:
  explicit MemberReader(const Entry& entry) : entry_(entry) {}

  void operator()(const char* key, float& member, Valid valid) const { member = entry_.number(key, valid); }
  void operator()(const char* key, Rgb& member, Valid valid) const;
  void operator()(const char* key, Roughness& member, Valid valid) const;
  void operator()(const char* key, Vec2& member) const;
  void operator()(const char* key, Vec3& member) const;
  void operator()(const char* key, bool& member) const { member = entry_.flag(key); }
  void operator()(const char* key, std::uint32_t& member) const { member = entry_.index(key); }
  void operator()(const char* key, std::int32_t& member) const { member = std::int32_t(entry_.index(key)); }
  void operator()(const char* key, UvTransform& member) const { read_rows(key, member.m); }
  void operator()(const char* key, PointTransform& member) const { read_rows(key, member.m); }
  template <typename Word>
  requires std::is_enum_v<Word>
  void operator()(const char* key, Word& member) const { member = entry_.named(key, words<Word>()); }
  void operator()(const char* key, Wrap& member) const;
  void operator()(const char* key, Transform& rotation) const;
  void operator()(const char* key, Attenuation& member) const;
  /// A unit vector.
  void direction(const char* key, Vec3& member) const;
  /// A member that may be left out, as in files of earlier times, and then keeps its value.
  template <typename Member, typename... Validity>
  void later(const char* key, Member& member, Validity... valid) const {
    if (entry_.has(key)) (*this)(key, member, valid...);
  }
  void constant(const char* key, const char* word) const;

 private:
  /// The rows of a matrix.
  template <std::size_t rows, std::size_t columns>
  void read_rows(const char* key, float (&matrix)[rows][columns]) const;

  const Entry& entry_;
};

/// Of a variant with each of its types, the one that an entry names, with its members.
template <typename Variant>
Variant described_by(const Entry& entry, std::vector<Variant> types) {
  Words<Variant*> names;
  for (Variant& each : types)
    names.emplace_back(std::visit([](const auto& value) { return type_name(value); }, each), &each);
  Variant& chosen = *entry.named("type", names);
  std::visit([&](auto& value) { members(MemberReader(entry), value); }, chosen);
  return std::move(chosen);
}

}  // namespace twinray
