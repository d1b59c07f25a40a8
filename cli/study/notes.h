// SPDX-License-Identifier: Apache-2.0
// A student's words, from a Markdown file: cmark turns them into HTML.
#pragma once
#include <array>
#include <string>
#include <vector>

namespace twinray::study {

/// HTML for the places of a page; empty where nothing was written.
struct Notes {
  std::string head;                  ///< What stands before the first part.
  std::array<std::string, 5> parts;  ///< Part 1 is the first.
  std::string end;                   ///< What follows the parts under a heading of their level.
  std::vector<std::string> warnings;
};

/// CommonMark. A heading that begins with "Part 3" opens the section that goes to the head of part 3; it ends
/// at the next heading of its level or above. Such headings are left out, those within a section are set
/// below the page's own. Pictures of the file's folder become part of the page; HTML is left out, with a
/// warning. Throws Error for a file that cannot be read, a picture that is not there or would be loaded from
/// elsewhere, and a part that does not exist.
Notes read_notes(const std::string& path);

}  // namespace twinray::study
