// SPDX-License-Identifier: Apache-2.0
#include "core/square_density.h"

#include <cmath>

namespace twinray {
namespace {

/// A function that is linear over [0, 1], by its values at the ends.
struct Line {
  double first, last;

  double at(double t) const { return first + (last - first) * t; }
  double integral(double t = 1) const { return t * (first + 0.5 * (last - first) * t); }
  /// Where integral() is so much.
  double reach(double amount) const {
    const double root = std::sqrt(std::max(0.0, first * first + 2 * amount * (last - first)));
    const double divisor = first + root;
    return divisor > 0 ? std::min(2 * amount / divisor, 1.0) : 0;
  }
};

/// The last of the first `count` indices whose value is at most `target`; 0 where none is. Values increase.
template <typename Value>
std::size_t last_up_to(std::size_t count, double target, const Value& value) {
  std::size_t first = 0, beyond = count;
  while (beyond - first > 1) {
    const std::size_t middle = (first + beyond) / 2;
    (value(middle) <= target ? first : beyond) = middle;
  }
  return first;
}

/// Below it a slice is as one of zeros: its integral would be no normal float.
constexpr float least_density = 1e-30f;

SquareTable<float> even_where_zero(const SquareTable<float>& given) {
  const std::size_t nodes = given.width() * given.height();
  std::vector<float> values = given.values();
  for (std::size_t first = 0; first < values.size(); first += nodes) {
    const auto begin = values.begin() + std::ptrdiff_t(first), end = begin + std::ptrdiff_t(nodes);
    for (auto value = begin; value != end; ++value)
      if (!(*value >= 0) || !std::isfinite(*value))
        throw Error("a density has a number that is negative or not finite");
    if (*std::max_element(begin, end) < least_density) std::fill(begin, end, 1.0f);
  }
  return {given.width(), given.height(), std::move(values)};
}

}  // namespace

SquareDensity::SquareDensity(const SquareTable<float>& table) : table_(even_where_zero(table)) {
  for (std::size_t slice = 0; slice < table_.slices(); ++slice) {
    double rows = 0, line_before = 0;
    for (std::size_t y = 0; y < table_.height(); ++y) {
      double line = 0;
      lines_.push_back(0);
      for (std::size_t x = 0; x + 1 < table_.width(); ++x) {
        line += Line{table_.node(slice, x, y), table_.node(slice, x + 1, y)}.integral();
        lines_.push_back(float(line));
      }
      line = double(lines_.back());
      if (y > 0) rows += Line{line_before, line}.integral();
      rows_.push_back(float(rows));
      line_before = line;
    }
    if (!std::isfinite(rows_.back())) throw Error("the numbers of a density are too large");
    weights_.push_back(1 / double(rows_.back()));
  }
}

SliceBlend SquareDensity::normalized(const SliceBlend& blend) const {
  SliceBlend scaled = blend;
  for (std::size_t i = 0; i < blend.count; ++i) scaled.weights[i] *= weights_[blend.slices[i]];
  return scaled;
}

double SquareDensity::value(const SliceBlend& blend, std::size_t x, std::size_t y, double within_y) const {
  double sum = 0;
  for (std::size_t i = 0; i < blend.count; ++i) {
    const Line line{table_.node(blend.slices[i], x, y), table_.node(blend.slices[i], x, y + 1)};
    sum += blend.weights[i] * line.at(within_y);
  }
  return sum;
}

double SquareDensity::before_row(const SliceBlend& blend, std::size_t y) const {
  double sum = 0;
  for (std::size_t i = 0; i < blend.count; ++i)
    sum += blend.weights[i] * double(rows_[blend.slices[i] * table_.height() + y]);
  return sum;
}

double SquareDensity::before_node(const SliceBlend& blend, std::size_t x, std::size_t y) const {
  double sum = 0;
  for (std::size_t i = 0; i < blend.count; ++i)
    sum += blend.weights[i] * double(lines_[(blend.slices[i] * table_.height() + y) * table_.width() + x]);
  return sum;
}

double SquareDensity::on_line(const SliceBlend& blend, std::size_t y) const {
  return before_node(blend, table_.width() - 1, y);
}

float SquareDensity::pdf_of(double value) const {
  return float(value * double(table_.width() - 1) * double(table_.height() - 1));
}

SquareDensity::Sample SquareDensity::sample(Vec2 u, const SliceBlend& blend) const {
  const SliceBlend scaled = normalized(blend);
  const std::size_t last_x = table_.width() - 1, last_y = table_.height() - 1;
  const double above = double(u.y) * before_row(scaled, last_y);
  const std::size_t y = last_up_to(last_y, above, [&](std::size_t i) { return before_row(scaled, i); });
  const Line row{on_line(scaled, y), on_line(scaled, y + 1)};
  const double within_y = row.reach(above - before_row(scaled, y));

  const auto before = [&](std::size_t x) {
    return Line{before_node(scaled, x, y), before_node(scaled, x, y + 1)}.at(within_y);
  };
  const double along = double(u.x) * row.at(within_y);
  const std::size_t x = last_up_to(last_x, along, before);
  const Line cell{value(scaled, x, y, within_y), value(scaled, x + 1, y, within_y)};
  const double within_x = cell.reach(along - before(x));
  return {{float((double(x) + within_x) / double(last_x)), float((double(y) + within_y) / double(last_y))},
          pdf_of(cell.at(within_x))};
}

SquareDensity::Sample SquareDensity::invert(Vec2 point, const SliceBlend& blend) const {
  const SliceBlend scaled = normalized(blend);
  const auto [x, y, place] = table_.place(point);
  const double within_x = double(place.x), within_y = double(place.y);
  const Line cell{value(scaled, x, y, within_y), value(scaled, x + 1, y, within_y)};
  const double before = Line{before_node(scaled, x, y), before_node(scaled, x, y + 1)}.at(within_y);
  const Line row{on_line(scaled, y), on_line(scaled, y + 1)};
  const double whole = row.at(within_y), all = before_row(scaled, table_.height() - 1);
  const auto part = [](double of, double sum) { return float(sum > 0 ? std::min(of / sum, 1.0) : 0); };
  return {{part(before + cell.integral(within_x), whole),
           part(before_row(scaled, y) + row.integral(within_y), all)},
          pdf_of(cell.at(within_x))};
}

float SquareDensity::pdf(Vec2 point, const SliceBlend& blend) const {
  const SliceBlend scaled = normalized(blend);
  const auto [x, y, place] = table_.place(point);
  const Line cell{value(scaled, x, y, double(place.y)), value(scaled, x + 1, y, double(place.y))};
  return pdf_of(cell.at(double(place.x)));
}

}  // namespace twinray
