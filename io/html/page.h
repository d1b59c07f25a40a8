// SPDX-License-Identifier: Apache-2.0
// What the program's pages share: each is whole by itself, one file with nothing to load, and no script but
// a slider's line (io/html/slider.h).
#pragma once
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace twinray::html {

/// Replaces what HTML and SVG would take as their own.
std::string escaped(std::string_view text);

/// A whole document: one column that fits a phone as well as a desk. The body is HTML, the title is not.
std::string page(const std::string& title, const std::string& body);

/// Names beside their values, a row each.
std::string facts(const std::vector<std::pair<std::string, std::string>>& rows);

/// A row of a table; its cells are HTML. `kind`: "base" for what the others are compared with.
std::string row(const std::vector<std::string>& cells, const std::string& kind = "");

/// The text, broken between words where the page is too narrow for it, but not between "-s" and its values;
/// within words only where these are too long for a line, behind a slash or underscore if there is one.
std::string whole_words(const std::string& text);

/// A table of such rows, which scrolls sideways where the page is too narrow for it.
std::string table(const std::vector<std::string>& heads, const std::string& rows);

}  // namespace twinray::html
