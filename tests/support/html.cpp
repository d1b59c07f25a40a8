// SPDX-License-Identifier: Apache-2.0
#include "tests/support/html.h"

#include <set>
#include <vector>

namespace twinray::test {
namespace {

/// Elements that have no end.
const std::set<std::string> empty_elements{"meta", "br", "img", "hr", "wbr", "!DOCTYPE"};

/// The name of the tag that begins at `at`: "table", "/table".
std::string tag_name(const std::string& page, std::size_t at) {
  const std::size_t end = page.find_first_of(" \n/>", at + 2);
  return page.substr(at + 1, end - at - 1);
}

}  // namespace

std::string html_fault(const std::string& page) {
  std::vector<std::string> open;
  for (std::size_t at = page.find('<'); at != page.npos; at = page.find('<', at + 1)) {
    const std::string name = tag_name(page, at);
    const std::size_t end = page.find('>', at);
    if (end == page.npos) return "a tag without its end";
    if (name.starts_with('/')) {
      if (open.empty() || open.back() != name.substr(1)) return "<" + name + "> closes what is not open";
      open.pop_back();
    } else if (!empty_elements.contains(name) && page[end - 1] != '/') {
      open.push_back(name);
    }
  }
  return open.empty() ? "" : "<" + open.back() + "> is not closed";
}

std::string html_load(const std::string& page) {
  for (const char* loading : {"<script", "<link", "<iframe", "<object", "<base", "@import", "url("})
    if (page.find(loading) != page.npos) return loading;
  for (const std::string attribute : {" src=\"", " href=\"", " srcset=\"", " poster=\""})
    for (std::size_t at = page.find(attribute); at != page.npos; at = page.find(attribute, at + 1)) {
      const std::string value = page.substr(at + attribute.size(), 11);
      if (!value.starts_with("data:image/") && !value.starts_with('#')) return attribute + value;
    }
  return "";
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t number = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + part.size())) ++number;
  return number;
}

}  // namespace twinray::test
