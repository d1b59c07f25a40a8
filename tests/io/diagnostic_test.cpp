// SPDX-License-Identifier: Apache-2.0
#include "io/diagnostic.h"

#include "tests/support/catch.h"

namespace twinray {

TEST_CASE("a place counts lines and columns from one") {
  const std::string text = "first\n\tsecond x\nthird";
  const Place place = place_of("a.txt", text, text.find('x'));
  CHECK(place.line == 2);
  CHECK(place.column == 9);
  CHECK(message_at(place, "wrong") == "a.txt:2:9: wrong\n  second x\n         ^");
}

TEST_CASE("columns and carets count characters, not bytes") {
  const std::string text = "caf\xc3\xa9 x";
  CHECK(message_at(place_of("a", text, text.find('x')), "wrong") ==
        "a:1:6: wrong\n  caf\xc3\xa9 x\n       ^");
}

TEST_CASE("of a long line the part around the place is shown") {
  const std::string text = std::string(500, 'a') + "X" + std::string(500, 'b');
  CHECK(message_at(place_of("f", text, 500), "wrong") == "f:1:501: wrong\n  ..." + std::string(60, 'a') +
                                                             "X" + std::string(39, 'b') + "...\n  " +
                                                             std::string(63, ' ') + "^");
  CHECK(message_at(place_of("f", text, 1), "wrong") ==
        "f:1:2: wrong\n  " + std::string(100, 'a') + "...\n   ^");
}

TEST_CASE("bytes that a terminal would act on are shown as spaces") {
  CHECK(place_of("f", "a\x1b[2Jb", 0).excerpt == "a [2Jb");
  CHECK(place_of("f", "a\xff", 0).excerpt == "a\xc3\xbf");  // Latin-1, where it is no UTF-8.
  const Place place{.file = "f"};
  CHECK(message_at(place, "\"a\x1b[31m\xff\x07\" is none;\nvalid is b") ==
        "f: \"a [31m\xc3\xbf \" is none;\nvalid is b");
}

TEST_CASE("a place beyond the end is the end, and line ends of Windows are no part of the line") {
  CHECK(place_of("f", "abc\r\n", 3).excerpt == "abc");
  const Place end = place_of("f", "abc", 99);
  CHECK(end.column == 4);
}

TEST_CASE("the nearest name is found within a third of the letters") {
  const std::string_view known[] = {"rotate", "translate", "scale", "matrix"};
  CHECK(nearest_name("rotat", known) == "rotate");
  CHECK(nearest_name("ROTATE", known) == "rotate");
  CHECK(nearest_name("tarnslate", known) == "translate");
  CHECK(nearest_name("scael", known) == "scale");
  CHECK(nearest_name("skew", known).empty());
  CHECK(nearest_name("", known).empty());
  CHECK(nearest_name(std::string(100000, 'r'), known).empty());
}

TEST_CASE("a warning that repeats is kept once, and counted") {
  WarningList list(false);
  const auto at = [](std::size_t offset) { return [offset] { return place_of("f", "ab", offset); }; };
  list.add(at(0), "odd");
  list.add(at(1), "odd");
  list.add(at(1), "other");
  REQUIRE(list.items().size() == 2);
  CHECK(list.items()[0].text() == "f:1:1: odd (2 times)\n  ab\n  ^");
  CHECK(list.items()[1].text() == "f:1:2: other\n  ab\n   ^");
}

TEST_CASE("beyond a hundred different warnings the rest is counted") {
  WarningList list(false);
  for (int i = 0; i < 150; ++i) list.add([] { return place_of("f", "ab", 0); }, std::to_string(i));
  REQUIRE(list.items().size() == WarningList::most_kept + 1);
  CHECK(list.items()[99].message == "99");
  CHECK(list.items().back().text() ==
        "f:1:1: from here on further warnings are counted only (50 times)\n  ab\n  ^");
}

TEST_CASE("a strict list throws what would be a warning") {
  WarningList list(true);
  CHECK_THROWS_WITH(list.add([] { return place_of("f", "ab", 0); }, "odd"), "f:1:1: odd\n  ab\n  ^");
}

TEST_CASE("a long message loses its middle, and no part of a letter stays") {
  std::string letters;
  for (int i = 0; i < 1000; ++i) letters += "\xc3\xb6";  // o with two dots
  const std::string text = message_at({.file = "a.dae"}, "x" + letters + " is too long");
  CHECK(text.size() < 1100);
  CHECK(text.starts_with("a.dae: x\xc3\xb6\xc3"));
  CHECK(text.ends_with("\xb6 is too long"));
  CHECK(text.find("\xc3\xb6 ... \xc3\xb6") != std::string::npos);
}

}  // namespace twinray
