// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace twinray {

/// What a file cannot say of a scene, and what stands there in its place: a line for each kind.
class Losses {
 public:
  /// Counts one more. `one` is the line of a single one, "a sphere is a mesh"; `many` that of several, with
  /// "{}" for their number: "{} spheres are meshes".
  void add(const std::string& one, const std::string& many);
  /// The same in the same words, however often it is so.
  void add(const std::string& line) { add(line, line); }
  /// "OUT: 3 spheres are meshes", in the order of their first ones.
  std::vector<std::string> lines(const std::string& file) const;

 private:
  struct Kind {
    std::string one, many;
    std::size_t count = 0;
  };
  std::vector<Kind> kinds_;
};

/// "a" or, before a vowel, "an".
std::string article_of(const std::string& word);

}  // namespace twinray
