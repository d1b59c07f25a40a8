// SPDX-License-Identifier: Apache-2.0
// Broken files through a reader that the sanitizers watch: an error or a warning, never more.
#include "tests/broken/broken_files.h"

#include <algorithm>
#include <set>

#include "io/camera_file.h"
#include "tests/support/catch.h"
#include "tests/support/collada_text.h"

namespace twinray::test {
namespace {

/// What reading says: the error, or the warnings one below the other; "" where it says nothing.
std::string said_of(const std::string& text) {
  try {
    std::string said;
    for (const Diagnostic& warning : load_collada(text, {.clip_as_file = true}).warnings)
      said += warning.text() + "\n";
    return said;
  } catch (const Error& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("the whole file is read without a word") {
  CHECK(said_of(whole_file()).empty());
  CHECK(load_collada(whole_file()).scene.geometry->shapes().size() == 3);
}

TEST_CASE("there are more than 300 broken files, each of its own name and text") {
  std::set<std::string> names, texts;
  for (const BrokenFile& file : broken_files()) {
    INFO(file.name);
    CHECK(names.insert(file.name).second);
    CHECK(texts.insert(file.text).second);
    CHECK(file.text != whole_file());
  }
  CHECK(names.size() >= 300);
}

TEST_CASE("a broken file gives an error or a warning that names it, and nothing else happens") {
  int tested = 0;
  for (const BrokenFile& file : broken_files()) {
    INFO(file.name);
    const std::string said = said_of(file.text);
    CHECK((!file.must_speak || !said.empty()));
    CHECK((said.empty() || said.starts_with("scene.dae:")));
    if (file.said.empty()) continue;
    ++tested;
    INFO(said);
    CHECK(said.find(file.said) != std::string::npos);
  }
  CHECK(tested >= 40);
}

TEST_CASE("a message about a broken file is short, however long its parts are") {
  for (const BrokenFile& file : broken_files()) {
    INFO(file.name);
    CHECK(said_of(file.text).size() < 100000);
  }
}

}  // namespace twinray::test
