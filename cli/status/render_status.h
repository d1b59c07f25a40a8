// SPDX-License-Identifier: Apache-2.0
// How far a render is, for machines: the same numbers under the same names on all ways to them.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "cli/clock_time.h"
#include "integrators/render.h"

namespace twinray {

struct RenderStatus {
  enum class Step { loading, building, rendering, saving, done, interrupted, failed };
  Step step = Step::loading;
  std::optional<RenderProgress> progress;  ///< Once it renders.
  double elapsed_seconds = 0;              ///< Since the process began with it.
  double sampling_seconds = 0;             ///< Of this process.
  std::optional<WallTime> checkpoint;      ///< When the last one of this process was written.
};

/// As it is said: "loading", ...
const char* step_name(RenderStatus::Step step);
/// All steps, in their order.
std::vector<RenderStatus::Step> render_steps();

/// Something that is measured. Seconds and bytes are in its name; a ratio is 1 for the whole.
struct StatusNumber {
  const char* name;
  const char* description;
  std::optional<double> value;  ///< Nothing where it is not known, or not yet.
};
/// Always the same ones in the same order. CPU time and memory are those of the process at this time.
std::vector<StatusNumber> status_numbers(const RenderStatus& status);

/// Somebody to whom a render reports.
class StatusReporter {
 public:
  virtual ~StatusReporter() = default;
  /// Whether it wants to hear of the progress within a step; from one thread at a time.
  virtual bool is_due() const = 0;
  /// At each step's begin, and within one where is_due(). Throws nothing but std::bad_alloc.
  virtual void report(const RenderStatus& status) = 0;
};

}  // namespace twinray
