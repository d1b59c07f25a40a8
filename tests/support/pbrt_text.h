// SPDX-License-Identifier: Apache-2.0
// Scenes of pbrt's format in tests: a text, and files by name that it may include.
#pragma once
#include <map>
#include <string>

#include "core/error.h"
#include "io/pbrt/scene.h"
#include "tests/support/error_text.h"

namespace twinray::test {

using PbrtTexts = std::map<std::string, std::string>;

/// Reads a scene; other files are those given, and no others.
inline LoadedScene load_pbrt_text(const std::string& text, const LoadOptions& options = {},
                                  const PbrtTexts& files = {}) {
  return read_pbrt(text, "scene.pbrt", options, [&](const std::string& path) {
    const auto found = files.find(path);
    if (found == files.end()) throw Error(path + ": there is no such file");
    return found->second;
  });
}

/// The same with these statements behind WorldBegin.
inline LoadedScene load_pbrt_world(const std::string& statements, const PbrtTexts& files = {}) {
  return load_pbrt_text("WorldBegin\n" + statements, {}, files);
}

/// What reading them fails with; empty where it does not.
inline std::string pbrt_error(const std::string& statements) {
  return error_text([&] { load_pbrt_world(statements); });
}

/// A triangle in the plane z = 0 whose normal is +z.
inline const std::string pbrt_triangle = "Shape \"trianglemesh\" \"point3 P\" [ 0 0 0  1 0 0  0 1 0 ]\n";

}  // namespace twinray::test
