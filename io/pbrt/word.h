// SPDX-License-Identifier: Apache-2.0
// Parameters of pbrt that are one of some words.
#pragma once
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "io/diagnostic.h"
#include "io/pbrt/parameters.h"

namespace twinray {

/// A word with what it stands for.
template <typename Value>
struct PbrtWord {
  std::string_view word;
  Value value;
};

/// What a parameter's word stands for; the first one, pbrt's default, where there is no such parameter.
/// Throws Error at its place where it is none of them.
template <typename Value, std::size_t n>
Value word_of(const PbrtParameters& parameters, const char* name,
              const std::array<PbrtWord<Value>, n>& words) {
  const std::string text = parameters.text(name, std::string(words[0].word));
  std::vector<std::string_view> known;
  for (const auto& [word, value] : words) {
    if (word == text) return value;
    known.push_back(word);
  }
  parameters.find(name)->place.fail("there is no " + std::string(name) + " \"" + text + "\"; valid are " +
                                    list_names(known));
}

}  // namespace twinray
