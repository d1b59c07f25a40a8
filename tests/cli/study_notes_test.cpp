// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "cli/study/notes.h"
#include "core/error.h"
#include "io/picture/image_file.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

namespace twinray::study {
namespace {

/// The notes of a file of this text.
Notes notes_of(const test::TemporaryFolder& folder, const std::string& text) {
  test::write_text(folder.file("notes.md"), text);
  return read_notes(folder.file("notes.md"));
}

std::string error_of(const test::TemporaryFolder& folder, const std::string& text) {
  try {
    notes_of(folder, text);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("sections of notes go to the heads of their parts") {
  const test::TemporaryFolder folder;
  const Notes notes =
      notes_of(folder,
               "# A title\nAll of it.\n\n## Part 1: Rays\nRays *meet* triangles.\n\n### Spheres\nToo.\n\n"
               "## part 3\nLight.\n\n## Afterword\nThe end.\n");
  CHECK(notes.head == "<h3>A title</h3>\n<p>All of it.</p>\n");
  CHECK(notes.parts[0] == "<p>Rays <em>meet</em> triangles.</p>\n<h3>Spheres</h3>\n<p>Too.</p>\n");
  CHECK(notes.parts[1].empty());
  CHECK(notes.parts[2] == "<p>Light.</p>\n");
  CHECK(notes.end == "<h3>Afterword</h3>\n<p>The end.</p>\n");
  CHECK(notes.warnings.empty());
}

TEST_CASE("a part may be written in two places, and another word than part is none") {
  const test::TemporaryFolder folder;
  const Notes notes =
      notes_of(folder, "# Part 2\none\n# Part 4\nfour\n# Part 2 again\ntwo\n# Partly 1\nend\n");
  CHECK(notes.parts[1] == "<p>one</p>\n<p>two</p>\n");
  CHECK(notes.parts[3] == "<p>four</p>\n");
  CHECK(notes.end == "<h3>Partly 1</h3>\n<p>end</p>\n");
}

TEST_CASE("HTML in notes is left out with a warning, and stays text where it is code") {
  const test::TemporaryFolder folder;
  const Notes notes = notes_of(folder, "# Part 1\n<script>alert(1)</script>\n\n`<b>`\n\n<!-- a remark -->\n");
  CHECK(notes.parts[0].find("<script") == std::string::npos);
  CHECK(notes.parts[0].find("<code>&lt;b&gt;</code>") != std::string::npos);
  CHECK(notes.warnings == std::vector<std::string>{fmt::format(
                              "{}:2: HTML is left out; Markdown alone is read", folder.file("notes.md"))});
}

TEST_CASE("pictures beside the notes become part of the page") {
  const test::TemporaryFolder folder;
  write_image(folder.file("my tree.png"), Image(2, 2));
  const Notes notes = notes_of(folder, "# Part 2\n![a tree](my%20tree.png)\n");
  CHECK(notes.parts[1].find("<img src=\"data:image/png;base64,iVBOR") != std::string::npos);
  CHECK(notes.parts[1].find("alt=\"a tree\"") != std::string::npos);
}

TEST_CASE("what notes cannot have is said with its line") {
  const test::TemporaryFolder folder;
  const std::string file = folder.file("notes.md");
  CHECK(error_of(folder, "text\n\n# Part 6\n") == file + ":3: there is no part 6; valid are 1 to 5");
  CHECK(error_of(folder, "# Part 0\n") == file + ":1: there is no part 0; valid are 1 to 5");
  CHECK(error_of(folder, "# Part 99999999999\n") ==
        file + ":1: there is no part 2147483647; valid are 1 to 5");
  CHECK(error_of(folder, "# Part of the work\n").empty());
  CHECK(error_of(folder, "a\n\n![b](https://example.org/b.png)\n") ==
        file +
            ":3: the page must be whole by itself, so it shows no picture of another place: "
            "https://example.org/b.png; save it beside this file and write its name");
  CHECK(error_of(folder, "![b](none.png)\n") ==
        fmt::format("{}:1: {}: there is no such picture", file, folder.file("none.png")));
  CHECK(error_of(folder, "![b](notes.md)\n") ==
        fmt::format("{0}:1: {0}: not a picture for a page; valid endings are .png, .jpg, .gif, .webp", file));
  CHECK_THROWS_WITH(read_notes(folder.file("no.md")), folder.file("no.md") + ": there is no such file");
}

}  // namespace twinray::study
