// SPDX-License-Identifier: Apache-2.0
// Slurm's jobs. An array job renders a part a task. A minute before its time is over the task's script is
// told by SIGUSR2; it lets the part keep what it has, and queues the task again. Slurm itself does so with a
// task whose machine failed or was wanted for others; it sends SIGTERM then, as to a task that is cancelled,
// which must not come back.
#include <fmt/format.h>

#include "cli/plan/farm_plan.h"
#include "cli/shell_text.h"

namespace twinray {
namespace {

std::string head(const FarmPlan& plan, const char* step) {
  return fmt::format(
      "#!/usr/bin/env bash\n"
      "#SBATCH --job-name={}-{}\n"
      "#SBATCH --requeue --open-mode=append\n",
      plan.name, step);
}

/// A usual Slurm takes arrays of a thousand tasks (MaxArraySize, 1001).
constexpr std::uint32_t most_array_tasks = 1000;

/// Numbers from 0 to count - 1 for the tasks of an array: one each or, where they are too many, several.
struct TaskNumbers {
  std::uint32_t count;
  std::uint32_t together = (count + most_array_tasks - 1) / most_array_tasks;

  /// The array's option and, of several numbers, what they are: $first to $last.
  std::string array() const {
    const std::string option = fmt::format("#SBATCH --array=0-{}\n", (count + together - 1) / together - 1);
    if (together == 1) return option;
    return option + fmt::format(
                        "first=$((SLURM_ARRAY_TASK_ID * {0})) last=$(((SLURM_ARRAY_TASK_ID + 1) * {0} - 1))\n"
                        "((last < {1})) || last=$(({1} - 1))\n",
                        together, count);
  }
  /// In bash's words, as render-part and as merge-parts take them.
  std::string range() const { return together == 1 ? one() : "\"$first-$last\""; }
  std::string list() const { return together == 1 ? one() : "$(seq \"$first\" \"$last\")"; }

 private:
  static std::string one() { return "\"$SLURM_ARRAY_TASK_ID\""; }
};

/// A folder's name as sbatch takes it for logs: what %% means there is %.
std::string pattern_of(const std::string& folder) {
  std::string pattern;
  for (const char c : folder) pattern += c == '%' ? std::string("%%") : std::string(1, c);
  return pattern;
}

}  // namespace

std::string slurm_render_job(const FarmPlan& plan) {
  const TaskNumbers parts{plan.task_count()};
  return head(plan, "render") + "#SBATCH --signal=B:USR2@60\n" + parts.array() +
         "export TWINRAY_THREADS=${SLURM_CPUS_PER_TASK:-}\n" +
         "is_told=no\n"
         "trap 'is_told=yes; kill -TERM \"$part\"' USR2\n"
         "trap : TERM  # Slurm sends it to the part as well.\n" +
         fmt::format("{} {} &\n", shell_text({plan.folder + "/render-part"}), parts.range()) + "part=$!\n" +
         wait_for_part() +
         "# 75: it was stopped, and its checkpoint has what was done.\n"
         "if [[ $is_told = yes && $status = 75 ]]; then scontrol requeue \"$SLURM_JOB_ID\"; fi\n"
         "exit $status\n";
}

std::string slurm_merge_job(const FarmPlan& plan) {
  const TaskNumbers frames{plan.frame_count()};
  return head(plan, "merge") + frames.array() +
         fmt::format("exec {} {}\n", shell_text({plan.folder + "/merge-parts"}), frames.list());
}

std::string slurm_submit_script(const FarmPlan& plan) {
  const std::string folder = shell_text({plan.folder});
  return fmt::format(
      "#!/usr/bin/env bash\n"
      "# Submits all parts, and what merges them. Its words are options of sbatch for the parts, such as\n"
      "# --time=30 --cpus-per-task=8 --partition=NAME.\n"
      "set -eu\n"
      "render=$(sbatch --parsable --output={1}/logs/render-%a.log \"$@\" {0}/slurm/render.sbatch)\n"
      "merge=$(sbatch --parsable --output={1}/logs/merge-%a.log --dependency=afterok:\"$render\" \\\n"
      "  {0}/slurm/merge.sbatch)\n"
      "echo \"parts: job $render; merging: job $merge; logs: \"{0}/logs\n",
      folder, shell_text({pattern_of(plan.folder)}));
}

}  // namespace twinray
