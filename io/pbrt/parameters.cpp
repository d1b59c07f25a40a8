// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace twinray {
namespace {

enum class Values { reals, integers, booleans, strings, reals_or_strings };

struct TypeName {
  std::string_view name;
  PbrtType type;
  Values values;
  std::size_t dimension;  ///< Numbers of one value.
};

/// The first name of a type is the one that messages show.
constexpr std::array<TypeName, 16> type_names{
    {{"float", PbrtType::real, Values::reals, 1},
     {"integer", PbrtType::integer, Values::integers, 1},
     {"bool", PbrtType::boolean, Values::booleans, 1},
     {"string", PbrtType::string, Values::strings, 1},
     {"texture", PbrtType::texture, Values::strings, 1},
     {"point3", PbrtType::point3, Values::reals, 3},
     {"point", PbrtType::point3, Values::reals, 3},
     {"point2", PbrtType::point2, Values::reals, 2},
     {"vector3", PbrtType::vector3, Values::reals, 3},
     {"vector", PbrtType::vector3, Values::reals, 3},
     {"vector2", PbrtType::vector2, Values::reals, 2},
     {"normal", PbrtType::normal, Values::reals, 3},
     {"normal3", PbrtType::normal, Values::reals, 3},
     {"rgb", PbrtType::rgb, Values::reals, 3},
     {"blackbody", PbrtType::blackbody, Values::reals, 1},
     {"spectrum", PbrtType::spectrum, Values::reals_or_strings, 1}}};

const TypeName& entry_of(PbrtType type) {
  return *std::find_if(type_names.begin(), type_names.end(),
                       [&](const TypeName& t) { return t.type == type; });
}

std::vector<std::string_view> known_types() {
  std::vector<std::string_view> names;
  for (const TypeName& type : type_names) names.push_back(type.name);
  return names;
}

PbrtType type_of(const PbrtToken& declaration, std::string_view word) {
  for (const TypeName& type : type_names)
    if (type.name == word) return type.type;
  const auto known = known_types();
  declaration.place.fail(fmt::format("{}: there is no type \"{}\"; valid are {}", shown(declaration),
                                     word.substr(0, 32), list_names(known)));
}

bool is_blank(char c) { return c == ' ' || c == '\t'; }

struct Declaration {
  std::string_view type, name;
};

/// Takes "type name" apart; either part is empty where it is missing.
Declaration split(std::string_view text) {
  std::size_t i = 0;
  const auto word = [&] {
    while (i < text.size() && is_blank(text[i])) ++i;
    const std::size_t begin = i;
    while (i < text.size() && !is_blank(text[i])) ++i;
    return text.substr(begin, i - begin);
  };
  const std::string_view type = word();
  return {type, word()};
}

std::string list_types(std::initializer_list<PbrtType> types) {
  std::vector<std::string_view> names;
  for (const PbrtType type : types) names.push_back(PbrtParameters::type_name(type));
  return list_names(names);
}

bool parse_boolean(const PbrtToken& token) {
  if (token.text == "true") return true;
  if (token.text != "false") token.place.fail(shown(token) + " is neither true nor false");
  return false;
}

}  // namespace

std::string_view PbrtParameters::type_name(PbrtType type) { return entry_of(type).name; }

void PbrtParameters::clear(const PbrtPlace& place) {
  place_ = place;
  parameters_.clear();
  reals_.clear();
  integers_.clear();
  strings_.clear();
  asked_.clear();
  defaults_.reset();
}

void PbrtParameters::read(PbrtLexer& lexer) {
  while (lexer.next().is_string()) read_one(lexer);
}

void PbrtParameters::read_one(PbrtLexer& lexer) {
  const PbrtToken token = lexer.take();
  const Declaration words = split(token.text);
  if (words.name.empty())
    token.place.fail(fmt::format("{} is not the type and the name of a parameter, such as \"float radius\"",
                                 shown(token)));
  PbrtParameter parameter{type_of(token, words.type), std::string(words.name), token.place, false, 0, 0};
  const Values values = entry_of(parameter.type).values;
  parameter.has_strings = values == Values::strings || (values == Values::reals_or_strings &&
                                                        lexer.next().kind == PbrtToken::Kind::string);
  const bool has_brackets = lexer.next().kind == PbrtToken::Kind::open;
  if (has_brackets) lexer.take();
  if (values == Values::reals_or_strings) parameter.has_strings = lexer.next().is_string();
  const bool is_whole = values == Values::integers || values == Values::booleans;
  const auto size = [&] {
    return parameter.has_strings ? strings_.size() : is_whole ? integers_.size() : reals_.size();
  };
  parameter.first = size();
  if (!has_brackets) read_value(lexer.take(), parameter);
  while (has_brackets && lexer.next().kind != PbrtToken::Kind::close) {
    if (lexer.next().kind == PbrtToken::Kind::end)
      parameter.place.fail(fmt::format("the list of \"{}\" does not end; ] is missing", parameter.name));
    read_value(lexer.take(), parameter);
  }
  if (has_brackets) lexer.take();
  parameter.count = size() - parameter.first;
  check_count(parameter);
  parameters_.push_back(std::move(parameter));
}

