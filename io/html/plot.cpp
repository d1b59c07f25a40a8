// SPDX-License-Identifier: Apache-2.0
#include "io/html/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/elementary.h"
#include "io/html/page.h"

namespace twinray::html {
namespace {

constexpr double width = 640, letter = 6.3;

/// The greatest power of ten up to x > 0.
double power_of_ten(double x) {
  double power = 1;
  while (power * 10 <= x) power *= 10;
  while (power > x) power /= 10;
  return power;
}

/// From values to pixels along one axis.
class Scale {
 public:
  Scale(double low, double high, double begin, double end, bool is_log)
      : low_(low), high_(high), begin_(begin), end_(end), is_log_(is_log) {}
  double operator()(double value) const {
    const double part =
        is_log_ ? log2_of(value / low_) / log2_of(high_ / low_) : (value - low_) / (high_ - low_);
    return begin_ + (end_ - begin_) * part;
  }
  std::vector<double> ticks() const { return is_log_ ? log_ticks() : linear_ticks(); }

 private:
  std::vector<double> log_ticks() const {
    std::vector<double> all;
    const double span = high_ / low_;
    std::vector<double> steps{1};
    if (span <= 300) steps = {1, 2, 5};
    if (span <= 12) steps = {1, 1.5, 2, 3, 4, 5, 7};
    for (double power = power_of_ten(low_); power <= high_; power *= 10)
      for (const double step : steps)
        if (const double tick = power * step; tick >= 0.999 * low_ && tick <= 1.001 * high_)
          all.push_back(tick);
    return all;
  }
  std::vector<double> linear_ticks() const {
    double step = power_of_ten(high_ - low_);
    while ((high_ - low_) / step < 4) step /= 2;
    std::vector<double> all;
    for (double tick = low_; tick <= high_ + 1e-9 * step; tick += step) all.push_back(tick);
    return all;
  }
  double low_, high_, begin_, end_;
  bool is_log_;
};

/// "1.5e-5"
std::string small_number(double value) {
  int exponent = 0;
  for (; value < 0.9999; value *= 10) --exponent;
  return fmt::format("{:.3g}e{}", value, exponent);
}

std::string number(double value) {
  if (value > 0 && value < 0.9999e-3) return small_number(value);
  if (value >= 1e6) return fmt::format("{:g} M", value * 1e-6);
  if (value >= 1e4) return fmt::format("{:g} k", value * 1e-3);
  return fmt::format("{:g}", value);
}

std::string line(double x0, double y0, double x1, double y1, const char* kind) {
  return fmt::format("<line class=\"{}\" x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"/>", kind, x0,
                     y0, x1, y1);
}

std::string text(double x, double y, const char* anchor, const std::string& words, const char* more = "") {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>", x, y, anchor, more,
                     escaped(words));
}

std::string colored_line(double x0, double y0, double x1, double y1, const std::string& color,
                         double thickness) {
  return fmt::format(
      "<line stroke=\"{}\" stroke-width=\"{}\" x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"/>",
      color, thickness, x0, y0, x1, y1);
}

std::string dot(double x, double y, const std::string& color, const std::string& title) {
  return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\" fill=\"{}\"><title>{}</title></circle>", x,
                     y, color, escaped(title));
}

/// `kind`: of what the style has a say, "curves", "dots" or "bars".
std::string picture(const char* kind, double height, const std::string& label, const std::string& body) {
  return fmt::format(
      "<svg class=\"{}\" viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" aria-label=\"{}\">{}</svg>\n", kind,
      width, height, escaped(label), body);
}

struct Range {
  double low = 0, high = 0;
  void include(double value) {
    if (!(value > 0)) return;
    low = low > 0 ? std::min(low, value) : value;
    high = std::max(high, value);
  }
  /// With some air around it, and never empty.
  Range padded() const { return high > 0 ? Range{low / 1.25, high * 1.25} : Range{0.5, 2}; }
};

void include_marks(const Curves& curves, Range& x, Range& y) {
  for (const Series& series : curves.series)
    for (const Mark& mark : series.marks) {
      x.include(mark.x);
      for (const double value : {mark.y, mark.low, mark.high}) y.include(value);
    }
  x.include(curves.reference_x);
  y.include(curves.reference_y);
}

std::string draw_series(const Series& series, const Scale& x, const Scale& y, bool is_joined) {
  std::string body, points;
  for (const Mark& mark : series.marks) points += fmt::format("{:.1f},{:.1f} ", x(mark.x), y(mark.y));
  if (is_joined)
    body += fmt::format("<polyline fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\" points=\"{}\"/>",
                        series.color, points);
  for (const Mark& mark : series.marks) {
    if (mark.low > 0 && mark.high > mark.low)
      body += colored_line(x(mark.x), y(mark.low), x(mark.x), y(mark.high), series.color, 1.6);
    body += dot(x(mark.x), y(mark.y), series.color, mark.title);
  }
  return body;
}

/// The frame that dots and bars share: rows of some height below each other.
struct Rows {
  double left, top = 8, row_height, bottom;
  Scale x;

