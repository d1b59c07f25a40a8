// SPDX-License-Identifier: Apache-2.0
// The words of pbrt's text format: names and numbers, "strings", brackets; comments from # to the line's end.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "io/byte_order_mark.h"
#include "io/pbrt/file.h"

namespace twinray {

struct PbrtToken {
  enum class Kind { word, string, open, close, end };
  Kind kind = Kind::end;
  std::string_view text;  ///< Of a string what stands between its quotes, as it is written.
  PbrtPlace place;

  bool is_string() const { return kind == Kind::string; }
  /// A string with its escapes (\" and \\, \n and \t and the like) resolved.
  std::string unescaped() const;
  /// The number that the whole word is, finite and rounded once. Throws Error at its place.
  float real() const;
  double precise() const;
  std::int32_t integer() const;
};

/// Takes a file apart, token by token. The file must outlive it, and all tokens.
class PbrtLexer {
 public:
  /// Throws Error where the text begins with what is not a token.
  explicit PbrtLexer(const PbrtFile& file) : file_(&file), at_(mark_size(file.text)) { advance(); }

  const PbrtFile& file() const { return *file_; }
  /// The token that take() gives. At the end of the file, of kind end.
  const PbrtToken& next() const { return next_; }
  /// Throws Error where what follows is not a token: a string that does not end on its line.
  PbrtToken take() {
    const PbrtToken token = next_;
    advance();
    return token;
  }

 private:
  void advance();
  void skip_space();

  const PbrtFile* file_;
  std::size_t at_;
  int line_ = 1;
  PbrtToken next_;
};

/// A token as messages show it: what it is, and its first letters.
std::string shown(const PbrtToken& token);

}  // namespace twinray
