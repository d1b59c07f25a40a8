// SPDX-License-Identifier: Apache-2.0
// Plots for a page, drawn as SVG without any script.
#pragma once
#include <string>
#include <vector>

namespace twinray::html {

/// The colour of the series with that index in a report; they begin again after the twelfth.
std::string color_of(std::size_t index);

/// A measured value with the quartiles around it.
struct Mark {
  double x = 0, y = 0;
  double low = 0, high = 0;  ///< Around the value that the plot shows the spread of.
  std::string title;         ///< Shown where the pointer rests.
};

/// Marks of one colour.
struct Series {
  std::string name, color;
  std::vector<Mark> marks;
};

/// Both axes are logarithmic. Values must be > 0.
struct Curves {
  std::string x_label, y_label;
  std::vector<Series> series;
  bool is_joined = true;  ///< A line through the marks of a series, in the order of x; low and high are of y.
  double reference_y = 0;  ///< Where > 0, a dashed line across.
  double reference_x = 0;
  bool has_whole_x = false;  ///< x counts things: no ticks between them.
};
std::string draw(const Curves& curves);

/// One row for each name, in which marks of every series stand at their x, on a linear scale from 0; low and
/// high are of x, y is the row. A dashed line marks 1.
struct Dots {
  std::string x_label;
  std::vector<std::string> rows;
  std::vector<Series> series;
};
std::string draw(const Dots& dots);

/// For each row a group of bars, one a series; the marks as in Dots.
std::string draw_bars(const Dots& bars);

/// Names beside their colours.
std::string draw_legend(const std::vector<Series>& series);

}  // namespace twinray::html
