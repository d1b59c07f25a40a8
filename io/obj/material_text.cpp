// SPDX-License-Identifier: Apache-2.0
#include "io/obj/material_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <string_view>
#include <vector>

#include "core/color_matrix.h"
#include "io/number_list.h"
#include "io/obj/text.h"

namespace twinray {
namespace {

constexpr std::array<std::string_view, 6> color_values{"Ka", "Kd", "Ks", "Ke", "Kt", "Tf"};
constexpr std::array<std::string_view, 11> number_values{"Ni", "Ns", "d",   "Tr",    "Pr",    "Pm",
                                                         "Ps", "Pc", "Pcr", "aniso", "anisor"};
constexpr std::array<std::string_view, 5> picture_values{"bump", "norm", "disp", "refl", "decal"};
/// Pictures, of those whose names begin with map_.
constexpr std::array<std::string_view, 11> maps{"map_Ka",   "map_Kd",   "map_Ks", "map_Ke", "map_Ns", "map_d",
                                                "map_bump", "map_Bump", "map_Pr", "map_Pm", "map_Ps"};
constexpr std::array<std::string_view, 4> color_pictures{"map_Ka", "map_Kd", "map_Ks", "map_Ke"};
/// That have another form, or say nothing to a path tracer.
constexpr std::array<std::string_view, 4> other_words{"newmtl", "illum", "sharpness", "map_aat"};

/// Statements of which one is enough to say what a material looks like.
constexpr std::array<std::string_view, 9> looks{"Kd",     "map_Kd", "Ks", "map_Ks", "Ke",
                                                "map_Ke", "Kt",     "Tf", "Ni"};

/// An option of a picture, and how many values it has.
struct Option {
  std::string_view name;
  std::size_t values;
  std::string_view usual = "";  ///< Stands for the values that a file may leave out, which are numbers.
  /// Where the option would change the picture and is not read: the value with which it does not.
  std::string_view plain = "";
};
constexpr std::array<Option, 14> options{{{"-blendu", 1},
                                          {"-blendv", 1},
                                          {"-boost", 1},
                                          {"-bm", 1},
                                          {"-cc", 1, "", "off"},
                                          {"-clamp", 1},
                                          {"-colorspace", 1},
                                          {"-imfchan", 1},
                                          {"-mm", 2},
                                          {"-o", 3, "0"},
                                          {"-s", 3, "1"},
                                          {"-t", 3, "0"},
                                          {"-texres", 1},
                                          {"-type", 1, "", "none"}}};

template <typename List>
bool contains(const List& list, std::string_view word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

bool is_known(std::string_view keyword) {
  return keyword.empty() || contains(maps, keyword) || contains(picture_values, keyword) ||
         contains(color_values, keyword) || contains(number_values, keyword) ||
         contains(other_words, keyword);
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

/// What is to be told of a line.
struct LineFaults {
  bool has_no_number = false;  ///< One that is missing or none.
  bool is_spectrum = false;
  std::string left_out;  ///< An option of a picture that would change it and is not read.
};

/// Whether a picture without the option, or with another value, would be another.
bool matters(const Option& option, std::string_view value, std::string_view keyword) {
  if (option.name == "-imfchan" && contains(color_pictures, keyword)) return true;
  return !option.plain.empty() && value != option.plain;
}

/// The name on the rest of a line, up to a comment, which begins behind blank space.
std::string_view name_in(std::string_view line) {
  return trimmed(line.substr(0, std::min(line.find(" #"), line.find("\t#"))));
}

/// The options and the name of a picture.
std::string picture_words(std::string_view keyword, std::string_view line, LineFaults& faults) {
  std::string made;
  for (std::string_view rest = line;; line = rest) {
    const std::string_view word = take_word(rest);
    const auto option =
        std::find_if(options.begin(), options.end(), [&](const Option& o) { return o.name == word; });
    if (option == options.end()) return fmt::format("{} {}", made, name_in(line));  // A name may have spaces.
    const std::string values = take_values(*option, rest);
    if (matters(*option, std::string_view(values).substr(1), keyword)) faults.left_out = word;
    if (word != "-cc") made += fmt::format(" {}{}", word, values);
  }
}

/// So many numbers: 0 for each that is missing or none, which is a fault.
std::string number_words(std::string_view line, std::size_t count, LineFaults& faults) {
  std::vector<std::string_view> words;
  for (std::string_view word; !(word = take_word(line)).empty();)
    if (word != "-halo") words.push_back(word);
  if (words.size() == 1) words.resize(count, words[0]);
  words.resize(count);
  std::string made;
  for (const std::string_view word : words) {
    faults.has_no_number |= !is_number(word);
    made += fmt::format(" {}", is_number(word) ? word : "0");
  }
  return made;
}

/// A colour by CIE's XYZ, which stand behind this word, as one by its channels; Y and Z may be left out where
/// they are as X.
std::string words_of_xyz(std::string_view line) {
  const ObjNumbers numbers = read_numbers(line);
  const auto& [x, y, z] = std::array<double, 3>{numbers.values[0], numbers.values[numbers.count > 1 ? 1 : 0],
                                                numbers.values[numbers.count > 2 ? 2 : 0]};
  const auto [r, g, b] = transformed(inverse(to_xyz(srgb_primaries)), std::array<double, 3>{x, y, z});
  return fmt::format(" {:.9g} {:.9g} {:.9g}", r, g, b);
}

/// The words of a colour behind its keyword.
std::string color_words(std::string_view line, LineFaults& faults) {
  std::string_view rest = line;
  const std::string_view form = take_word(rest);
  faults.is_spectrum = form == "spectral";
  if (faults.is_spectrum) return " 0.5 0.5 0.5";
  return form == "xyz" ? words_of_xyz(line) : number_words(line, 3, faults);
}

/// The words of a line behind its keyword.
std::string words_of(std::string_view keyword, std::string_view line, LineFaults& faults) {
  if (is_picture(keyword)) return picture_words(keyword, line, faults);
  if (contains(color_values, keyword)) return color_words(line, faults);
  if (contains(number_values, keyword)) return number_words(line, 1, faults);
  return std::string(line);
}

/// Tells of what is wrong with a line.
void warn(std::string_view keyword, const LineFaults& faults, const std::function<Place()>& place,
          WarningList& warnings) {
  if (faults.has_no_number)
    warnings.add(place, fmt::format("a number of \"{}\" is missing or none: 0 stands for it", keyword));
  if (faults.is_spectrum)
    warnings.add(place, fmt::format("the spectrum of \"{}\" is not read: 0.5 stands for it", keyword));
  if (!faults.left_out.empty())
    warnings.add(place, fmt::format("\"{}\" of \"{}\" is left out", faults.left_out, keyword));
  if (!is_known(keyword)) warnings.add(place, fmt::format("\"{}\" is not known; it is left out", keyword));
}

/// Finds materials of which nothing says what they look like.
class UnseenMaterials {
 public:
  explicit UnseenMaterials(WarningList& warnings) : warnings_(warnings) {}

  void read(std::string_view keyword, std::string_view rest, const std::function<Place()>& place) {
    if (keyword == "newmtl") {
      end();
      name_ = trimmed(rest);
      place_ = place;
      is_open_ = true;
    }
    is_open_ &= !contains(looks, keyword);
  }
  /// The material ends.
  void end() {
    if (is_open_)
      warnings_.add(place_,
                    fmt::format("nothing says what the material \"{}\" reflects (Kd); it is black", name_));
    is_open_ = false;
  }

 private:
  WarningList& warnings_;
  std::string name_;
  std::function<Place()> place_;
  bool is_open_ = false;  ///< A material began, and nothing was said yet.
};

}  // namespace

std::string material_text(const std::string& path, const std::string& text, WarningList& warnings) {
  const std::string joined = joined_lines(text);
  std::string made;
  UnseenMaterials unseen(warnings);
  for (std::string_view left = joined; !left.empty();) {
    const std::string_view line = left.substr(0, left.find_first_of("\r\n"));
    std::string_view rest = line;
    const std::string_view keyword = take_word(rest);
    const auto offset = std::size_t(line.data() - joined.data());
    const auto place = [&path, &text, offset] { return place_of(path, text, offset); };
    LineFaults faults;
    made += keyword;
    made += words_of(keyword, rest, faults);
    if (keyword == "newmtl") made += "\nKd 0 0 0";
    if (keyword == "Pr") made += fmt::format("\n{} 1", roughness_mark);
    made += '\n';
    warn(keyword, faults, place, warnings);
    unseen.read(keyword, rest, place);
    left.remove_prefix(std::min(line.size() + 1, left.size()));
  }
  unseen.end();
  return made;
}

}  // namespace twinray
