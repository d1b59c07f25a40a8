// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "bench/catalog.h"
#include "bench/trace.h"
#include "bench/whole.h"
#include "bench/write_ups.h"

namespace twinray::bench {

struct PictureOrder {
  std::string file;
  std::uint32_t samples = 16;
};

/// What the command line says.
struct Options {
  SceneChoice scenes;
  TraceOptions trace;
  int width = 288, height = 216;  ///< Of the picture whose rays are recorded.
  bool has_renders = true;
  WholeOptions whole;
  std::string json_file, csv_file, html_file;
  std::optional<PictureOrder> picture;      ///< Instead of measuring.
  std::optional<WriteUpOptions> write_ups;  ///< Instead of measuring.
  std::vector<std::string> worker;  ///< Instead of measuring: the scene and the engine of serve_renders().
};

/// Nothing where help was asked for, and printed. Throws UsageError, with what is wrong, for a command line
/// that cannot be understood. The arguments come without the program's name.
std::optional<Options> parse_options(const std::vector<std::string>& words);

}  // namespace twinray::bench
