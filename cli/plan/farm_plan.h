// SPDX-License-Identifier: Apache-2.0
// A picture, or several, in parts for many machines.
#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "cli/options/options.h"

namespace twinray {

/// Frames first to last, both included.
struct FrameRange {
  int first = 0, last = 0;
  std::uint32_t count() const { return std::uint32_t(last - first + 1); }
};

/// All that scripts need to know.
struct FarmPlan {
  std::string name;       ///< Of the job.
  std::string program;    ///< The path of twinray.
  std::string called_in;  ///< The folder that the words' paths are seen from.
  std::string folder;     ///< Of scripts, parts and logs; an absolute path.
  Words words;            ///< Of a render, without those that a part adds.
  std::string output;     ///< The picture.
  std::uint32_t samples = 1;
  bool is_by_tiles = false;  ///< Parts are ranges of tiles, not of samples,
  std::uint32_t units = 1;   ///< of so many in all,
  std::uint32_t parts = 1;   ///< for each frame: no more than units.
  /// If set, words and output have the frame's number where "%04d" or the like stands.
  std::optional<FrameRange> frames;

  std::uint32_t frame_count() const { return frames ? frames->count() : 1; }
  std::uint32_t task_count() const { return parts * frame_count(); }
};

/// Whether a word has a place for a frame's number: "%d", "%04d".
bool has_frame_number(const std::string& word);
/// The word with that number in this place.
std::string with_frame_number(const std::string& word, int frame);

/// A bash script that renders the part of a number from 0 on, and goes on with it where it was stopped; and
/// one that merges the parts of frames of such numbers, or of all.
std::string render_script(const FarmPlan& plan);
std::string merge_script(const FarmPlan& plan);
/// Bash's lines that wait for the child $part, whatever signals come meanwhile, and keep its code as $status.
std::string wait_for_part(const std::string& indent = "");
/// One command a line: all that render_script() is to be called with, in any order.
std::string command_list(const FarmPlan& plan);

/// For Slurm: an array job of all parts, a job that merges after it, and a script that submits both.
std::string slurm_render_job(const FarmPlan& plan);
std::string slurm_merge_job(const FarmPlan& plan);
std::string slurm_submit_script(const FarmPlan& plan);

/// A job template of Open Job Description, version 2023-09: JSON.
std::string open_job_template(const FarmPlan& plan);

}  // namespace twinray
