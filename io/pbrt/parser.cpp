// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/parser.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/pbrt/version_three.h"

namespace twinray {
namespace {

/// What follows the name of a directive.
enum class Form {
  nothing,
  numbers,     ///< `count` of them, in brackets or not.
  strings,     ///< `count` of them.
  parameters,  ///< `count` strings, then parameters.
  word,        ///< One word without quotes.
  two_strings  ///< One or two of them.
};

struct Grammar {
  std::string_view name;
  PbrtDirective directive;
  Form form;
  std::size_t count = 0;
};

using enum PbrtDirective;

/// In alphabetic order.
constexpr std::array<Grammar, 40> grammar{{
    {"Accelerator", accelerator, Form::parameters, 1},
    {"ActiveTransform", active_transform, Form::word},
    {"AreaLightSource", area_light_source, Form::parameters, 1},
    {"Attribute", attribute, Form::parameters, 1},
    {"AttributeBegin", attribute_begin, Form::nothing},
    {"AttributeEnd", attribute_end, Form::nothing},
    {"Camera", camera, Form::parameters, 1},
    {"ColorSpace", color_space, Form::strings, 1},
    {"ConcatTransform", concat_transform, Form::numbers, 16},
    {"CoordSysTransform", coord_sys_transform, Form::strings, 1},
    {"CoordinateSystem", coordinate_system, Form::strings, 1},
    {"Film", film, Form::parameters, 1},
    {"Identity", identity, Form::nothing},
    {"Import", import, Form::strings, 1},
    {"Include", include, Form::strings, 1},
    {"Integrator", integrator, Form::parameters, 1},
    {"LightSource", light_source, Form::parameters, 1},
    {"LookAt", look_at, Form::numbers, 9},
    {"MakeNamedMaterial", make_named_material, Form::parameters, 1},
    {"MakeNamedMedium", make_named_medium, Form::parameters, 1},
    {"Material", material, Form::parameters, 1},
    {"MediumInterface", medium_interface, Form::two_strings, 2},
    {"NamedMaterial", named_material, Form::strings, 1},
    {"ObjectBegin", object_begin, Form::strings, 1},
    {"ObjectEnd", object_end, Form::nothing},
    {"ObjectInstance", object_instance, Form::strings, 1},
    {"Option", option, Form::parameters, 0},
    {"PixelFilter", pixel_filter, Form::parameters, 1},
    {"ReverseOrientation", reverse_orientation, Form::nothing},
    {"Rotate", rotate, Form::numbers, 4},
    {"Sampler", sampler, Form::parameters, 1},
    {"Scale", scale, Form::numbers, 3},
    {"Shape", shape, Form::parameters, 1},
    {"Texture", texture, Form::parameters, 3},
    {"Transform", transform, Form::numbers, 16},
    {"TransformBegin", transform_begin, Form::nothing},
    {"TransformEnd", transform_end, Form::nothing},
    {"TransformTimes", transform_times, Form::numbers, 2},
    {"Translate", translate, Form::numbers, 3},
    {"WorldBegin", world_begin, Form::nothing},
}};

std::vector<std::string_view> directive_names() {
  std::vector<std::string_view> names;
  for (const Grammar& entry : grammar) names.push_back(entry.name);
  return names;
}

const Grammar& grammar_of(const PbrtToken& token) {
  const auto found =
      std::lower_bound(grammar.begin(), grammar.end(), token.text,
                       [](const Grammar& entry, std::string_view name) { return entry.name < name; });
  if (token.kind == PbrtToken::Kind::word && found != grammar.end() && found->name == token.text)
    return *found;
  const std::string nearest = nearest_name(token.text, directive_names());
  token.place.fail(fmt::format(
      "{} is not a directive of pbrt's format{}{}", shown(token),
      nearest.empty() ? ", such as Shape or Translate" : fmt::format("; {} is the nearest one", nearest),
      version_three_hint(token.text)));
}

void read_numbers(PbrtLexer& lexer, std::size_t count, PbrtStatement& statement) {
  const bool has_brackets = lexer.next().kind == PbrtToken::Kind::open;
  if (has_brackets) lexer.take();
  for (std::size_t i = 0; i < count; ++i) {
    const PbrtToken token = lexer.take();
    if (token.kind != PbrtToken::Kind::word)
      token.place.fail(fmt::format("{} stands where {} needs its number {} of {}", shown(token),
                                   statement.name, i + 1, count));
    statement.numbers[i] = token.precise();
  }
  if (!has_brackets) return;
  const PbrtToken end = lexer.take();
  if (end.kind != PbrtToken::Kind::close)
    end.place.fail(
        fmt::format("{} stands where ] should end the {} numbers of {}", shown(end), count, statement.name));
}

void read_string(PbrtLexer& lexer, PbrtStatement& statement) {
  const PbrtToken token = lexer.take();
  if (!token.is_string())
    token.place.fail(
        fmt::format("{} stands where {} needs a string in quotation marks", shown(token), statement.name));
  statement.words.push_back(token.unescaped());
}

void read_word(PbrtLexer& lexer, PbrtStatement& statement) {
  const PbrtToken token = lexer.take();
  if (token.kind != PbrtToken::Kind::word)
    token.place.fail(fmt::format("{} stands where {} needs a word", shown(token), statement.name));
  statement.words.emplace_back(token.text);
}

/// What an Option sets is written as a parameter, or, as pbrt's manual has it, as a string and a value.
void read_option(PbrtLexer& lexer, PbrtStatement& statement) {
  const PbrtToken name = lexer.next();
  if (!name.is_string() || name.text.find(' ') != std::string_view::npos) return;
  read_string(lexer, statement);
  const PbrtToken value = lexer.take();
  statement.words.emplace_back(value.text);
}

void read_rest(PbrtLexer& lexer, const Grammar& entry, PbrtStatement& statement) {
  if (entry.form == Form::numbers) return read_numbers(lexer, entry.count, statement);
  if (entry.form == Form::word) return read_word(lexer, statement);
  if (entry.form == Form::nothing) return;
  if (entry.directive == option) read_option(lexer, statement);
  const std::size_t needed = entry.form == Form::two_strings ? 1 : entry.count;
  for (std::size_t i = 0; i < needed; ++i) read_string(lexer, statement);
  if (entry.form == Form::two_strings && lexer.next().is_string()) read_string(lexer, statement);
  if (entry.form == Form::parameters) statement.parameters.read(lexer);
}

}  // namespace

PbrtParser::PbrtParser(PbrtFile file, const PbrtFiles& files) : disk_(files) {
  files_.push_back(std::make_unique<PbrtFile>(std::move(file)));
  open_.push_back({PbrtLexer(*files_.back()), false});
}

bool PbrtParser::next(PbrtStatement& statement) {
  while (!open_.empty()) {
    PbrtLexer& lexer = open_.back().lexer;
    const PbrtToken token = lexer.take();
    statement.place = token.place;
    statement.words.clear();
    statement.parameters.clear(token.place);
    if (token.kind == PbrtToken::Kind::end) {
      const bool is_import = open_.back().is_import;
      open_.pop_back();
      statement.directive = import_end;
      if (is_import) return true;
      continue;
    }
    const Grammar& entry = grammar_of(token);
    statement.directive = entry.directive;
    statement.name = entry.name;
    read_rest(lexer, entry, statement);
    if (entry.directive != include && entry.directive != import) return true;
    open(statement);
    statement.directive = import_begin;
    if (entry.directive == import) return true;
  }
  return false;
}

void PbrtParser::open(const PbrtStatement& statement) {
  if (open_.size() > max_depth)
    statement.place.fail(fmt::format("files include each other more than {} deep", max_depth));
  if (files_.size() >= max_files)
    statement.place.fail(fmt::format("more than {} files are included", max_files));
  const std::string path = disk_.path(statement.place, statement.words[0]);
  for (const OpenFile& file : open_)
    if (file.lexer.file().name == path)
      statement.place.fail(fmt::format("\"{}\" includes itself, here or by way of others", path));
  files_.push_back(std::make_unique<PbrtFile>(PbrtFile{path, disk_.bytes(statement.place, path)}));
  open_.push_back({PbrtLexer(*files_.back()), statement.directive == import});
}

}  // namespace twinray
