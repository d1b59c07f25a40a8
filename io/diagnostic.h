// SPDX-License-Identifier: Apache-2.0
// What is wrong with an input file, and where: the form of all messages about files.
#pragma once
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace twinray {

/// A place in a text file. Lines and columns count from 1; columns count characters, not bytes. Line 0 is the
/// file as a whole.
struct Place {
  std::string file;
  int line = 0;
  int column = 0;
  std::string excerpt;   ///< The line, or the part of a long one around the place.
  int caret_column = 0;  ///< Where the place is within the excerpt, from 1.
};

/// The place of a byte of a text (an offset beyond the end is the end).
Place place_of(const std::string& file, std::string_view text, std::size_t offset);

/// "file:line:column: message", and below it the excerpt with a caret where the place has a line.
std::string message_at(const Place& place, const std::string& message);

/// An error that knows its place and what is wrong there; its text is message_at().
class PlacedError : public Error {
 public:
  PlacedError(const Place& place, const std::string& message);

  const Place& place() const { return place_; }
  const std::string& message() const { return message_; }

 private:
  Place place_;
  std::string message_;
};

/// The error to throw.
PlacedError error_at(const Place& place, const std::string& message);

/// Something in a file that was not used as it stands: a value, which a program prints or not.
struct Diagnostic {
  Place place;
  std::string message;
  int count = 1;  ///< How often the same was found; `place` is the first time.

  /// The whole text, as message_at() has it.
  std::string text() const;
};

/// Gathers warnings; the same message is kept once and counted, and so are all beyond most_kept different
/// ones. Strict: the first one is thrown as an Error.
class WarningList {
 public:
  explicit WarningList(bool strict) : strict_(strict) {}
  /// `where` is asked for only when the message is new.
  void add(const std::function<Place()>& where, const std::string& message);
  const std::vector<Diagnostic>& items() const { return items_; }

  static constexpr std::size_t most_kept = 100;

 private:
  bool strict_;
  std::vector<Diagnostic> items_;
};

/// The known name with the least edit distance (insert, delete, replace or swap a letter; capitals count as
/// equal), if that is at most a third of the name's length, rounded up; else "".
std::string nearest_name(std::string_view name, std::span<const std::string_view> known);

/// "a", "a or b", "a, b or c".
std::string list_names(std::span<const std::string_view> names);

}  // namespace twinray
