// SPDX-License-Identifier: Apache-2.0
#include "cli/render_talk.h"

#include "cli/console.h"
#include "cli/progress.h"
#include "cli/render_outputs.h"
#include "cli/statistics_report.h"

namespace twinray {

StandardTalk::StandardTalk(ProgressKind progress)
    : has_line_(progress == ProgressKind::line), line_(progress_line(has_line_)) {}

void StandardTalk::loaded(const SceneSummary& summary) {
  for (const std::string& line : summary_lines(summary)) console::print("{}\n", line);
}

void StandardTalk::note(const std::string& text) { console::print("note: {}\n", text); }

void StandardTalk::rendering() { line_ = progress_line(has_line_); }

void StandardTalk::progress(const RenderProgress& progress) {
  if (line_.is_due()) line_.show(progress_text(progress, line_.elapsed_seconds()));
}

void StandardTalk::rendered(const RenderResult&) { line_.finish(); }

void StandardTalk::stopped() { line_.finish(); }

void StandardTalk::denoised(const DenoisedPicture& picture) {
  console::print("Denoised       {:.2f} s: {}\n", picture.seconds, picture.denoiser);
}

void StandardTalk::finished(const RenderArguments& arguments, const AccelStats& accel,
                            const RenderResult& result) {
  console::print("{}{:<15}{}\n", statistics_text(arguments, accel, result), output_word(arguments.output),
                 arguments.output);
}

}  // namespace twinray