void PbrtParameters::read_value(const PbrtToken& token, PbrtParameter& parameter) {
  const Values values = entry_of(parameter.type).values;
  if (parameter.has_strings) {
    if (!token.is_string())
      token.place.fail(fmt::format("{} is not a string, which \"{} {}\" needs: it stands in quotation marks",
                                   shown(token), type_name(parameter.type), parameter.name));
    strings_.push_back(token.unescaped());
  } else if (values == Values::booleans) {
    integers_.push_back(parse_boolean(token));
  } else if (values == Values::integers) {
    integers_.push_back(token.integer());
  } else {
    reals_.push_back(token.real());
  }
}

void PbrtParameters::check_count(const PbrtParameter& parameter) const {
  const std::size_t dimension = entry_of(parameter.type).dimension;
  if (parameter.count == 0)
    parameter.place.fail(fmt::format("\"{} {}\" has no value", type_name(parameter.type), parameter.name));
  if (parameter.count % dimension != 0)
    parameter.place.fail(fmt::format("\"{} {}\" has {} numbers, which do not come in {}",
                                     type_name(parameter.type), parameter.name, parameter.count,
                                     dimension == 2 ? "twos" : "threes"));
}

void PbrtParameters::append(const PbrtParameters& others) {
  for (PbrtParameter parameter : others.parameters_) {
    const Values values = entry_of(parameter.type).values;
    const auto move_to = [&](auto& list, const auto& from) {
      const auto begin = from.begin() + std::ptrdiff_t(parameter.first);
      parameter.first = list.size();
      list.insert(list.end(), begin, begin + std::ptrdiff_t(parameter.count));
    };
    if (parameter.has_strings)
      move_to(strings_, others.strings_);
    else if (values == Values::integers || values == Values::booleans)
      move_to(integers_, others.integers_);
    else
      move_to(reals_, others.reals_);
    if (!parameter.color_space) parameter.color_space = others.color_space;
    parameters_.push_back(std::move(parameter));
  }
}

/// The last one of a name counts.
const PbrtParameter* PbrtParameters::own(std::string_view name) const {
  for (std::size_t i = parameters_.size(); i > 0; --i)
    if (parameters_[i - 1].name == name) return &parameters_[i - 1];
  return nullptr;
}

const PbrtParameter* PbrtParameters::find(const char* name) const {
  asked_.emplace_back(name);
  if (const PbrtParameter* found = own(name)) return found;
  return defaults_ ? defaults_->own(name) : nullptr;
}

const PbrtParameters& PbrtParameters::owner_of(const PbrtParameter& parameter) const {
  const bool is_own = !parameters_.empty() && &parameter >= parameters_.data() &&
                      &parameter < parameters_.data() + parameters_.size();
  return is_own ? *this : *defaults_;
}

const PbrtParameter* PbrtParameters::find_of(const char* name, std::initializer_list<PbrtType> types) const {
  const PbrtParameter* found = find(name);
  if (!found || std::find(types.begin(), types.end(), found->type) != types.end()) return found;
  found->place.fail(
      fmt::format("\"{}\" is of type {} here; valid is {}", name, type_name(found->type), list_types(types)));
}

const PbrtParameter* PbrtParameters::single(const char* name, std::initializer_list<PbrtType> types) const {
  const PbrtParameter* found = find_of(name, types);
  if (found && found->count != entry_of(found->type).dimension)
    found->place.fail(fmt::format("\"{}\" has {} values; it needs one", name,
                                  found->count / entry_of(found->type).dimension));
  return found;
}

float PbrtParameters::real(const char* name, float fallback, const NumberRange& range) const {
  const PbrtParameter* found = single(name, {PbrtType::real});
  if (!found) return fallback;
  const float value = reals(*found)[0];
  if (!(value >= float(range.least) && value <= float(range.most)))
    found->place.fail(
        fmt::format("\"{}\" is {:g}; it must lie in [{:g}, {:g}]", name, value, range.least, range.most));
  return value;
}

