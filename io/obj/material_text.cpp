// SPDX-License-Identifier: Apache-2.0
#include "io/obj/material_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "io/obj/text.h"

namespace twinray {
namespace {

constexpr std::array<std::string_view, 6> color_values{"Ka", "Kd", "Ks", "Ke", "Kt", "Tf"};
constexpr std::array<std::string_view, 11> number_values{"Ni", "Ns", "d",   "Tr",    "Pr",    "Pm",
                                                         "Ps", "Pc", "Pcr", "aniso", "anisor"};
constexpr std::array<std::string_view, 5> picture_values{"bump", "norm", "disp", "refl", "decal"};

/// An option of a picture, and how many values it has.
struct Option {
  std::string_view name;
  std::size_t values;
  std::string_view usual = "";  ///< Stands for the values that a file may leave out, which are numbers.
};
constexpr std::array<Option, 14> options{{{"-blendu", 1},
                                          {"-blendv", 1},
                                          {"-boost", 1},
                                          {"-bm", 1},
                                          {"-cc", 1},
                                          {"-clamp", 1},
                                          {"-colorspace", 1},
                                          {"-imfchan", 1},
                                          {"-mm", 2},
                                          {"-o", 3, "0"},
                                          {"-s", 3, "1"},
                                          {"-t", 3, "0"},
                                          {"-texres", 1},
                                          {"-type", 1}}};

template <typename List>
bool contains(const List& list, std::string_view word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

bool is_picture(std::string_view keyword) {
  return keyword.starts_with("map_") || contains(picture_values, keyword);
}

/// Takes an option's values off a line: all of them.
std::string take_values(const Option& option, std::string_view& line) {
  std::string values;
  for (std::size_t i = 0; i < option.values; ++i) {
    std::string_view rest = line;
    const std::string_view word = take_word(rest);
    const bool is_left_out = !option.usual.empty() && !is_number(word);
    if (!is_left_out) line = rest;
    values += fmt::format(" {}", is_left_out ? option.usual : word);
  }
  return values;
}

/// The options and the name of a picture.
std::string picture_words(std::string_view line) {
  std::string made;
  for (std::string_view rest = line;; line = rest) {
    const std::string_view word = take_word(rest);
    const auto option =
        std::find_if(options.begin(), options.end(), [&](const Option& o) { return o.name == word; });
    if (option == options.end()) return made + std::string(line);  // A name may have spaces.
    const std::string values = take_values(*option, rest);
    if (word != "-cc") made += fmt::format(" {}{}", word, values);
  }
}

/// So many numbers: 0 for each that is missing or none, which makes `is_wrong` true.
std::string number_words(std::string_view line, std::size_t count, bool& is_wrong) {
  std::vector<std::string_view> words;
  for (std::string_view word; !(word = take_word(line)).empty();)
    if (word != "-halo") words.push_back(word);
  if (words.size() == 1) words.resize(count, words[0]);
  words.resize(count);
  std::string made;
  for (const std::string_view word : words) {
    is_wrong |= !is_number(word);
    made += fmt::format(" {}", is_number(word) ? word : "0");
  }
  return made;
}

}  // namespace

std::string material_text(const std::string& path, const std::string& text, WarningList& warnings) {
  const std::string joined = joined_lines(text);
  std::string made;
  for (std::string_view left = joined; !left.empty();) {
    const std::string_view line = left.substr(0, left.find_first_of("\r\n"));
    std::string_view rest = line;
    bool is_wrong = false;
    const std::string_view keyword = take_word(rest);
    made += keyword;
    if (is_picture(keyword))
      made += picture_words(rest);
    else if (contains(color_values, keyword) || contains(number_values, keyword))
      made += number_words(rest, contains(color_values, keyword) ? 3 : 1, is_wrong);
    else
      made += rest;
    if (keyword == "newmtl") made += "\nKd 0 0 0";
    made += '\n';
    if (is_wrong)
      warnings.add([&] { return place_of(path, text, std::size_t(line.data() - joined.data())); },
                   fmt::format("a number of \"{}\" is missing or none: 0 stands for it", keyword));
    left.remove_prefix(std::min(line.size() + 1, left.size()));
  }
  return made;
}

}  // namespace twinray
