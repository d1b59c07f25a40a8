// SPDX-License-Identifier: Apache-2.0
#include "io/stl/ascii.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/geometry.h"
#include "io/decimal.h"
#include "io/lower_case.h"
#include "io/polygon.h"

namespace twinray {
namespace {

constexpr std::string_view blanks = " \t\r\n\v\f";

class AsciiReader {
 public:
  AsciiReader(std::string_view text, const std::string& path, WarningList& warnings, ObjModel& model)
      : text_(text), path_(path), warnings_(warnings), model_(model) {}

  void read() {
    while (!take_word().empty()) {
      if (is("solid"))
        begin_solid(rest_of_line());
      else if (is("endsolid"))
        is_in_solid_ = (rest_of_line(), false);
      else if (is("facet"))
        read_facet();
      else
        fail_here("solid, facet and endsolid");
    }
    if (is_in_solid_)
      warnings_.add([&] { return place(text_.size()); },
                    "the file ends without \"endsolid\": facets may be missing");
  }

 private:
  void begin_solid(std::string_view name) {
    model_.faces.emplace_back();
    model_.faces.back().object = name;
    is_in_solid_ = true;
  }

  void read_facet() {
    if (model_.faces.empty()) begin_solid("");
    take_word();
    if (is("normal")) {
      for (int i = 0; i < 3; ++i) take_word();
      take_word();
    }
    require("outer");
    take_word();
    require("loop");
    std::uint32_t corners = 0;
    for (take_word(); is("vertex"); take_word()) {
      if (++corners > max_polygon_corners)
        fail(fmt::format("a facet has more than {} vertices", max_polygon_corners));
      read_vertex();
    }
    require("endloop");
    take_word();
    require("endfacet");
    add_facet(corners);
  }

  void read_vertex() {
    Vec3 position;
    for (float* const coordinate : {&position.x, &position.y, &position.z}) {
      take_word();
      require_more();
      const Decimal<float> number = read_decimal<float>(word_);
      if (number.fault == DecimalFault::no_number || number.fault == DecimalFault::not_finite)
        fail(fmt::format("a coordinate that is no number: \"{}\"", word_));
      if (number.fault == DecimalFault::too_large || !(std::abs(number.value) <= max_coordinate))
        fail(fmt::format("a coordinate lies beyond +-{:g}", max_coordinate));
      *coordinate = number.value;
    }
    model_.positions.push_back(position);
  }

  /// Its corners are the last positions.
  void add_facet(std::uint32_t corners) {
    const auto first = std::uint32_t(model_.positions.size() - corners);
    if (corners < 3) {
      ++model_.small_faces;
      return;
    }
    ObjFaces& faces = model_.faces.back();
    for (std::uint32_t i = 0; i < corners; ++i) faces.corners.push_back({first + i});
    faces.sizes.push_back(corners);
  }

  std::string_view take_word() {
    begin_ = std::min(text_.find_first_not_of(blanks, end_), text_.size());
    end_ = std::min(text_.find_first_of(blanks, begin_), text_.size());
    return word_ = text_.substr(begin_, end_ - begin_);
  }
  std::string_view rest_of_line() {
    const std::size_t begin = end_;
    end_ = std::min(text_.find_first_of("\r\n", begin), text_.size());
    const std::string_view line = text_.substr(begin, end_ - begin);
    const std::size_t first = line.find_first_not_of(blanks);
    if (first == line.npos) return "";
    return line.substr(first, line.find_last_not_of(blanks) + 1 - first);
  }
  bool is(std::string_view keyword) const {
    return word_.size() == keyword.size() && (word_ == keyword || lower_case(std::string(word_)) == keyword);
  }
  void require(std::string_view keyword) const {
    require_more();
    if (!is(keyword)) fail_here(keyword);
  }
  void require_more() const {
    if (word_.empty()) fail("the file ends within a facet: it is cut off");
  }

  Place place(std::size_t at) const { return place_of(path_, text_, at); }
  [[noreturn]] void fail(const std::string& message) const { throw error_at(place(begin_), message); }
  [[noreturn]] void fail_here(std::string_view valid) const {
    fail(fmt::format("\"{}\" is not known here; valid are {}", word_, valid));
  }

  std::string_view text_;
  const std::string& path_;
  WarningList& warnings_;
  ObjModel& model_;
  std::size_t begin_ = 0, end_ = 0;  ///< Of the last word.
  std::string_view word_;
  bool is_in_solid_ = false;
};

}  // namespace

void read_ascii_stl(std::string_view text, const std::string& path, WarningList& warnings, ObjModel& model) {
  AsciiReader(text, path, warnings, model).read();
}

}  // namespace twinray