std::int32_t PbrtParameters::integer(const char* name, std::int32_t fallback,
                                     const NumberRange& range) const {
  const PbrtParameter* found = single(name, {PbrtType::integer});
  if (!found) return fallback;
  const std::int32_t value = owner_of(*found).integers_[found->first];
  if (!(value >= range.least && value <= range.most))
    found->place.fail(
        fmt::format("\"{}\" is {}; it must lie in [{}, {}]", name, value, range.least, range.most));
  return value;
}

bool PbrtParameters::flag(const char* name, bool fallback) const {
  const PbrtParameter* found = single(name, {PbrtType::boolean});
  return found ? owner_of(*found).integers_[found->first] != 0 : fallback;
}

std::string PbrtParameters::text(const char* name, const std::string& fallback) const {
  const PbrtParameter* found = single(name, {PbrtType::string});
  return found ? text(*found) : fallback;
}

Vec3 PbrtParameters::point(const char* name, const Vec3& fallback) const {
  const PbrtParameter* found = single(name, {PbrtType::point3, PbrtType::vector3});
  if (!found) return fallback;
  const std::span<const float> p = reals(*found);
  return {p[0], p[1], p[2]};
}

std::span<const float> PbrtParameters::reals(const PbrtParameter& parameter) const {
  return {owner_of(parameter).reals_.data() + parameter.first, parameter.count};
}

const std::string& PbrtParameters::text(const PbrtParameter& parameter) const {
  return owner_of(parameter).strings_[parameter.first];
}

std::span<const float> PbrtParameters::reals(const char* name) const {
  const PbrtParameter* found = find_of(name, {PbrtType::real});
  return found ? reals(*found) : std::span<const float>();
}

std::span<const std::int32_t> PbrtParameters::integers(const char* name) const {
  const PbrtParameter* found = find_of(name, {PbrtType::integer});
  if (!found) return {};
  return {owner_of(*found).integers_.data() + found->first, found->count};
}

std::span<const std::string> PbrtParameters::texts(const char* name) const {
  const PbrtParameter* found = find_of(name, {PbrtType::string});
  if (!found) return {};
  return {owner_of(*found).strings_.data() + found->first, found->count};
}

std::span<const float> PbrtParameters::tuples(const char* name, std::size_t dimension) const {
  const PbrtParameter* found = dimension == 2
                                   ? find_of(name, {PbrtType::point2, PbrtType::vector2})
                                   : find_of(name, {PbrtType::point3, PbrtType::vector3, PbrtType::normal});
  return found ? reals(*found) : std::span<const float>();
}

bool PbrtParameters::was_asked(const PbrtParameter& parameter) const {
  return std::find(asked_.begin(), asked_.end(), parameter.name) != asked_.end();
}

std::string PbrtParameters::nearest_asked(const PbrtParameter& parameter) const {
  const std::vector<std::string_view> known(asked_.begin(), asked_.end());
  return nearest_name(parameter.name, known);
}

namespace {

void warn_of(const PbrtParameter& parameter, const char* where, const std::string& nearest,
             WarningList& warnings) {
  parameter.place.warn(warnings, fmt::format("\"{} {}\" is not known {}, and left out{}",
                                             PbrtParameters::type_name(parameter.type), parameter.name, where,
                                             nearest.empty() ? "" : fmt::format("; \"{}\" is", nearest)));
}

}  // namespace

void PbrtParameters::warn_of_unused(WarningList& warnings) const {
  for (const PbrtParameter& parameter : parameters_) {
    if (!was_asked(parameter))
      warn_of(parameter, "here", nearest_asked(parameter), warnings);
    else if (const PbrtParameter* last = own(parameter.name); last != &parameter)
      last->place.warn(warnings,
                       fmt::format("\"{}\" stands there a second time, and counts here", parameter.name));
  }
  if (defaults_) keep_use_of_defaults();
}

void PbrtParameters::keep_use_of_defaults() const {
  for (const PbrtParameter& parameter : defaults_->parameters_) {
    PbrtDefaultUse& use = *parameter.use;
    use.is_asked = use.is_asked || was_asked(parameter);
    if (!use.is_asked && !use.is_offered) use.nearest = nearest_asked(parameter);
    use.is_offered = true;
  }
}

void PbrtParameters::watch() {
  for (PbrtParameter& parameter : parameters_)
    if (!parameter.use) parameter.use = std::make_shared<PbrtDefaultUse>();
}

void PbrtParameters::warn_of_unused_defaults(WarningList& warnings) const {
  for (const PbrtParameter& parameter : parameters_)
    if (const PbrtDefaultUse& use = *parameter.use; use.is_offered && !use.is_asked)
      warn_of(parameter, "to what it is a default for", use.nearest, warnings);
}

}  // namespace twinray