  Rows(const Dots& dots, double height)
      : left(left_margin(dots)),
        row_height(height),
        bottom(8 + height * double(dots.rows.size())),
        x(0, most(dots), left, width - 16, false) {}

  double middle(double row) const { return top + row_height * (row + 0.5); }

  std::string frame(const Dots& dots) const {
    std::string body;
    for (const double tick : x.ticks()) {
      body += line(x(tick), top, x(tick), bottom, "grid");
      body += text(x(tick), bottom + 16, "middle", number(tick));
    }
    for (std::size_t row = 0; row < dots.rows.size(); ++row) {
      body += line(left, top + row_height * double(row), width - 16, top + row_height * double(row), "grid");
      body += text(left - 8, middle(double(row)) + 4, "end", dots.rows[row]);
    }
    body += line(x(1), top, x(1), bottom, "one");
    return body + text((left + width - 16) / 2, bottom + 34, "middle", dots.x_label);
  }

 private:
  static double left_margin(const Dots& dots) {
    std::size_t widest = 4;
    for (const std::string& row : dots.rows) widest = std::max(widest, row.size());
    return 16 + letter * double(widest) + 4;
  }
  static double most(const Dots& dots) {
    double most = 1.1;
    for (const Series& series : dots.series)
      for (const Mark& mark : series.marks) most = std::max({most, mark.x, mark.high});
    return 1.04 * most;
  }
};

}  // namespace

std::string color_of(std::size_t index) {
  constexpr std::array<const char*, 12> colors{"#555555", "#9a9a9a", "#56b4e9", "#0072b2",
                                               "#e69f00", "#d55e00", "#009e73", "#cc79a7",
                                               "#8c6d31", "#7b4fa3", "#b5a300", "#2f6f5e"};
  return colors[index % colors.size()];
}

std::string draw(const Curves& curves) {
  constexpr double left = 62, right = width - 16, top = 10, bottom = 330;
  Range x_range, y_range;
  include_marks(curves, x_range, y_range);
  const Range xs = x_range.padded(), ys = y_range.padded();
  const Scale x(xs.low, xs.high, left, right, true), y(ys.low, ys.high, bottom, top, true);
  std::string body;
  for (const double tick : x.ticks())
    if (!curves.has_whole_x || tick == std::floor(tick))
      body +=
          line(x(tick), top, x(tick), bottom, "grid") + text(x(tick), bottom + 16, "middle", number(tick));
  for (const double tick : y.ticks())
    body += line(left, y(tick), right, y(tick), "grid") + text(left - 6, y(tick) + 4, "end", number(tick));
  if (curves.reference_y > 0) body += line(left, y(curves.reference_y), right, y(curves.reference_y), "one");
  if (curves.reference_x > 0) body += line(x(curves.reference_x), top, x(curves.reference_x), bottom, "one");
  for (const Series& series : curves.series) body += draw_series(series, x, y, curves.is_joined);
  body += text((left + right) / 2, bottom + 36, "middle", curves.x_label);
  body += text(14, (top + bottom) / 2, "middle", curves.y_label,
               fmt::format(" transform=\"rotate(-90 14 {:.0f})\"", (top + bottom) / 2).c_str());
  return picture("curves", bottom + 44, curves.y_label, body);
}

std::string draw(const Dots& dots) {
  const Rows rows(dots, 22);
  std::string body = rows.frame(dots);
  for (const Series& series : dots.series)
    for (const Mark& mark : series.marks) {
      body += colored_line(rows.x(mark.low), rows.middle(mark.y), rows.x(mark.high), rows.middle(mark.y),
                           series.color, 2);
      body += dot(rows.x(mark.x), rows.middle(mark.y), series.color, mark.title);
    }
  return picture("dots", rows.bottom + 42, dots.x_label, body);
}

std::string draw_bars(const Dots& bars) {
  constexpr double thickness = 8;
  const Rows rows(bars, thickness * double(bars.series.size()) + 12);
  std::string body = rows.frame(bars);
  for (std::size_t i = 0; i < bars.series.size(); ++i)
    for (const Mark& mark : bars.series[i].marks) {
      const double y = rows.top + rows.row_height * mark.y + 6 + thickness * double(i);
      body += fmt::format(
          "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" "
          "fill=\"{}\"><title>{}</title></rect>",
          rows.left, y, rows.x(mark.x) - rows.left, thickness - 1.5, bars.series[i].color,
          escaped(mark.title));
      const double middle = y + 0.5 * (thickness - 1.5);
      body += colored_line(rows.x(mark.low), middle, rows.x(mark.high), middle, "#111", 1.4);
    }
  return picture("bars", rows.bottom + 42, bars.x_label, body);
}

std::string draw_legend(const std::vector<Series>& series) {
  std::string body;
  for (const Series& one : series)
    body += fmt::format("<span><i style=\"background:{}\"></i>{}</span>", one.color, escaped(one.name));
  return "<p class=\"legend\">" + body + "</p>\n";
}

}  // namespace twinray::html
