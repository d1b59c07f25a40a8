// SPDX-License-Identifier: Apache-2.0
// What is remembered of a finished picture, in a file beside it: by this a study knows what it need not make
// again, and what the page says.
#pragma once
#include <cstdint>
#include <optional>
#include <string>

namespace twinray::study {

struct Record {
  std::string command;           ///< As a reader would type it.
  std::string program;           ///< Name and version.
  std::uint64_t scene_hash = 0;  ///< Of the bytes of the scene's file.
  std::uint64_t files_hash = 0;  ///< Of those of the picture's files.
  std::string engine;
  double build_seconds = 0, render_seconds = 0;  ///< Wall-clock.
  std::uint64_t rays = 0, camera_rays = 0;
  /// Primitives tested per ray, counted in a smaller picture by the same command.
  double tests_per_ray = 0;
};

double rays_per_second(const Record& record);

/// The record's text (JSON).
std::string record_text(const Record& record);

/// The record of such a text; none of any other.
std::optional<Record> parse_record(const std::string& text);

/// FNV-1a, 64 bits (Fowler, Noll and Vo, 1991).
std::uint64_t hash_of(const std::string& bytes);

}  // namespace twinray::study
