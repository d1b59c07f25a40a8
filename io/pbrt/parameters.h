// SPDX-License-Identifier: Apache-2.0
// The typed parameters of a statement: "float fov" 45, "point3 P" [ 0 0 0 1 0 0 ]. Whoever makes something of
// them asks for each by its name; what nobody asked for is named in a warning.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/vec.h"
#include "io/pbrt/color_space.h"
#include "io/pbrt/lexer.h"

namespace twinray {

enum class PbrtType {
  boolean,
  integer,
  real,
  point2,
  vector2,
  point3,
  vector3,
  normal,
  rgb,
  blackbody,
  spectrum,
  string,
  texture
};

/// What becomes of a parameter that an Attribute statement gives.
struct PbrtDefaultUse {
  bool is_offered = false;  ///< To a statement that asked for what it knows,
  bool is_asked = false;    ///< and one of them did for this.
  std::string nearest;      ///< What the first one knows that is named nearly so; empty without any.
};

/// One parameter: its values are a part of the lists of its PbrtParameters.
struct PbrtParameter {
  PbrtType type = PbrtType::real;
  std::string name;
  PbrtPlace place;           ///< Of "type name".
  bool has_strings = false;  ///< Of a spectrum: it is a name or a file.
  std::size_t first = 0, count = 0;
  // Of an Attribute: the color space where it stands, and what becomes of it.
  std::optional<PbrtColorSpace> color_space = {};
  std::shared_ptr<PbrtDefaultUse> use = {};
};

struct NumberRange {
  double least, most;
};

class PbrtParameters {
 public:
  /// Forgets all parameters, not the memory that they took.
  void clear(const PbrtPlace& place);
  /// Reads parameters up to the first token that is not a string. Throws Error where one is not of the form
  /// "type name" values.
  void read(PbrtLexer& lexer);
  /// Adds the parameters that an Attribute statement gave: they hold where none of that name was written.
  void set_defaults(std::shared_ptr<const PbrtParameters> defaults) { defaults_ = std::move(defaults); }
  /// Adds all parameters of others, which win over those of the same name.
  void append(const PbrtParameters& others);

  /// Of the statement.
  const PbrtPlace& place() const { return place_; }
  bool is_empty() const { return parameters_.empty(); }

  // Each gives `fallback` where there is no such parameter, and throws Error where it is of another type, has
  // not one value, or lies outside of its range.

  float real(const char* name, float fallback, const NumberRange& range = any) const;
  std::int32_t integer(const char* name, std::int32_t fallback, const NumberRange& range = any) const;
  bool flag(const char* name, bool fallback) const;
  std::string text(const char* name, const std::string& fallback) const;
  Vec3 point(const char* name, const Vec3& fallback) const;

  // Lists; empty where there is no such parameter.

  std::span<const float> reals(const char* name) const;
  std::span<const std::int32_t> integers(const char* name) const;
  std::span<const std::string> texts(const char* name) const;
  /// Numbers in twos or threes, of the types that mean points, vectors or normals.
  std::span<const float> tuples(const char* name, std::size_t dimension) const;

  /// A parameter of whatever type.
  const PbrtParameter* find(const char* name) const;
  /// Its values.
  std::span<const float> reals(const PbrtParameter& parameter) const;
  const std::string& text(const PbrtParameter& parameter) const;

  /// The color space of rgb values (the ColorSpace statement).
  PbrtColorSpace color_space = PbrtColorSpace::srgb;

  /// Warns of each parameter that was not asked for, with the nearest name that was; of defaults it is kept
  /// which were.
  void warn_of_unused(WarningList& warnings) const;
  /// From now on it is kept what becomes of each as a default.
  void watch();
  /// Of those: warns of each for which none of the statements asked that it was offered to.
  void warn_of_unused_defaults(WarningList& warnings) const;

  /// "point3"
  static std::string_view type_name(PbrtType type);
  static constexpr NumberRange any{-3.4e38, 3.4e38};

 private:
  void read_one(PbrtLexer& lexer);
  void read_value(const PbrtToken& token, PbrtParameter& parameter);
  void check_count(const PbrtParameter& parameter) const;
  bool was_asked(const PbrtParameter& parameter) const;
  std::string nearest_asked(const PbrtParameter& parameter) const;
  void keep_use_of_defaults() const;
  const PbrtParameter* own(std::string_view name) const;
  const PbrtParameter* find_of(const char* name, std::initializer_list<PbrtType> types) const;
  const PbrtParameters& owner_of(const PbrtParameter& parameter) const;
  const PbrtParameter* single(const char* name, std::initializer_list<PbrtType> types) const;

  PbrtPlace place_;
  std::vector<PbrtParameter> parameters_;
  std::vector<float> reals_;
  std::vector<std::int32_t> integers_;  ///< Of integers; booleans as 0 and 1.
  std::vector<std::string> strings_;
  std::shared_ptr<const PbrtParameters> defaults_;
  mutable std::vector<std::string> asked_;  ///< The names that were asked for.
};

}  // namespace twinray
