// SPDX-License-Identifier: Apache-2.0
#include "io/xml/skeleton.h"

#include <algorithm>

#include "tests/support/catch.h"

namespace twinray {

TEST_CASE("a skeleton keeps what is no long run between tags") {
  for (const char* text : {"", "no markup", "<a b='>'>1 2 3</a>", "<!-- <a> --><a><![CDATA[</a>]]></a>",
                           "<?xml version='1.0'?>\n<a/>", "<a", "<a b='", "<!--", "<![CDATA[", "</", "<"})
    CHECK(xml_skeleton(text) == text);
}

TEST_CASE("a skeleton leaves out long runs, except for their lines") {
  const std::string run(100'000, '7'), lines(1000, '\n');
  const std::string skeleton = xml_skeleton("<a>" + run + lines + "</a>\n<b>" + run + "</b>");
  CHECK(skeleton.size() < 2000);
  CHECK(std::count(skeleton.begin(), skeleton.end(), '\n') == 1001);
  CHECK(skeleton.find("</a>\n<b>7") != std::string::npos);
  CHECK(skeleton.substr(skeleton.size() - 4) == "</b>");
}

TEST_CASE("a skeleton keeps long comments, attributes and CDATA sections whole") {
  const std::string run(100'000, '7');
  for (const std::string& text :
       {"<!--" + run + "-->", "<a b='" + run + "'/>", "<a><![CDATA[" + run + "]]></a>"})
    CHECK(xml_skeleton(text) == text);
}

}  // namespace twinray
