// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/lexer.h"

#include <fmt/format.h>

#include <array>
#include <limits>

#include "io/decimal.h"

namespace twinray {
namespace {

constexpr std::size_t longest_shown = 32;

bool is_space(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r' || c == '\f' || c == '\v'; }
bool ends_word(char c) { return is_space(c) || c == '"' || c == '[' || c == ']' || c == '#'; }

/// Its first letters. A zero byte would end the message.
std::string cut(std::string_view text) {
  std::string shown;
  for (const char c : text.substr(0, longest_shown)) shown += c == 0 ? std::string("\\0") : std::string(1, c);
  return text.size() <= longest_shown ? shown : shown + "...";
}

template <typename Number>
Number parse(const PbrtToken& token, const char* kind) {
  const Decimal<Number> number = read_decimal<Number>(token.text);
  if (token.kind == PbrtToken::Kind::word && number.fault == DecimalFault::none) return number.value;
  if (token.kind == PbrtToken::Kind::word && number.fault == DecimalFault::too_large)
    token.place.fail(fmt::format("{} is too large; numbers lie within +-{:.10g}", shown(token),
                                 double(std::numeric_limits<Number>::max())));
  token.place.fail(fmt::format("{} is not a {}", shown(token), kind));
}

/// What stands for a letter behind a backslash; 0 for none.
char escaped(char letter) {
  constexpr std::array<std::pair<char, char>, 8> letters{{{'n', '\n'},
                                                          {'t', '\t'},
                                                          {'r', '\r'},
                                                          {'b', '\b'},
                                                          {'f', '\f'},
                                                          {'\\', '\\'},
                                                          {'"', '"'},
                                                          {'\'', '\''}}};
  for (const auto& [name, meaning] : letters)
    if (name == letter) return meaning;
  return 0;
}

}  // namespace

std::string shown(const PbrtToken& token) {
  if (token.kind == PbrtToken::Kind::end) return "the end of the file";
  if (token.kind == PbrtToken::Kind::string) return fmt::format("the string \"{}\"", cut(token.text));
  return fmt::format("\"{}\"", cut(token.text));
}

std::string PbrtToken::unescaped() const {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\\') {
      result += text[i];
      continue;
    }
    const char meaning = escaped(text[++i]);
    if (meaning == 0)
      place.fail(fmt::format("\\{} stands for nothing in a string; a backslash is written \\\\", text[i]));
    result += meaning;
  }
  return result;
}

float PbrtToken::real() const { return parse<float>(*this, "number"); }
double PbrtToken::precise() const { return parse<double>(*this, "number"); }
std::int32_t PbrtToken::integer() const { return parse<std::int32_t>(*this, "whole number"); }

void PbrtLexer::skip_space() {
  const std::string& text = file_->text;
  while (at_ < text.size()) {
    if (text[at_] == '#') {
      at_ = std::min(text.find('\n', at_), text.size());
      continue;
    }
    if (!is_space(text[at_])) return;
    line_ += text[at_] == '\n';
    ++at_;
  }
}

void PbrtLexer::advance() {
  skip_space();
  const std::string_view text = file_->text;
  next_ = {PbrtToken::Kind::end, {}, {file_, at_, line_}};
  if (at_ == text.size()) return;
  const std::size_t begin = at_++;
  if (text[begin] == '[' || text[begin] == ']') {
    next_.kind = text[begin] == '[' ? PbrtToken::Kind::open : PbrtToken::Kind::close;
    next_.text = text.substr(begin, 1);
  } else if (text[begin] == '"') {
    while (at_ < text.size() && text[at_] != '"' && text[at_] != '\n')
      at_ += text[at_] == '\\' && at_ + 1 < text.size() && text[at_ + 1] != '\n' ? 2 : 1;
    if (at_ >= text.size() || text[at_] != '"')
      next_.place.fail("this string does not end on its line; a quotation mark is missing");
    next_.kind = PbrtToken::Kind::string;
    next_.text = text.substr(begin + 1, at_ - begin - 1);
    ++at_;
  } else {
    while (at_ < text.size() && !ends_word(text[at_])) ++at_;
    next_.kind = PbrtToken::Kind::word;
    next_.text = text.substr(begin, at_ - begin);
  }
}

}  // namespace twinray
