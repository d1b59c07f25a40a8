// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "bench/html_plots.h"
#include "io/html/page.h"

namespace twinray::bench {

std::string reading_section(const Results& results) {
  if (results.readings.empty()) return "";
  std::string text =
      "<h2>Reading scene files</h2>\n<p>CPU time from a file's first byte to a scene that is checked.</p>\n"
      "<div class=\"scroll\"><table>\n<tr><th>scene</th><th>MB</th><th>primitives</th><th>seconds</th>"
      "<th>MB/s</th></tr>\n";
  for (const ReadingStatistics& reading : results.readings) {
    const Quartiles q = quartiles(reading.seconds);
    text += fmt::format(
        "<tr><td>{}</td><td>{:.2f}</td><td>{}</td><td>{:.4f} <small>[{:.4f}, {:.4f}]</small></td>"
        "<td>{:.0f}</td></tr>\n",
        html::escaped(reading.scene), reading.megabytes, reading.primitives, q.median, q.low, q.high,
        reading.megabytes / q.median);
  }
  return text + "</table></div>\n";
}

}  // namespace twinray::bench
