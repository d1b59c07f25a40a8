// SPDX-License-Identifier: Apache-2.0
// Where the pictures of a study are: made by the code of `twinray render`, kept from run to run.
#pragma once
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "cli/study/plan.h"
#include "cli/study/record.h"

namespace twinray::study {

/// Each picture NAME has NAME.png (sRGB, what `twinray render` writes), NAME.exr (linear, for errors),
/// NAME_rate.png where sampling is adaptive, and NAME.json, its Record, which comes last.
class PictureFolder {
 public:
  /// `threads` 0: all of the machine.
  PictureFolder(std::string path, const Scale& scale, int threads);

  /// The picture's record, if it was finished by the same program with the same command and scene, and its
  /// files are as they were then.
  std::optional<Record> finished(const Picture& picture) const;

  /// Whether the picture is there by another command, program or scene.
  bool is_outdated(const Picture& picture) const;

  /// Renders and writes it all. Returns the exit code of the render: not 0 where it was ended before its
  /// time; nothing is finished then. Throws Error.
  int make(const Picture& picture) const;

  /// The path of one of the picture's files: ending ".png", ".exr", ".json" or "_rate.png".
  std::string file(const Picture& picture, const std::string& ending) const;

 private:
  /// What is known of the picture that is there; none where there is none.
  std::optional<Record> old_record(const Picture& picture) const;
  bool is_of(const Record& record, const Picture& picture) const;
  /// All words but the output.
  Words words(const Picture& picture) const;
  /// The words after "render" as a reader would type them.
  Words typed_words(const Picture& picture) const;
  std::string command(const Picture& picture) const;
  std::uint64_t scene_hash(const std::string& scene) const;
  /// Of the picture's files; none where one is missing.
  std::optional<std::uint64_t> files_hash(const Picture& picture) const;
  double count_tests(const Picture& picture) const;

  std::string path_;
  Scale scale_;
  int threads_;
  mutable std::map<std::string, std::uint64_t> scene_hashes_;
};

}  // namespace twinray::study
