// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <string>

#include "io/load_options.h"
#include "io/pbrt/file.h"

namespace twinray {

/// The files that a scene file names.
class PbrtFiles {
 public:
  /// Gives the bytes of a file, unpacked; throws Error.
  using Read = std::function<std::string(const std::string& path)>;

  /// `scene` is the path of the file that is read first. Others read by `read`, if it is set; else from disk.
  explicit PbrtFiles(const std::string& scene, Read read = {}, const LoadOptions& options = {});

  /// The path of a file that is named at a place: beside the scene file, as pbrt finds it; where there is
  /// none, beside the file that names it.
  std::string path(const PbrtPlace& place, const std::string& name) const;
  /// Its bytes, unpacked where they are gzip. Throws Error with the place.
  std::string bytes(const PbrtPlace& place, const std::string& path) const;
  /// Whether files come from disk.
  bool is_disk() const { return !read_; }

 private:
  std::string scene_;
  Read read_;
  LoadOptions options_;
};

}  // namespace twinray
