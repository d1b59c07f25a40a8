// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <string>

#include "cli/options/options.h"
#include "cli/study/scale.h"

namespace twinray {

/// What a study command line asks for.
struct StudyArguments {
  std::string scenes;  ///< A folder.
  std::string output;  ///< A folder, made if it is not there.
  std::string notes;   ///< A Markdown file; empty: none.
  study::Scale scale = study::medium;
  int threads = 0;  ///< 0: all of the machine.
  bool quiet = false;
};

/// Adds the command's options; the function that is returned gives what they ask for, once they are read. It
/// throws UsageError with the reason where they contradict each other.
std::function<StudyArguments()> add_study_options(CLI::App& app);

/// twinray study FOLDER --output DIR [options]: renders what a write-up of the assignment shows of a folder's
/// scenes, but for what is there already, and writes one page of it. Returns the exit code: 1 where a scene
/// of the folder cannot be read, else 0, or that of a render that was ended. Throws Error.
int study_command(const StudyArguments& arguments);

}  // namespace twinray
