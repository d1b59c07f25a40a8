// SPDX-License-Identifier: Apache-2.0
// Slurm's jobs. An array job renders a part a task; it is told a minute before its time is over, keeps what
// it has and queues itself again. So is a task whose machine failed or was wanted for others.
#include <fmt/format.h>

#include "cli/plan/farm_plan.h"
#include "cli/shell_text.h"

namespace twinray {
namespace {

std::string head(const FarmPlan& plan, const char* step) {
  return fmt::format(
      "#!/usr/bin/env bash\n"
      "#SBATCH --job-name={}-{}\n"
      "#SBATCH --requeue --open-mode=append\n"
      "#SBATCH --output={}/logs/{}-%a.log\n",
      plan.name, step, plan.folder, step);
}

}  // namespace

std::string slurm_render_job(const FarmPlan& plan) {
  return head(plan, "render") + fmt::format("#SBATCH --array=0-{}\n", plan.task_count() - 1) +
         "#SBATCH --signal=B:TERM@60\n"
         "export TWINRAY_THREADS=${SLURM_CPUS_PER_TASK:-}\n" +
         fmt::format("{} \"$SLURM_ARRAY_TASK_ID\" &\n", shell_text({plan.folder + "/render-part"})) +
         "part=$!\n"
         "trap 'kill -TERM \"$part\"' TERM\n"
         "wait \"$part\"\n"
         "code=$?\n"
         "while kill -0 \"$part\" 2>/dev/null; do\n"
         "  wait \"$part\"\n"
         "  code=$?\n"
         "done\n"
         "# 75: it was stopped, and its checkpoint has what was done.\n"
         "((code != 75)) || scontrol requeue \"$SLURM_JOB_ID\"\n"
         "exit $code\n";
}

std::string slurm_merge_job(const FarmPlan& plan) {
  return head(plan, "merge") + fmt::format("#SBATCH --array=0-{}\n", plan.frame_count() - 1) +
         fmt::format("exec {} \"$SLURM_ARRAY_TASK_ID\"\n", shell_text({plan.folder + "/merge-parts"}));
}

std::string slurm_submit_script(const FarmPlan& plan) {
  const std::string folder = shell_text({plan.folder});
  return fmt::format(
      "#!/usr/bin/env bash\n"
      "# Submits all parts, and what merges them. Its words are options of sbatch for the parts, such as\n"
      "# --time=30 --cpus-per-task=8 --partition=NAME.\n"
      "set -eu\n"
      "render=$(sbatch --parsable \"$@\" {0}/slurm/render.sbatch)\n"
      "merge=$(sbatch --parsable --dependency=afterok:\"$render\" {0}/slurm/merge.sbatch)\n"
      "echo \"parts: job $render; merging: job $merge; logs: \"{0}/logs\n",
      folder);
}

}  // namespace twinray
