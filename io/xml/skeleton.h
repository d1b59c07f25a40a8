// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <string_view>

namespace twinray {

/// An XML text without its long runs of characters between tags: of each the start and the line ends are
/// left. A parser that sees it finds the same elements, attributes and faults in the same lines. Scene files
/// are mostly such runs, lists of numbers, which are read from the file's own bytes: so the parser's copy is
/// small.
std::string xml_skeleton(std::string_view text);

}  // namespace twinray
